"""8.5.3: levels, known and shared ones."""

import math

from conventions import MASK64, NONE, scale, width
from guesses import NUMBER

PLACES = 8


class Level:
    x = math.inf
    vertex = NONE  # by which it came into the list
    count = 0
    last = 0


class List:
    def __init__(self):
        self.places = [Level() for _ in range(PLACES)]
        self.turn = 0


class KnownLevels:
    """The values that vertices have had, per axis."""

    def __init__(self, block, bits):
        self.side = scale(1.0, bits)
        self.inverse = scale(1.0, -bits)
        self.N = 1 << (min(max((block.vertices + block.unused_points) // 16, 16), 1 << 20) - 1).bit_length()
        self.lists = [{}, {}, {}]

    def list(self, axis, interval):
        slot = ((interval * 0x9E3779B97F4A7C15 & MASK64) >> 32) % self.N
        return self.lists[axis].setdefault(slot, List())

    def nearest(self, axis, x):
        """1: the level, None if there is none, and d."""
        d = self.side * 0.5
        found = None

        def look(interval):
            nonlocal d, found
            level = min(self.list(axis, interval).places, key=lambda a: abs(a.x - x))
            if abs(level.x - x) < d:
                d = abs(level.x - x)
                found = level

        at = x * self.inverse
        interval = math.floor(at)
        behind = at - interval
        look(interval)
        if behind < 0.5:
            if d > behind * self.side:
                look(interval - 1)
        elif d > (1 - behind) * self.side:
            look(interval + 1)
        return found, d

    def enter(self, v, value):
        for axis, x in enumerate(value):
            of = self.list(axis, math.floor(x * self.inverse))
            level = next((a for a in of.places if a.x == x), None)
            if level is None:
                level = min(of.places, key=lambda a: a.last)
                level.x, level.vertex, level.count = x, v, 0
            level.count += 1
            of.turn += 1
            level.last = of.turn


class Levels:
    def __init__(self, block, head, positions):
        self.positions = positions
        self.known = KnownLevels(block, head.level_bits) if head.level_bits > 0 else None
        self.before = [False] * 3
        self.history = [0, 0, 0]

    def enter(self, v):
        """A vertex that has its values, copies too."""
        if self.known:
            self.known.enter(v, self.positions.value[v])

    def read(self, configuration, stencil, axis, w):
        """The vertex whose value on the axis this vertex has; None if there is none."""
        there = [p for p in stencil[:7] if p != NONE]
        values = [self.positions.value[p][axis] for p in there]
        known = None
        if self.known:
            known, d = self.known.nearest(axis, float(w))
            if known and self.is_known(axis, known, d, values):
                return known.vertex
        return self.read_shared(configuration, axis, w, there, values, known)

    def is_known(self, axis, level, d, values):
        """2"""
        votes = sum(x == level.x for x in values)
        state = 4 * self.before[axis] + min(votes, 3)
        answer = self.positions.flag(
            "known", width(math.trunc(d)), width(level.count) - 1, state, len(values) > 4)
        self.before[axis] = answer
        return answer

    def read_shared(self, configuration, axis, w, there, values, known):
        """`known` is the level that was asked for before, None if there was none."""
        most = 0
        level = None
        for i, x in enumerate(values):
            votes = 1 + values[i + 1 :].count(x)
            if votes > most:
                most = votes
                level = i
        if most < 2 or (known and known.x == values[level]):
            return None
        g = w == math.trunc(values[level])
        h = self.history[axis]
        same = self.positions.flag("level", NUMBER[configuration], most, h, g)
        self.history[axis] = (h * 2 + same) % 4
        return there[level] if same else None
