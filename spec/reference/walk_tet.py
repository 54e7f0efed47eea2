"""Chapter 7: the walk over tets."""

import math

from apex import Apex
from border_signs import BorderSigns
from conventions import NONE
from errors import require
from grid import Grid
from shapes import Gate, Shapes
from walk import BORDER, GONE, OPEN, Walk

OUTWARD = ((1, 2, 3), (2, 0, 3), (0, 1, 3), (0, 2, 1))


class TetWalk(Walk):
    """Edge (f, e) has the number 3 * f + e in `mate` and `fan`."""

    def __init__(self, head, block, stream, positions):
        super().__init__(head, block, stream, positions)
        self.mate = []
        self.fan = []
        self.open_count = []
        self.grid = Grid(block)
        self.open_facets = {}  # by their vertices, for 7.7
        self.places = []
        self.shapes = Shapes(self) if block.shape_step > 0 and not block.by_folds else None

    # 7.1

    def add_vertex(self):
        self.open_count.append(0)

    def place(self, v):
        """5.3"""
        while len(self.places) <= v:
            self.places.append(self.compute_place(len(self.places)))
        return self.places[v]

    def compute_place(self, v):
        value = self.positions.value[v]
        if not self.lossless:
            return value
        place = []
        for axis in range(3):
            y = (value[axis] - self.positions.place_origin[axis]) * self.positions.place_scale
            place.append(float(math.floor(min(y, 2.0**20) + 0.5)) if y > 0 else 0.0)
        return tuple(place)

    def corners_of(self, f):
        """The corners that the vertices of `triple` are at."""
        base = f & ~3
        return [base + i for i in OUTWARD[f & 3]]

    def triple(self, f):
        return tuple(self.vertex[c] for c in self.corners_of(f))

    def pair(self, s, t, n):
        self.mate[s] = t
        self.mate[t] = s
        self.fan[s] = self.fan[t] = min(n, 255)

    def across(self, f, e):
        return self.mate[3 * f + e] // 3

    def apex_across(self, f, e):
        t = self.mate[3 * f + e]
        return self.triple(t // 3)[t % 3]

    def opened(self, f):
        self.open_facets[tuple(sorted(self.triple(f)))] = f
        for v in self.triple(f):
            if self.open_count[v] == 0:
                self.grid.insert(v, self.place(v))
            self.open_count[v] += 1

    def closed(self, f):
        del self.open_facets[tuple(sorted(self.triple(f)))]
        for v in self.triple(f):
            self.open_count[v] -= 1
            if self.open_count[v] == 0:
                self.grid.remove(v, self.place(v))

    # 7.2

    def visit(self, gate):
        base = self.add_facets(4)
        self.mate += [NONE] * 12
        self.fan += [0] * 12

        def pair(i, e, j, d, n):
            self.pair(3 * (base + i) + e, 3 * (base + j) + d, n)

        if gate == NONE:
            for i in range(4):
                k = self.vertex_count
                self.new_vertex(base + i, "seed", [k - j for j in (1, 2, 3) if k - j >= 0], variant=min(i, 2))
            for k in range(3):
                pair(k, 0, (k + 1) % 3, 1, 1)
            pair(3, 0, 0, 2, 1)
            pair(3, 1, 2, 2, 1)
            pair(3, 2, 1, 2, 1)
            self.join_seed(base)
            return
        # 1
        corners = self.triple(gate)
        self.vertex[base : base + 3] = corners
        # 2
        shape = Gate(self.shapes, gate, corners) if self.shapes else None
        told = shape.read() if shape else None
        kind, apex = told or self.read_apex(gate, corners)
        if kind == "fresh":
            stencil = [*corners, self.vertex[gate], *(self.apex_across(gate, e) for e in range(3))]
            if told:
                self.new_vertex(base + 3, "led", stencil + shape.led)
            else:
                borders = [e for e in range(3) if self.state[self.across(gate, e)] == BORDER]
                self.new_vertex(base + 3, "tet", stencil, borders)
        else:
            require(apex < self.vertex_count and apex not in corners, "apex that is a corner of the gate")
            self.vertex[base + 3] = apex
        if shape:
            shape.lead(base)
        # 3
        self.closed(gate)
        self.state[gate] = GONE
        self.twin[gate] = base + 3
        self.twin[base + 3] = gate
        # 4
        m = [self.mate[3 * gate + k] for k in range(3)]
        n = [self.fan[3 * gate + k] for k in range(3)]
        for k in range(3):
            if m[k] // 3 == gate:
                pair(k, 2, m[k] % 3, 2, n[k] + 2)
            else:
                self.pair(3 * (base + k) + 2, m[k], n[k] + 1)
        # 5
        for k in range(3):
            pair(k, 0, (k + 1) % 3, 1, 1)
        # 6
        self.join_cell(base, kind)

    def read_apex(self, gate, corners):
        return Apex(self, gate, corners).read()

    def join_seed(self, base):
        for i in range(4):
            self.make_front(base + i, "fresh")

    def join_cell(self, base, kind):
        for i in range(3):
            self.make_front(base + i, kind)

    # 7.7

    def make_front(self, f, kind):
        # 1
        if kind != "fresh":
            g = self.open_facets.get(tuple(sorted(self.triple(f))))
            if g is not None:
                if self.flag("kGlue", 1 if kind == "fold" else 0):
                    self.twin[f] = g
                    self.twin[g] = f
                    self.closed(g)
                    self.state[g] = GONE
                    self.glue(f, g)
                else:
                    self.become_border(f)
                return
        # 2
        if self.block.has_border and self.read_border(f):
            self.become_border(f)
            return
        # 3
        self.state[f] = OPEN
        self.opened(f)

    def read_border(self, f):
        signs = BorderSigns(self, f)
        g = self.shapes.like.get(f, NONE) if self.shapes else NONE
        if g != NONE:
            return self.flag("kLedBorder", self.state[g] == BORDER, signs.around(), signs.valley(), signs.behind)
        return self.flag(
            "kBorder", signs.around(), signs.valley(), signs.behind, 3 * signs.depth() + signs.length())

    def become_border(self, f):
        self.state[f] = BORDER
        for v in self.triple(f):
            self.on_border[v] = 1

    def glue(self, f, g):
        for e in range(3):
            s = 3 * f + e
            t = 3 * g + self.triple(g).index(self.triple(f)[e])
            x = self.mate[s]
            y = self.mate[t]
            if x != t and y != s:
                self.pair(x, y, self.fan[s] + self.fan[t])

    # 7.8

    def exit(self, cell):
        facets = [f for f in range(4 * cell, 4 * cell + 4) if self.state[f] == OPEN]
        return min(facets, key=self.order_of_exit, default=NONE)

    def order_of_exit(self, f):
        borders = sum(self.state[self.across(f, e)] == BORDER for e in range(3))
        return -borders, sum(self.open_count[v] for v in self.triple(f)), self.vertex[f]
