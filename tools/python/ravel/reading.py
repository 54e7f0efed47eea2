"""Files to meshes."""

import os
from ctypes import byref, c_void_p, sizeof
from typing import NamedTuple

import numpy as np

from . import library as lib
from .mesh import CellBlock, Companion, Mesh, Strip, blocks_of_polygons


class Info(NamedTuple):
    """What a file holds, by its heads alone."""

    kind: str  # "polygon" or "tet"
    points: int
    cells: int
    components: int
    links: int
    keeps_order: bool
    exact_positions: bool
    position_bound: float
    position_error: float
    file_bytes: int


def _bytes_of(source):
    if isinstance(source, (str, os.PathLike)):
        with open(source, "rb") as file:
            return file.read()
    return source.read()


def info(source):
    """Reads the heads of a file (a path or a binary stream), unpacks nothing."""
    data = _bytes_of(source)
    summary = lib.Summary()
    lib.library().ravel_summary_init(byref(summary), sizeof(summary))
    lib.call("ravel_inspect", data, len(data), byref(summary))
    return Info(("polygon", "tet")[summary.kind], summary.points, summary.cells, summary.components, summary.links,
                bool(summary.keeps_order), bool(summary.exact_positions), summary.position_bound, summary.position_error,
                summary.file_bytes)


def read(source, *, strip=False, memory_limit=None):
    """Reads a file: a path or a binary stream. `strip` asks how the strip runs over the cells;
    `memory_limit` is in bytes. Raises RavelError for what is no whole .ravel file."""
    return loads(_bytes_of(source), strip=strip, memory_limit=memory_limit)


def loads(data, *, strip=False, memory_limit=None):
    """The same, from bytes."""
    data = bytes(data)
    options = lib.DecodeOptions()
    lib.library().ravel_decode_options_init(byref(options), sizeof(options))
    options.strip = strip
    if memory_limit is not None:
        options.memory_limit = memory_limit
    handle = c_void_p()
    lib.call("ravel_decode", data, len(data), byref(options), byref(handle))
    try:
        return _mesh_of(handle, strip)
    finally:
        lib.library().ravel_mesh_free(handle)


def _array(handle, part, which=0):
    view = lib.Array()
    lib.call("ravel_mesh_array", handle, part, which, byref(view))
    return lib.copy_of(view)


def _indices(handle, part, which=0):
    # No index (all bits set) becomes -1.
    return _array(handle, part, which).view(np.int64)


def _expanded(values, index):
    """A value per element of a pool; NaN, or 0 for integers, where an element has none."""
    result = np.zeros((len(index),) + values.shape[1:], values.dtype)
    if values.dtype.kind == "f":
        result[:] = np.nan
    has = index >= 0
    result[has] = values[index[has]]
    return result


def _mesh_of(handle, with_strip):
    summary = lib.Summary()
    lib.library().ravel_summary_init(byref(summary), sizeof(summary))
    lib.call("ravel_mesh_summary", handle, byref(summary))
    corners = _indices(handle, lib.CORNERS)
    if summary.kind == 1:
        blocks, numbers = [CellBlock("tetra", corners.reshape(-1, 4))], [np.arange(summary.cells)]
    else:
        begin = _indices(handle, lib.CORNER_BEGIN)
        blocks, numbers = blocks_of_polygons(begin, corners) if len(begin) else ([], [])
    mesh = Mesh(_array(handle, lib.POSITIONS), blocks, numbers=numbers)
    for number in range(summary.companion_blocks):
        companion = lib.Companion()
        lib.call("ravel_mesh_companion", handle, number, byref(companion))
        nodes = _indices(handle, lib.COMPANION_NODES, number).reshape(companion.cells, companion.nodes_per_cell)
        hosts = _indices(handle, lib.COMPANION_HOSTS, number) if companion.has_hosts else None
        mesh.companions.append(Companion(companion.vtk_type, nodes, hosts))
    for number in range(summary.attributes):
        _add_attribute(handle, number, mesh)
    library = lib.library()
    for number in range(library.ravel_mesh_tag_names(handle)):
        tag = lib.TagName()
        lib.call("ravel_mesh_tag_name", handle, number, byref(tag))
        mesh.tag_names.append((str(tag.attribute), tag.dimension, tag.value, str(tag.name)))
    for number in range(library.ravel_mesh_notes(handle)):
        note = lib.Note()
        lib.call("ravel_mesh_note", handle, number, byref(note))
        mesh.notes.append((str(note.key), str(note.text)))
    if with_strip:
        mesh.strip = Strip(_indices(handle, lib.STRIP_CELL), _indices(handle, lib.STRIP_FROM), _array(handle, lib.STRIP_EXIT),
                           _array(handle, lib.STRIP_ENTRY), _array(handle, lib.STRIP_LINK).astype(bool))
    return mesh


def _add_attribute(handle, number, mesh):
    attribute = lib.Attribute()
    lib.call("ravel_mesh_attribute", handle, number, byref(attribute))
    name, place = str(attribute.name), lib.PLACES[attribute.place]
    values = _array(handle, lib.ATTRIBUTE_VALUES, number)
    if attribute.is_pool:
        values = _expanded(values, _indices(handle, lib.ATTRIBUTE_INDEX, number))
    table = {"point": mesh.point_data, "corner": mesh.corner_data, "cell": mesh.cell_data,
             "companion": mesh.companion_data, "mesh": mesh.mesh_data}[place]
    # Names need not differ in a file; here they must.
    unique, count = name, 2
    while unique in table:
        unique, count = f"{name} ({count})", count + 1
    if place == "cell":
        table[unique] = [values[cells] for cells in mesh.numbers]
    elif place == "companion":
        ends = np.cumsum([len(companion.data) for companion in mesh.companions], dtype=np.int64)
        table[unique] = np.split(values, ends[:-1]) if len(ends) else []
    else:
        table[unique] = values
