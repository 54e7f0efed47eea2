"""8.5.1: echoes, and the index of the vertices by their values."""

import math

from conventions import MASK64, NONE, clamp, scale, width
from ties import Ties

MOST_LOOKED_AT = 24
TIES_LOOKED_AT = 8


def distance(p, q):
    return abs(q[0] - p[0]) + abs(q[1] - p[1]) + abs(q[2] - p[2])


def slots(block):
    """H"""
    least = max(16, min(block.vertices + block.unused_points, 2**24))
    return 1 << (least - 1).bit_length()


class Cubes:
    """A grid of cubes and its slots; a side has 2^shift halves of a small side."""

    def __init__(self, shift, slots):
        self.shift = shift
        self.slots = slots
        self.index = {}

    def slot(self, x, y, z):
        mixed = (
            (x * 0x9E3779B97F4A7C15 & MASK64)
            ^ (y * 0xC2B2AE3D27D4EB4F & MASK64)
            ^ (z * 0x165667B19E3779F9 & MASK64)
        )
        return (mixed >> 32) % self.slots

    def enter(self, v, half):
        self.index.setdefault(self.slot(*(h >> self.shift for h in half)), []).append(v)

    def about(self, half):
        """The slots of the cubes about a point, with their vertices in the order of their numbers."""
        low = [(h - (1 << self.shift - 1)) >> self.shift for h in half]
        for z in (low[2], low[2] + 1):
            for y in (low[1], low[1] + 1):
                for x in (low[0], low[0] + 1):
                    yield self.index.get(self.slot(x, y, z), ())


class Echoes:
    def __init__(self, block, head, positions):
        self.positions = positions
        self.echoes = head.echoes  # (mirrored, offset) each
        self.side = scale(1.0, head.cube_bits)
        self.halves = scale(1.0, 4 - head.cube_bits)
        self.has_minus_zero = head.has_minus_zero
        H = slots(block)
        self.small = Cubes(1, H)
        self.large = Cubes(4, H // 4)
        self.last = 0
        self.history = 0
        self.without = 0
        self.partner = {}  # per vertex that is echoed: (vertex, e)
        self.taken = set()
        self.ties = Ties()

    def half(self, x):
        return math.floor(clamp(x * self.halves, -(2.0**60), 2.0**60))

    def enter(self, v):
        half = [self.half(x) for x in self.positions.value[v]]
        self.small.enter(v, half)
        self.large.enter(v, half)

    def nearest(self, p):
        """The vertex, NONE if there is none, and d."""
        half = [self.half(x) for x in p]
        if not any(self.large.about(half)):
            return NONE, math.inf
        found, d = self.nearest_in(self.small, half, p, self.side / 16)
        if found == NONE:
            found, d = self.nearest_in(self.large, half, p, self.side / 2)
        return found, d

    def nearest_in(self, cubes, half, p, d):
        found = NONE
        for vertices in cubes.about(half):
            for v in vertices[: -MOST_LOOKED_AT - 1 : -1]:
                at = distance(p, self.positions.value[v])
                if at < d:
                    d = at
                    found = v
        return found, d

    def back(self, e, guess):
        """Where the guess would come from."""
        mirrored, offset = self.echoes[e]
        return [
            float(offset[k]) - guess[k] if mirrored >> k & 1 else guess[k] - float(offset[k]) for k in range(3)
        ]

    def tied(self, guess, neighbours):
        """1: (vertex, d, e, times), or None."""
        partners = [self.partner[n] for n in neighbours if n in self.partner]
        if not partners:
            return None
        e = partners[0][1]
        partners = [u for u, echo in partners if echo == e]
        p = self.back(e, guess)
        best = None
        firsts = []
        for i, partner in enumerate(partners):
            for w in self.ties.latest(partner, TIES_LOOKED_AT):
                if w in self.taken or w in partners:
                    continue
                times = 1
                if i == 0:
                    firsts.append(w)
                else:
                    times += firsts.count(w)
                d = distance(p, self.positions.value[w])
                if best is None or (-times, d) < (-best[3], best[1]):
                    best = w, d, e, times
        return best

    def find(self, v, guess, neighbours):
        """1 - 3: (vertex, d, e, times), or None if there is no echo for vertex v."""
        tied = self.tied(guess, neighbours)
        if tied and tied[1] < self.side / 4:
            return tied
        placed = self.look_by_place(v, guess)
        if tied and not (placed and placed[1] < tied[1] / 8):
            return tied
        return placed and (*placed, 0)

    def pair(self, v, echo, neighbours):
        """After each vertex that is neither a copy nor of the configuration `edge`."""
        if echo:
            self.partner[v] = echo
            self.taken.add(echo[0])
        for n in neighbours:
            self.ties.tie(v, n)

    def look_by_place(self, v, guess):
        """2: (vertex, d, e), or None."""
        stride = 1 if self.without < 64 else 2 if self.without < 256 else 8
        if v % stride:
            return None
        t = v // stride
        best = None

        def look(e):
            nonlocal best
            found, d = self.nearest(self.back(e, guess))
            if found != NONE and (best is None or d < best[1]):
                best = found, d, e

        look(self.last)
        if not (best and best[1] < self.side / (4 if self.history % 2 else 16)):
            for e in range(len(self.echoes)):
                if e != self.last and (self.without < 8 or e == t % len(self.echoes)):
                    look(e)
        return best

    def read(self, v, guess, neighbours):
        """8.4 step 3: (vertex, e) if vertex v is echoed, otherwise None."""
        best = self.find(v, guess, neighbours)
        echoed = False
        if best:
            found, d, e, times = best
            echoed = self.positions.flag("echo", width(math.trunc(d)), self.history, times)
            self.history = (self.history * 2 + echoed) % 8
            if echoed:
                self.last = e
        self.without = 0 if echoed else self.without + 1
        return (found, e) if echoed else None

    def stays(self, e):
        """8.4 step 7: whether echo e tells of the very place."""
        mirrored, offset = self.echoes[e]
        return mirrored == 0 and not any(offset)

    def mirror(self, x):
        return 0.0 if x == 0 and not self.has_minus_zero else -x

    def says(self, found, e, axis, M):
        """4: whole part, value and coordinate."""
        mirrored, offset = self.echoes[e]
        mirrored = mirrored >> axis & 1
        offset = offset[axis]
        x = self.positions.value[found][axis]
        whole = clamp(offset - math.trunc(x) if mirrored else offset + math.trunc(x), -M, M)
        if offset != 0:
            value = float(offset) - x if mirrored else float(offset) + x
            return whole, value, None
        coordinate = self.positions.coordinate[found][axis]
        if not mirrored:
            return whole, x, coordinate
        if self.positions.keeps_coordinates:
            coordinate = self.mirror(coordinate)
        return whole, self.mirror(x), coordinate
