"""10.1: what is around a facet once the walk is done; chapters 10, 11 and 13 ask for it."""

import struct

from conventions import NONE, cross, dot, minus

OUTWARD = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))
MOST_TURNS = 23


def flatness(m, n):
    d = dot(m, n)
    q = dot(m, m) * dot(n, n)
    if not d > 0:
        return 1
    r = d * d
    return 6 if r > 0.9999 * q else 5 if r > 0.99 * q else 4 if r > 0.9 * q else 3 if r > 0.5 * q else 2


class Shape:
    def __init__(self, head, block, walk, mesh):
        self.tets = head.tets
        self.block = block
        self.walk = walk
        self.mesh = mesh
        self.cells = block.cells
        self.vertex = walk.vertex
        self.twin = walk.twin
        self.first = walk.first
        self.cell_of = walk.cell_of
        number = struct.Struct("<d" if head.wide else "<f")
        raw = struct.Struct("<Q" if head.wide else "<I")
        # places are doubles, those of f32 widened
        self.place = [tuple(number.unpack(raw.pack(x))[0] for x in p) for p in mesh.points]
        self.walk_corner = self.corners_of_mesh()
        self.element_of = [0] * len(self.walk_corner)
        for e, c in enumerate(self.walk_corner):
            self.element_of[c] = e

    def corners_of_mesh(self):
        """9.1: the walk's corner that each corner of the mesh is."""
        corners = []
        for c in range(self.cells):
            own = list(range(self.first[c], self.first[c + 1]))
            if self.walk.flipped[c]:
                if self.tets:
                    own[2], own[3] = own[3], own[2]
                else:
                    own[1:] = own[:0:-1]
            corners += own
        return corners

    def degree(self, cell):
        return self.first[cell + 1] - self.first[cell]

    def corners(self, cell):
        return range(self.first[cell], self.first[cell + 1])

    def succ(self, f):
        cell = self.cell_of[f]
        return f + 1 if f + 1 < self.first[cell + 1] else self.first[cell]

    def pred(self, f):
        cell = self.cell_of[f]
        return f - 1 if f > self.first[cell] else self.first[cell + 1] - 1

    def point(self, corner):
        return self.mesh.point_of[self.vertex[corner]]

    def at(self, corner):
        return self.place[self.point(corner)]

    def outward(self, f):
        """The corners of facet f of a tet."""
        return tuple((f & ~3) + i for i in OUTWARD[f & 3])

    def normal(self, f):
        if self.tets:
            a, b, c = self.outward(f)
        else:
            a, b, c = f, self.succ(f), self.succ(self.succ(f))
        return cross(minus(self.at(b), self.at(a)), minus(self.at(c), self.at(a)))

    def turn(self, f, i, enters=lambda cell: True):
        """The facets about the edge of f that corner i lacks."""
        c = self.cell_of[f]
        behind = self.vertex[f]
        g = i
        yield g
        for _ in range(MOST_TURNS):
            a = self.twin[g]
            if a == NONE or self.cell_of[a] == c or not enters(self.cell_of[a]):
                return
            g = next((j for j in self.corners(self.cell_of[a]) if self.vertex[j] == behind), None)
            if g is None:
                return
            behind = self.vertex[a]
            yield g

    def turns(self, f, enters=lambda cell: True):
        for i in self.corners(self.cell_of[f]):
            if i != f:
                yield self.turn(f, i, enters)

    def is_earlier(self, f):
        return self.twin[f] == NONE or self.twin[f] > f

    def points_on_border(self):
        """The points on facets without twin."""
        points = set()
        for f in range(len(self.vertex)):
            if self.twin[f] == NONE:
                corners = self.outward(f) if self.tets else (f, self.succ(f))
                points.update(self.point(c) for c in corners)
        return points
