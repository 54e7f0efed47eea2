"""13.4: the old mesh."""

import itertools

from beside import NO_TUPLE
from companions import QUADRATIC_TET
from container import CELL, COMPANION, CORNER, MESH, POINT
from edges import move_edges
from order import PERMUTATIONS


def moved(values, old):
    result = [None] * len(values)
    for x, i in zip(values, old):
        result[i] = x
    return result


def restore(order):
    """The old mesh, in place."""
    mesh = order.mesh
    old_point, old_cell = order.old_point, order.old_cell
    # where each corner of the new mesh was: old cells follow each other by their degrees
    degree = [len(cell) for cell in mesh.cells]
    old_first = list(itertools.accumulate(moved(degree, old_cell), initial=0))
    old_element = []
    for c in range(len(mesh.cells)):
        old_element += [old_first[old_cell[c]] + order.old_corner(c, i) for i in range(degree[c])]
    old_companion = []
    for b, own in zip(mesh.companions, order.old_companion):
        old_companion += [len(old_companion) + i for i in own]
    old_of = {POINT: old_point, CORNER: old_element, CELL: old_cell, COMPANION: old_companion}
    # attributes
    for a, old_tuple in zip(mesh.attributes, order.old_tuple):
        for r in a.references:
            refer(a, r, old_cell if r.to_cells else old_point)
        if a.place == MESH:
            continue
        if not a.pooled:
            a.values = moved(a.values, old_of[a.place])
            continue
        if old_tuple is not None:
            a.values = moved(a.values, old_tuple)
            a.indices = [t if t == NO_TUPLE else old_tuple[t] for t in a.indices]
        a.indices = moved(a.indices, old_of[a.place])
    # companions
    for b, own, turns in zip(mesh.companions, order.old_companion, order.companion_turns):
        cells = []
        for i, cell in enumerate(b.cells):
            cell = [old_point[p] for p in cell]
            if b.vtk_type == QUADRATIC_TET and b.nodes_per_cell == 6 and b.hosts:
                cell = move_edges(cell, PERMUTATIONS[order.turns[b.hosts[i]]])
            cells.append([cell[(k - turns[i]) % len(cell)] for k in range(len(cell))])
        b.cells = moved(cells, own)
        if b.hosts:
            b.hosts = moved([old_cell[h] for h in b.hosts], own)
    # cells and points
    mesh.cells = moved([[old_point[p] for p in order.old_corners(c)] for c in range(len(mesh.cells))], old_cell)
    mesh.points = moved(mesh.points, old_point)


def refer(a, r, old):
    for t, value in enumerate(a.values):
        n = (value[r.component] - r.base) % 2**64
        if n < len(old):
            new = list(value)
            new[r.component] = old[n] + r.base
            a.values[t] = tuple(new)
