"""7.6: the grid of the vertices on the front, and what 7.4 and 7.9 search in it."""

import math

MOST_BLOCKS = 512
MOST_LOOKED_AT = 256


class Grid:
    def __init__(self, block):
        self.side = float(block.grid_side)
        self.unit = self.side * self.side  # 7.5, 7.7
        self.count = block.grid_count
        self.cubes = {}

    def step(self, x, axis):
        i = x * (1 / self.side)
        m = float(self.count[axis] - 1)
        if not i > 0:
            return 0
        return int(i) if i < m else int(m)

    def cube(self, place):
        return tuple(self.step(place[axis], axis) for axis in range(3))

    def insert(self, v, place):
        self.cubes.setdefault(self.cube(place), []).insert(0, v)

    def remove(self, v, place):
        self.cubes[self.cube(place)].remove(v)

    def search(self, spheres, h, place, corners):
        """7.4: yields the vertex and the height of all that are found."""
        for v in self.in_box(spheres.centre_at(h), spheres.radius_at(h), MOST_LOOKED_AT):
            d, e = spheres.lift(place(v))
            if d > 0 and e <= (2 * h) * d and v not in corners:
                yield v, e / (2 * d)

    def in_box(self, centre, radius, most):
        """7.4 and 7.9: yields the vertices to be looked at."""
        # 1
        low = [self.step(centre[axis] - radius, axis) for axis in range(3)]
        high = [self.step(centre[axis] + radius, axis) for axis in range(3)]
        if math.prod(high[axis] // 4 - low[axis] // 4 + 1 for axis in range(3)) > MOST_BLOCKS:
            return
        # 2
        looked = 0
        for cube in self.in_order(low, high):
            for v in self.cubes.get(cube, ()):
                if looked == most:
                    return
                looked += 1
                yield v

    def in_order(self, low, high):
        """Block by block."""

        def within(block, axis):
            return range(max(low[axis], 4 * block), min(high[axis], 4 * block + 3) + 1)

        x_blocks, y_blocks, z_blocks = (range(low[a] // 4, high[a] // 4 + 1) for a in range(3))
        for bz in z_blocks:
            for by in y_blocks:
                for bx in x_blocks:
                    for z in within(bz, 2):
                        for y in within(by, 1):
                            for x in within(bx, 0):
                                yield x, y, z
