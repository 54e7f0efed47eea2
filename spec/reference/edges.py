"""8.8: the edges of tets, and the points they have."""

from conventions import NONE

TET_EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))


class Edges:
    """Numbers of edges in the order in which they come."""

    def __init__(self):
        self.number = {}  # of the edge between two points
        self.ends = []  # vertices
        self.of = []  # per tet six numbers

    def add(self, cell, vertex_of):
        six = []
        for a, b in TET_EDGES:
            key = frozenset((cell[a], cell[b]))
            if key not in self.number:
                self.number[key] = len(self.ends)
                self.ends.append((vertex_of[cell[a]], vertex_of[cell[b]]))
            six.append(self.number[key])
        self.of.append(six)


def edges_of(block, walk):
    """Those of the mesh; none where they have no points."""
    edges = Edges()
    if not block.edge_points:
        return edges
    point_of = []
    vertex_of = [v for v, copied in enumerate(walk.copy_of) if copied == NONE]
    number = {v: p for p, v in enumerate(vertex_of)}
    for v, copied in enumerate(walk.copy_of):
        point_of.append(number[v] if copied == NONE else point_of[copied])
    for c in range(walk.cell_count):
        cell = [point_of[v] for v in walk.vertex[4 * c : 4 * c + 4]]
        if walk.flipped[c]:
            cell[2], cell[3] = cell[3], cell[2]
        edges.add(cell, vertex_of)
    return edges


def move_edges(nodes, permutation):
    """The mid-edge nodes of a tet whose new corner i is old corner permutation[i]."""
    result = [None] * 6
    for (a, b), node in zip(TET_EDGES, nodes):
        ends = {permutation[a], permutation[b]}
        result[next(k for k, edge in enumerate(TET_EDGES) if set(edge) == ends)] = node
    return result
