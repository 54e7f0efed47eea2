"""`.ravel` as a format of meshio."""

import meshio
import numpy as np
from meshio._vtk_common import vtk_to_meshio_type

from .library import RavelError
from .reading import read as read_ravel
from .writing import write as write_ravel

_TETS = ("tetra", "tetra10")
_POLYGONS = ("triangle", "quad", "polygon")
_EDGE_NODES = 24
_VTK = {name: number for number, name in vtk_to_meshio_type.items()}


def register():
    meshio.register_format("ravel", [".ravel"], read, {"ravel": write})


def _blank(like, count):
    """Values for cells that have none: NaN, or 0."""
    return np.full((count,) + like.shape[1:], np.nan if like.dtype.kind == "f" else 0, like.dtype)


def read(path):
    try:
        mesh = read_ravel(path)
    except RavelError as error:
        raise meshio.ReadError(str(error)) from error
    # Pieces: block or companion, its type, its nodes, and which of its cells.
    pieces = []
    quadratic = [c for c in mesh.companions if c.vtk_type == _EDGE_NODES and c.hosts is not None]
    for number, (kind, data) in enumerate(mesh.cells):
        edges = np.full((len(data), 6), -1, np.int64)
        if kind == "tetra":
            for companion in quadratic:
                edges[companion.hosts] = companion.data
        whole = edges.min(axis=1, initial=0) >= 0 if len(data) else np.zeros(0, bool)
        for chosen, name, nodes in ((~whole, kind, data), (whole, "tetra10", np.hstack([data, edges]) if whole.any() else data)):
            if chosen.any():
                pieces.append(("cell", number, name, nodes[chosen], np.flatnonzero(chosen)))
    for number, companion in enumerate(mesh.companions):
        if companion.hosts is None and companion.vtk_type in vtk_to_meshio_type and companion.data.size:
            pieces.append(("companion", number, vtk_to_meshio_type[companion.vtk_type], companion.data,
                           np.arange(len(companion.data))))
    cell_data = {}
    for name in list(mesh.cell_data) + [name for name in mesh.companion_data if name not in mesh.cell_data]:
        sources = {"cell": mesh.cell_data.get(name), "companion": mesh.companion_data.get(name)}
        like = next(array for source in sources.values() if source for array in source)
        cell_data[name] = [_blank(like, len(nodes)) if not sources[place] else sources[place][number][rows]
                           for place, number, _, nodes, rows in pieces]
    # meshio's names are per dimension and of no attribute.
    own = 3 if any(kind == "tetra" for kind, _ in mesh.cells) else 2
    field_data = {name: np.array([value, dimension if dimension >= 0 else own]) for _, dimension, value, name in mesh.tag_names}
    return meshio.Mesh(mesh.points, [(name, nodes) for _, _, name, nodes, _ in pieces], dict(mesh.point_data), cell_data,
                       field_data=field_data)


def write(path, mesh, **options):
    """Options as ravel.write has them: position_bits, max_error, keep_order, ..."""
    main = _TETS if any(block.type in _TETS for block in mesh.cells) else _POLYGONS
    cells, companions, chosen, others, first = [], [], [], [], 0
    for number, block in enumerate(mesh.cells):
        data = np.asarray(block.data)
        if block.type in main:
            cells.append(("tetra", data[:, :4]) if block.type == "tetra10" else (block.type, data))
            if block.type == "tetra10":
                companions.append((_EDGE_NODES, data[:, 4:], np.arange(first, first + len(data))))
                others.append(None)
            first += len(data)
            chosen.append(number)
        elif block.type in _VTK:
            companions.append((_VTK[block.type], data))
            others.append(number)
        else:
            raise meshio.WriteError(f'.ravel files hold no cells of type "{block.type}"')
    # The edge nodes' rows have no data of their own.
    companion_data = {}
    for name, parts in mesh.cell_data.items():
        if any(number is not None for number in others):
            companion_data[name] = [_blank(np.asarray(parts[0]), len(companion[1])) if number is None else np.asarray(parts[number])
                                    for companion, number in zip(companions, others)]
    cell_data = {name: [np.asarray(parts[number]) for number in chosen] for name, parts in mesh.cell_data.items()} if chosen else {}
    integers = [name for name, parts in cell_data.items() if all(part.dtype.kind in "iu" and part.ndim == 1 for part in parts)]
    tagged = "gmsh:physical" if "gmsh:physical" in integers or not integers else integers[0]
    tags = [(tagged, int(dimension), int(value), name) for name, (value, dimension) in
            ((name, np.asarray(pair).reshape(-1)[:2]) for name, pair in mesh.field_data.items() if np.size(pair) == 2)]
    try:
        return write_ravel(path, mesh.points, cells, mesh.point_data, cell_data, companions=companions,
                           companion_data=companion_data, tag_names=tags, **options)
    except (RavelError, ValueError) as error:
        raise meshio.WriteError(str(error)) from error
