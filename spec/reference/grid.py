"""7.6: the grid of the vertices on the front, and `search` of 7.4."""

import math

from conventions import dot, minus

LEVELS = 5


class Grid:
    def __init__(self, block):
        self.side = float(block.grid_side)
        self.count = block.grid_count
        self.cubes = {}

    def step(self, x, axis):
        i = x * (1 / self.side)
        m = float(self.count[axis] - 1)
        if not i > 0:
            return 0
        return int(i) if i < m else int(m)

    def keys(self, place):
        cube = [self.step(place[axis], axis) for axis in range(3)]
        return [(l, cube[0] >> l, cube[1] >> l, cube[2] >> l) for l in range(LEVELS)]

    def insert(self, v, place):
        for key in self.keys(place):
            self.cubes.setdefault(key, []).insert(0, v)

    def remove(self, v, place):
        for key in self.keys(place):
            self.cubes[key].remove(v)

    def search(self, spheres, h, place, corners):
        """Yields the vertex and the height of all that are found."""
        centre = spheres.centre_at(h)
        radius = spheres.radius_at(h)
        square = radius * radius * 1.000001
        # 1
        l = 0
        reach = 1.5 * self.side
        while l < LEVELS - 1 and radius > reach:
            l += 1
            reach = reach * 2
        # 2
        low = [self.step(centre[axis] - radius, axis) >> l for axis in range(3)]
        high = [self.step(centre[axis] + radius, axis) >> l for axis in range(3)]
        if math.prod(high[axis] - low[axis] + 1 for axis in range(3)) > 512:
            return
        # 3
        looked = 0
        for z in range(low[2], high[2] + 1):
            for y in range(low[1], high[1] + 1):
                for x in range(low[0], high[0] + 1):
                    for v in self.cubes.get((l, x, y, z), ()):
                        looked += 1
                        if looked > 1500:
                            return
                        way = minus(place(v), centre)
                        if dot(way, way) > square:
                            continue
                        height = spheres.height(place(v))
                        if height is not None and height <= h and v not in corners:
                            yield v, height
