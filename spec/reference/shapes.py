"""7.9: gates of one shape."""

import math

from conventions import MASK64, NONE, dot, minus, plus

MOST_LOOKED_AT = 64
MASK32 = 2**32 - 1


def leader_places(block):
    """L"""
    least = max(64, min(block.vertices, 65536))
    return 1 << (least - 1).bit_length()


class Leader:
    """What is known of the gates of one shape."""

    def __init__(self, shape=0):
        self.corner = NONE
        self.apex = NONE
        self.missed = 0
        self.shape = shape


class Gate:
    """One gate whose apex is asked for: `corners` are corners 0, 1, 2 of the new tet."""

    def __init__(self, shapes, gate, corners):
        self.shapes = shapes
        self.gate = gate
        self.corners = corners
        walk = shapes.walk
        # 1; min takes the first of equal ones
        first = min(range(3), key=lambda i: walk.place(corners[i]))
        self.c = corners[first]
        others = (corners[(first + 1) % 3], corners[(first + 2) % 3], walk.vertex[gate])
        # 2, 3
        self.leader = shapes.leader(self.shape(others))
        # what a `led` stencil has besides those of `tet`
        self.led = [self.c, self.leader.corner, self.leader.apex]

    def shape(self, others):
        walk = self.shapes.walk
        inverse = 1 / float(walk.block.shape_step)
        place = walk.place(self.c)
        shape = 0
        for v in others:
            for a, b in zip(walk.place(v), place):
                shape ^= math.floor((a - b) * inverse + 0.5) & MASK64
                shape = shape * 0x9E3779B97F4A7C15 & MASK64
                shape ^= shape >> 32
        return shape

    def nearest(self):
        """4: u; NONE if there is none."""
        walk = self.shapes.walk
        way = minus(walk.place(self.leader.apex), walk.place(self.leader.corner))
        there = plus(walk.place(self.c), way)
        reach = float(walk.block.grid_side) / 2
        found = []
        for v in walk.grid.in_box(there, reach, MOST_LOOKED_AT):
            w = minus(walk.place(v), there)
            square = dot(w, w)
            if v not in self.corners and square < reach * reach:
                found.append((square, v))
        return min(found)[1] if found else NONE

    def read(self):
        """4: the kind, and the vertex unless it is fresh; None if the apex is not told."""
        walk, shapes, leader = self.shapes.walk, self.shapes, self.leader
        if leader.apex == NONE:
            return None
        u = self.nearest()
        told = walk.flag("kLed", leader.missed % 8, shapes.missed % 4, u == NONE)
        leader.missed = (2 * leader.missed + (not told)) & MASK32
        shapes.missed = (2 * shapes.missed + (not told)) & MASK32
        if not told:
            return None
        if u == NONE:
            return "fresh", NONE
        is_fold = any(walk.apex_across(self.gate, e) == u for e in range(3))
        return ("fold" if is_fold else "old"), u

    def lead(self, apex):
        """5: the next gate of this shape has this one as its leader."""
        self.leader.corner = self.c
        self.leader.apex = apex


class Shapes:
    def __init__(self, walk):
        self.walk = walk
        self.L = leader_places(walk.block)
        self.leaders = {}  # by their places in the table
        self.missed = 0

    def leader(self, shape):
        """3"""
        place = shape % self.L
        leader = self.leaders.get(place) or Leader()
        if leader.shape != shape:
            leader = Leader(shape)
        self.leaders[place] = leader
        return leader
