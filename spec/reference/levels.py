"""8.5.3: levels, known and shared ones."""

import math

from conventions import MASK64, NONE, scale, width
from echoes import slots
from guesses import NUMBER

MOST_LOOKED_AT = 12


class Level:
    def __init__(self, x, vertex):
        self.x = x
        self.vertex = vertex  # the first that had it
        self.count = 1


class KnownLevels:
    """The values that vertices have had, per axis."""

    def __init__(self, block, bits):
        self.side = scale(1.0, bits)
        self.inverse = scale(1.0, -bits)
        self.H = slots(block)
        self.places_left = block.vertices + block.unused_points  # of all axes together
        self.lists = [{}, {}, {}]

    def list(self, axis, interval):
        slot = ((interval * 0x9E3779B97F4A7C15 & MASK64) >> 32) % self.H
        return self.lists[axis].setdefault(slot, [])

    def newest(self, axis, interval):
        return self.list(axis, interval)[: -MOST_LOOKED_AT - 1 : -1]

    def nearest(self, axis, x):
        """1: the level, None if there is none, and d."""
        d = self.side * 0.5
        found = None
        first = math.floor(x * self.inverse - 0.5)
        for interval in (first, first + 1):
            for level in self.newest(axis, interval):
                if abs(level.x - x) < d:
                    d = abs(level.x - x)
                    found = level
        return found, d

    def enter(self, v, value):
        for axis, x in enumerate(value):
            interval = math.floor(x * self.inverse)
            level = next((a for a in self.newest(axis, interval) if a.x == x), None)
            if level:
                level.count += 1
            elif self.places_left > 0:
                self.places_left -= 1
                self.list(axis, interval).append(Level(x, v))


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
