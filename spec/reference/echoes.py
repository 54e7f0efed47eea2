"""8.5.1: echoes, and the index of the vertices by their values."""

import math

from conventions import MASK64, NONE, clamp, scale, width

MOST_LOOKED_AT = 12


def slots(block):
    """H"""
    least = max(16, min(block.vertices + block.unused_points, 2**24))
    return 1 << (least - 1).bit_length()


def cube(x):
    return math.floor(clamp(x, -(2.0**60), 2.0**60))


class Echoes:
    def __init__(self, block, head, positions):
        self.positions = positions
        self.echoes = head.echoes  # (mirrored, offset) each
        self.side = scale(1.0, head.cube_bits)
        self.inverse = scale(1.0, -head.cube_bits)
        self.looks_far = head.looks_far
        self.has_minus_zero = head.has_minus_zero
        self.H = slots(block)
        self.index = {}
        self.last = 0
        self.history = 0
        self.without = 0

    def slot(self, x, y, z):
        mixed = (
            (x * 0x9E3779B97F4A7C15 & MASK64)
            ^ (y * 0xC2B2AE3D27D4EB4F & MASK64)
            ^ (z * 0x165667B19E3779F9 & MASK64)
        )
        return (mixed >> 32) % self.H

    def enter(self, v):
        q = self.positions.value[v]
        slot = self.slot(*(cube(x * self.inverse) for x in q))
        self.index.setdefault(slot, []).append(v)

    def nearest(self, p):
        """The vertex, NONE if there is none, and d."""
        rho = 1.0 if self.looks_far else 0.5
        d = self.side * rho
        found = NONE
        s = [x * self.inverse for x in p]
        low = [cube(x - rho) for x in s]
        high = [min(cube(x + rho), low[axis] + 2) for axis, x in enumerate(s)]
        for z in range(low[2], high[2] + 1):
            for y in range(low[1], high[1] + 1):
                for x in range(low[0], high[0] + 1):
                    for v in self.index.get(self.slot(x, y, z), ())[: -MOST_LOOKED_AT - 1 : -1]:
                        q = self.positions.value[v]
                        sum = abs(q[0] - p[0]) + abs(q[1] - p[1]) + abs(q[2] - p[2])
                        if sum < d:
                            d = sum
                            found = v
        return found, d

    def look_for(self, v, guess):
        """1, 2: (vertex, d, e), or None if there is no echo for vertex v."""
        best = None

        def look(e):
            nonlocal best
            mirrored, offset = self.echoes[e]
            p = [
                float(offset[k]) - guess[k] if mirrored >> k & 1 else guess[k] - float(offset[k])
                for k in range(3)
            ]
            found, d = self.nearest(p)
            if found != NONE and (best is None or d < best[1]):
                best = found, d, e

        look(self.last)
        if not (best and self.history == 7 and best[1] < self.side / 4):
            for e in range(len(self.echoes)):
                if e != self.last and (self.without < 8 or e == v % len(self.echoes)):
                    look(e)
        return best

    def read(self, v, guess):
        """8.4 step 3: (vertex, e) if vertex v is echoed, otherwise None."""
        best = self.look_for(v, guess)
        echoed = False
        if best:
            found, d, e = best
            echoed = self.positions.flag("echo", width(math.trunc(d)), self.history)
            self.history = (self.history * 2 + echoed) % 8
            if echoed:
                self.last = e
        self.without = 0 if echoed else self.without + 1
        return (found, e) if echoed else None

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
