"""7.7: what tells of a border."""

from conventions import dot, minus
from spheres import longest, normal
from walk import BORDER


class BorderSigns:
    """Of facet f, which may become a border."""

    def __init__(self, walk, f):
        self.walk = walk
        self.f = f
        self.p = self.places(f)
        self.N = normal(self.p)
        self.S = dot(self.N, self.N)
        self.sigma = -1.0 if walk.block.mirrored else 1.0
        self.behind = walk.on_border[walk.vertex[f]]

    def places(self, f):
        return [self.walk.place(v) for v in self.walk.triple(f)]

    def neighbours(self):
        """For each e: whether it is a border beyond, M, d_e."""
        for e in range(3):
            g = self.walk.across(self.f, e)
            M = normal(self.places(g))
            yield e, self.walk.state[g] == BORDER, M, dot(self.N, M)

    def around(self):
        n = sum(self.walk.on_border[v] for v in self.walk.triple(self.f))
        flats = [self.flatness(M, d) for _, is_border, M, d in self.neighbours() if is_border]
        beside = len(flats)
        if beside == 0:
            return n
        return 4 + 6 * (n - 2 if beside == 1 else beside) + max(flats) - 1

    def flatness(self, M, d):
        if not d > 0:
            return 1
        r = d * d
        q = self.S * dot(M, M)
        return 6 if r > 0.9999 * q else 5 if r > 0.99 * q else 4 if r > 0.9 * q else 3 if r > 0.5 * q else 2

    def valley(self):
        found = [1 if d > 0 else 2 for e, is_border, _, d in self.neighbours() if not is_border and self.h(e) > 0]
        return max(found, default=0)

    def h(self, e):
        apex = self.walk.place(self.walk.apex_across(self.f, e))
        return self.sigma * dot(minus(apex, self.p[0]), self.N)

    def depth(self):
        c = dot(minus(self.walk.place(self.walk.vertex[self.f]), self.p[0]), self.N)
        deep = c * c
        wide = self.S * longest(self.p)
        return 0 if deep < 0.25 * wide else 1 if deep < 0.49 * wide else 2

    def length(self):
        square = longest(self.p)
        unit = self.walk.grid.unit
        return 0 if square < 3.61 * unit else 1 if square < 6.76 * unit else 2
