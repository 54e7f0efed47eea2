"""The mesh as NumPy users have it: blocks of cells of one type, as in meshio."""

from dataclasses import dataclass, field
from typing import Dict, List, NamedTuple, Optional, Tuple

import numpy as np


class CellBlock(NamedTuple):
    """Cells of one type: "triangle", "quad", "polygon" (any other number of corners) or "tetra"."""

    type: str
    data: np.ndarray  # (cells, corners), numbers of points


class Companion(NamedTuple):
    """Cells that ride along: boundary triangles, lines, edge nodes of quadratic tets (vtk_type 24, with
    the tet of each in `hosts`)."""

    vtk_type: int
    data: np.ndarray
    hosts: Optional[np.ndarray] = None


class Strip(NamedTuple):
    """One entry per cell, in the order of the strip's first visits. Cells are numbers in the file's order
    (see Mesh.numbers); facet f of a polygon is its side from corner f to f + 1, facet f of a tet lies
    opposite corner f."""

    cell: np.ndarray
    came_from: np.ndarray  # the cell before, -1 where a component starts
    exit: np.ndarray  # facet of came_from
    entry: np.ndarray  # facet of cell
    link: np.ndarray  # True where the step splits both cells once the strip is materialised


@dataclass
class Mesh:
    points: np.ndarray
    cells: List[CellBlock]
    point_data: Dict[str, np.ndarray] = field(default_factory=dict)
    cell_data: Dict[str, List[np.ndarray]] = field(default_factory=dict)  # one array per block of cells
    corner_data: Dict[str, np.ndarray] = field(default_factory=dict)  # corners in the file's order of cells
    companions: List[Companion] = field(default_factory=list)
    companion_data: Dict[str, List[np.ndarray]] = field(default_factory=dict)  # one array per companion
    mesh_data: Dict[str, np.ndarray] = field(default_factory=dict)
    tag_names: List[Tuple[str, int, int, str]] = field(default_factory=list)  # attribute, dimension, value, name
    notes: List[Tuple[str, str]] = field(default_factory=list)
    strip: Optional[Strip] = None
    numbers: List[np.ndarray] = field(default_factory=list)  # of the cells of each block, in the file's order

    @property
    def cells_dict(self):
        return {block.type: np.concatenate([b.data for b in self.cells if b.type == block.type])
                for block in self.cells if block.type != "polygon"}


def blocks_of_polygons(begin, corners):
    """Polygons by their number of corners, in the order in which the first of each comes."""
    degrees = np.diff(begin)
    kinds, first = np.unique(degrees, return_index=True)
    blocks, numbers = [], []
    for degree in kinds[np.argsort(first)]:
        cells = np.flatnonzero(degrees == degree)
        rows = corners[begin[cells][:, None] + np.arange(degree)]
        blocks.append(CellBlock({3: "triangle", 4: "quad"}.get(int(degree), "polygon"), rows))
        numbers.append(cells)
    return blocks, numbers
