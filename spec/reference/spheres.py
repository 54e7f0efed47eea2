"""7.5: spheres through a triangle."""

import math

from conventions import cross, dot, minus


def normal(p):
    """N of three places (7.5, 7.7)."""
    return cross(minus(p[1], p[0]), minus(p[2], p[0]))


def longest(p):
    """The square of the longest side of three places."""
    sides = [minus(p[(i + 1) % 3], p[i]) for i in range(3)]
    return max(dot(w, w) for w in sides)


class Spheres:
    def __init__(self, a, b, c, mirrored):
        self.a = a
        u = minus(b, a)
        v = minus(c, a)
        self.normal = cross(v, u) if mirrored else cross(u, v)
        self.S = dot(self.normal, self.normal)
        self.flat = not self.S > 0
        if self.flat:
            return
        n = cross(u, v)
        vn = cross(v, n)
        nu = cross(n, u)
        uu = dot(u, u)
        vv = dot(v, v)
        self.C = tuple((uu * vn[i] + vv * nu[i]) / (2 * self.S) for i in range(3))
        self.R = dot(self.C, self.C)
        self.flat = not self.R > 0
        if not self.flat:
            self.unit = math.sqrt(self.R / self.S)

    def lift(self, p):
        """d and e of p."""
        q = minus(p, self.a)
        return dot(self.normal, q), dot(q, q) - 2 * dot(q, self.C)

    def height(self, p):
        """The height of p; None where p is not above."""
        d, e = self.lift(p)
        return e / (2 * d) if d > 0 else None

    def centre_at(self, h):
        return tuple(self.a[i] + self.C[i] + h * self.normal[i] for i in range(3))

    def radius_at(self, h):
        return math.sqrt(self.R + h * h * self.S)
