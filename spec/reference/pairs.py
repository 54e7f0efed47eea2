"""8.5.3: pairs, levels beside the value on the axis before."""

import math
import struct

from conventions import MASK64, NONE, scale

PLACES = 5


class Pair:
    def __init__(self, x=math.inf, vertex=NONE):
        self.x = x
        self.vertex = vertex


class PairsOfLevels:
    """The values that vertices have had on axes 1 and 2, by those on the axes before."""

    def __init__(self, block, bits):
        self.inverse = scale(1.0, -bits)
        self.N = 1 << (min(max((block.vertices + block.unused_points) // 4, 16), 1 << 21) - 1).bit_length()
        self.lists = {1: {}, 2: {}}

    def list(self, axis, beside, interval):
        """The list of an interval on an axis, beside the value on the axis before."""
        (bits,) = struct.unpack("<Q", struct.pack("<d", beside if beside != 0 else 0.0))
        key = bits * 0xC2B2AE3D27D4EB4F & MASK64
        key ^= key >> 29
        number = (((interval & MASK64 ^ key) * 0x9E3779B97F4A7C15 & MASK64) >> 32) % self.N
        return self.lists[axis].setdefault(number, [Pair() for _ in range(PLACES)])

    def enter(self, v, value):
        for axis in (1, 2):
            x = value[axis]
            places = self.list(axis, value[axis - 1], math.floor(x * self.inverse))
            j = next((j for j in range(PLACES - 1) if places[j].x == x), PLACES - 1)
            vertex = places[j].vertex if places[j].x == x else v
            del places[j]
            places.insert(0, Pair(x, vertex))
