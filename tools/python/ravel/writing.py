"""Meshes to files."""

import os
import tempfile
from ctypes import addressof, byref, c_void_p, sizeof
from typing import NamedTuple

import numpy as np

from . import library as lib
from .mesh import CellBlock, Companion


class Written(NamedTuple):
    """What came of it. The order of points and cells changes unless `keep_order` was asked for."""

    bytes: bytes
    new_point: np.ndarray  # where each point is in the file
    new_cell: np.ndarray  # where each cell is, blocks of cells one after the other
    position_bound: float
    position_error: float
    new_companion: np.ndarray  # where each companion is, blocks one after the other
    attribute_bounds: np.ndarray  # the largest error of each attribute; 0 where it is exact


def write(path, points, cells, point_data=None, cell_data=None, **options):
    """Packs a mesh into a file; options as `dumps` has them. The file appears whole or not at all."""
    written = dumps(points, cells, point_data, cell_data, **options)
    if not isinstance(path, (str, os.PathLike)):
        path.write(written.bytes)
        return written
    folder = os.path.dirname(os.path.abspath(path))
    handle, temporary = tempfile.mkstemp(prefix=".ravel-", dir=folder)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(written.bytes)
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(temporary, 0o666 & ~mask)
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise
    return written


def dumps(points, cells, point_data=None, cell_data=None, *, corner_data=None, companions=(), companion_data=None,
          mesh_data=None, tag_names=(), notes=(), position_bits=None, max_error=None, max_error_relative=None, lattice=None,
          attribute_bounds=None, float32=False, keep_order=False, strip_budget=None, level=None, fast=False,
          threads=0):
    """Packs a mesh.

    cells: blocks (type, data) as in meshio, {type: data}, or ("polygon", (begin, corners)) for polygons of
    any degree; all triangles, quads and polygons, or all tets. cell_data has one array per block. Positions
    are exact unless one of position_bits (1..30 along the longest side), max_error, max_error_relative (in
    diagonals of the bounding box) and lattice (a power of two, alike for every mesh) is given. Data are exact, too,
    but for floats that attribute_bounds names: {name: {"bits": 12}}, or max_error, max_error_relative, octahedral.
    `threads` may work at a time, 0: as many as the machine can run; the bytes are the same.
    """
    kind, corners, begin, counts = _cells_of(cells)
    pack = lib.library()
    mesh = pack.ravel_mesh_new(kind)
    if not mesh:
        raise MemoryError
    packed = c_void_p()
    try:
        points = np.asarray(points)
        if points.ndim != 2 or points.shape[1] not in (2, 3):
            raise ValueError("points have three coordinates each")
        if points.dtype not in (np.float32, np.float64):
            points = points.astype(np.float64)
        if points.shape[1] == 2:
            points = np.column_stack([points, np.zeros(len(points), points.dtype)])
        _set(mesh, lib.POSITIONS, points)
        _set(mesh, lib.CORNERS, corners)
        if kind == 0:
            _set(mesh, lib.CORNER_BEGIN, begin)
        for companion in companions:
            _add_companion(mesh, Companion(*companion))
        blocks = [len(companion[1]) for companion in companions]
        for name, values in (point_data or {}).items():
            _add_attribute(mesh, name, "point", values)
        for name, values in (corner_data or {}).items():
            _add_attribute(mesh, name, "corner", values)
        for name, values in (cell_data or {}).items():
            _add_attribute(mesh, name, "cell", _joined(values, counts, name))
        for name, values in (companion_data or {}).items():
            _add_attribute(mesh, name, "companion", _joined(values, blocks, name))
        for name, values in (mesh_data or {}).items():
            _add_attribute(mesh, name, "mesh", values)
        for attribute, dimension, value, name in tag_names:
            lib.call("ravel_mesh_add_tag_name", mesh, _text(attribute), dimension, value, _text(name))
        for key, text in notes:
            lib.call("ravel_mesh_add_note", mesh, _text(key), _text(text))
        options = lib.EncodeOptions()
        pack.ravel_encode_options_init(byref(options), sizeof(options))
        options.position_bits, options.max_error = position_bits or 0, max_error or 0
        options.max_error_relative, options.lattice = max_error_relative or 0, lattice or 0
        options.float32, options.keep_order, options.fast = float32, keep_order, fast
        if threads < 0:
            raise ValueError("threads are 1 or more, or 0 for as many as the machine can run")
        options.threads = threads
        if strip_budget is not None:
            options.strip_budget = strip_budget
        if level is not None:
            options.level = level
        bounds = [_bound(name, bound) for name, bound in (attribute_bounds or {}).items()]
        bounds = (lib.AttributeBound * len(bounds))(*bounds)
        options.attribute_bounds, options.attribute_bound_count = addressof(bounds), len(bounds)
        lib.call("ravel_encode", mesh, byref(options), byref(packed))
        return Written(_outcome(packed, 0).tobytes(), _outcome(packed, 1).view(np.int64), _outcome(packed, 2).view(np.int64),
                       pack.ravel_packed_bound(packed), pack.ravel_packed_error(packed),
                       _outcome(packed, 4).view(np.int64), _outcome(packed, 6))
    finally:
        pack.ravel_packed_free(packed)
        pack.ravel_mesh_free(mesh)


_DEGREES = {"triangle": 3, "quad": 4, "tetra": 4}


def _cells_of(cells):
    """0 or 1 for polygons or tets, corners, offsets, cells of each block."""
    if isinstance(cells, dict):
        cells = list(cells.items())
    elif isinstance(cells, tuple) and len(cells) == 2 and isinstance(cells[0], str):
        cells = [cells]
    blocks = [CellBlock(*block) if isinstance(block, (tuple, list)) else CellBlock(block.type, block.data) for block in cells]
    for block in blocks:
        if block.type not in ("triangle", "quad", "polygon", "tetra"):
            raise ValueError(f'cells of type "{block.type}" are no cells of Ravel; give them as companions')
    tets = [block.type == "tetra" for block in blocks]
    if any(tets) and not all(tets):
        raise ValueError("a mesh has polygons or tets, not both; give the polygons as companions")
    corners, degrees, counts = [np.empty(0, np.int64)], [np.empty(0, np.int64)], []
    for kind, data in blocks:
        if kind == "polygon" and isinstance(data, tuple):
            begin = np.asarray(data[0], np.int64)
            corners.append(np.asarray(data[1], np.int64).reshape(-1))
            degrees.append(np.diff(begin))
        else:
            rows = np.asarray(data, np.int64)
            if rows.ndim != 2 or (kind in _DEGREES and rows.shape[1] != _DEGREES[kind] and rows.size):
                raise ValueError(f'cells of type "{kind}" are rows of {_DEGREES.get(kind, "their")} points')
            corners.append(rows.reshape(-1))
            degrees.append(np.full(len(rows), rows.shape[1], np.int64))
        counts.append(len(degrees[-1]))
    flat = np.concatenate(corners)
    if any(tets):
        return 1, flat.reshape(-1, 4), None, counts
    return 0, flat, np.concatenate([[0], np.cumsum(np.concatenate(degrees))]).astype(np.int64), counts


def _joined(values, counts, name):
    if isinstance(values, np.ndarray) and len(counts) <= 1:
        values = [values]
    if len(values) != len(counts) or any(len(part) != count for part, count in zip(values, counts)):
        raise ValueError(f'"{name}" must have one array per block, with one row per cell')
    return np.concatenate([np.asarray(part) for part in values]) if len(values) else np.empty(0)


def _bound(name, bound):
    if len(bound) != 1:
        raise ValueError(f"{name}: one bound, of {', '.join(lib.BOUND_KINDS)}")
    kind, value = next(iter(bound.items()))
    return lib.AttributeBound(_text(name), value, lib.BOUND_KINDS.index(kind), 0)


def _text(text):
    return text.encode("utf-8", "surrogateescape")


def _set(mesh, part, array):
    view, alive = lib.view_of(array)
    lib.call("ravel_mesh_set", mesh, part, byref(view))
    del alive


def _add_companion(mesh, companion):
    nodes, alive = lib.view_of(np.asarray(companion.data, np.int64))
    hosts = also = None
    if companion.hosts is not None:
        hosts, also = lib.view_of(np.asarray(companion.hosts, np.int64))
    lib.call("ravel_mesh_add_companion", mesh, companion.vtk_type, byref(nodes), byref(hosts) if hosts else None)
    del alive, also


def _add_attribute(mesh, name, place, values):
    values = np.asarray(values)
    if values.dtype == bool:
        values = values.astype(np.uint8)
    view, alive = lib.view_of(values)
    lib.call("ravel_mesh_add_attribute", mesh, _text(name), lib.PLACES.index(place), byref(view), None)
    del alive


def _outcome(packed, which):
    view = lib.Array()
    lib.call("ravel_packed_array", packed, which, byref(view))
    return lib.copy_of(view)
