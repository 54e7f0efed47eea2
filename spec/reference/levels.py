"""8.5.3: levels: by pairs, known ones and shared ones."""

import math

from conventions import MASK64, NONE, scale, width
from guesses import NUMBER
from pairs import PairsOfLevels

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


def nearest(x, bits, levels_of):
    """1: the level nearest to x, None if there is none, its place and d; `levels_of` has the list of an interval."""
    side = scale(1.0, bits)
    d = side * 0.5
    found = found_at = None

    def look(interval):
        nonlocal d, found, found_at
        for place, level in enumerate(levels_of(interval)):
            if abs(level.x - x) < d:
                d = abs(level.x - x)
                found, found_at = level, place

    at = x * scale(1.0, -bits)
    interval = math.floor(at)
    behind = at - interval
    look(interval)
    if behind < 0.5:
        if d > behind * side:
            look(interval - 1)
    elif d > (1 - behind) * side:
        look(interval + 1)
    return found, found_at, d


class KnownLevels:
    """The values that vertices have had, per axis."""

    def __init__(self, block, bits):
        self.inverse = scale(1.0, -bits)
        self.N = 1 << (min(max((block.vertices + block.unused_points) // 16, 16), 1 << 20) - 1).bit_length()
        self.lists = [{}, {}, {}]

    def list(self, axis, interval):
        slot = ((interval * 0x9E3779B97F4A7C15 & MASK64) >> 32) % self.N
        return self.lists[axis].setdefault(slot, List())

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
        self.bits = head.level_bits
        self.pairs = PairsOfLevels(block, self.bits) if head.has_pairs else None
        self.known = KnownLevels(block, self.bits) if self.bits > 0 else None
        # the last answers on each axis
        self.before_pair = [False] * 3
        self.before_known = [False] * 3
        self.history = [0, 0, 0]

    def enter(self, v, stays):
        """A vertex that has its values; `stays`: a copy, or one that stays (8.4 step 7)."""
        value = self.positions.value[v]
        if self.pairs and not stays:
            self.pairs.enter(v, value)
        if self.known and not stays:
            self.known.enter(v, value)

    def read(self, configuration, stencil, axis, w, beside):
        """The vertex whose value on the axis this vertex has; None if there is none.

        `beside`: the value of the vertex on the axis before; None if it is not known.
        """
        there = [p for p in stencil[:7] if p != NONE]
        values = [self.positions.value[p][axis] for p in there]
        found = []  # the values of levels that were found
        if self.pairs and beside is not None:
            pair, place, d = nearest(float(w), self.bits, lambda i: self.pairs.list(axis, beside, i))
            if pair:
                votes = values.count(pair.x)
                if self.ask("pair", self.before_pair, axis, d, min(place, 3), votes, len(values)):
                    return pair.vertex
                found.append(pair.x)
        if self.known:
            known, _, d = nearest(float(w), self.bits, lambda i: self.known.list(axis, i).places)
            if known and known.x not in found:
                votes = values.count(known.x)
                if self.ask("known", self.before_known, axis, d, width(known.count) - 1, votes, len(values)):
                    return known.vertex
                found.append(known.x)
        return self.read_shared(configuration, axis, w, there, values, found)

    def ask(self, name, before, axis, d, second, votes, n):
        """2: the answer under `pair` or `known`."""
        state = 4 * before[axis] + min(votes, 3)
        before[axis] = self.positions.flag(name, width(math.trunc(d)), second, state, n > 4)
        return before[axis]

    def read_shared(self, configuration, axis, w, there, values, found):
        """`found`: the values of the pair and of the known level, of those that were found."""
        most = 0
        level = None
        for i, x in enumerate(values):
            votes = 1 + values[i + 1 :].count(x)
            if votes > most:
                most = votes
                level = i
        if most < 2 or values[level] in found:
            return None
        g = w == math.trunc(values[level])
        h = self.history[axis]
        same = self.positions.flag("level", NUMBER[configuration], most, h, g)
        self.history[axis] = (h * 2 + same) % 4
        return there[level] if same else None
