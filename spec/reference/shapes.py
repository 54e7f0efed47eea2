"""7.9: leaders, by the shapes of gates and from cell to cell."""

import math

from carried import carried
from conventions import MASK64, NONE, dot, minus

MOST_LOOKED_AT = 64
MASK32 = 2**32 - 1


def places_for_gates(block):
    """P"""
    least = max(64, min(block.vertices, 65536))
    return 1 << (least - 1).bit_length()


class Place:
    """What is known of the gates of one shape."""

    def __init__(self, shape=0):
        self.facet = NONE
        self.corner = [0, 0, 0]
        self.missed = 0
        self.shape = shape


class Gate:
    """One gate whose apex is asked for: `corners` are the vertices at corners 0, 1, 2 of the new tet."""

    def __init__(self, shapes, gate, corners):
        self.shapes = shapes
        self.walk = walk = shapes.walk
        self.gate = gate
        self.corners = corners
        self.told = False
        # 1: s, and c, d, e in order; min takes the first of equal ones
        s = walk.corners_of(gate)
        c = min(range(3), key=lambda i: walk.place(corners[i]))
        order = (c, (c + 1) % 3, (c + 2) % 3)
        # 2, 3
        self.slot = shapes.slot(self.shape([corners[i] for i in order]))
        self.L = self.slot.facet
        counterparts = [NONE] * 3
        for i, corner in zip(order, self.slot.corner):
            counterparts[i] = corner
        self.slot.facet = gate
        self.slot.corner = [s[i] for i in order]
        # 4
        g = shapes.like.get(gate, NONE)
        self.goes_on = g != NONE and walk.twin[g] != NONE
        if self.goes_on:
            self.L = g
            counterparts = [shapes.like[corner] for corner in s]
        # 5: what a `led` stencil has besides those of `tet`
        if self.L != NONE:
            l = [walk.vertex[corner] for corner in counterparts]
            self.led = [*l, walk.vertex[self.L], walk.vertex[walk.twin[self.L]]]

    def shape(self, corners):
        """2: of the vertices at corners c, d, e."""
        walk = self.walk
        inverse = 1 / float(walk.block.shape_step)
        place = walk.place(corners[0])
        shape = 0
        for v in (*corners[1:], walk.vertex[self.gate]):
            for a, b in zip(walk.place(v), place):
                shape ^= math.floor((a - b) * inverse + 0.5) & MASK64
                shape = shape * 0x9E3779B97F4A7C15 & MASK64
                shape ^= shape >> 32
        return shape

    def read(self):
        """5 - 7: the kind, and the vertex unless it is fresh; None if the apex is not told."""
        if self.L == NONE:
            return None
        walk, shapes = self.walk, self.shapes
        a = [walk.place(v) for v in self.led[:4]]
        b = [walk.place(v) for v in (*self.corners, walk.vertex[self.gate])]
        u = self.nearest(carried(walk.place(self.led[4]), a, b, walk.block.leaders_move))
        misses = 8 + shapes.missed_on % 8 if self.goes_on else self.slot.missed % 8
        self.told = walk.flag("kLed", misses, shapes.missed_all % 4, u == NONE, self.mismatch(a, b))
        shapes.missed_all = self.with_answer(shapes.missed_all)
        if self.goes_on:
            shapes.missed_on = self.with_answer(shapes.missed_on)
        else:
            self.slot.missed = self.with_answer(self.slot.missed)
        if not self.told:
            return None
        if u == NONE:
            return "fresh", NONE
        is_fold = any(walk.apex_across(self.gate, e) == u for e in range(3))
        return ("fold" if is_fold else "old"), u

    def with_answer(self, missed):
        return (2 * missed + (not self.told)) & MASK32

    def mismatch(self, a, b):
        """6"""
        ways = [minus(minus(b[i], b[0]), minus(a[i], a[0])) for i in (1, 2, 3)]
        D = max(dot(w, w) for w in ways)
        side = float(self.walk.block.grid_side)
        G = side * side
        return 0 if D <= 12 else 1 if D < G / 256 else 2 if D < G / 16 else 3

    def nearest(self, there):
        """7: u; NONE if there is none."""
        walk = self.walk
        reach = float(walk.block.grid_side) / 2
        found = []
        for v in walk.grid.in_box(there, reach, MOST_LOOKED_AT):
            w = minus(walk.place(v), there)
            square = dot(w, w)
            if v not in self.corners and square < reach * reach:
                found.append((square, v))
        return min(found)[1] if found else NONE

    def lead(self, base):
        """8: what the corners of the new tet, from `base` on, are like."""
        if not self.told:
            return
        walk, like = self.walk, self.shapes.like
        beyond = walk.twin[self.L]
        like[base + 3] = beyond
        first = beyond & ~3
        for i in range(3):
            like[base + i] = first + walk.vertex[first : first + 4].index(self.led[i])


class Shapes:
    def __init__(self, walk):
        self.walk = walk
        self.P = places_for_gates(walk.block)
        self.slots = {}  # by their numbers in the table
        self.like = {}  # corners that are like one
        self.missed_all = 0
        self.missed_on = 0

    def slot(self, shape):
        """3: the place of the shape."""
        number = shape % self.P
        place = self.slots.get(number) or Place()
        if place.shape != shape:
            place = Place(shape)
        self.slots[number] = place
        return place
