"""7.5: spheres through a triangle."""

import math

from conventions import cross, dot, minus


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

    def height(self, p):
        """The height of p; None where p is not above."""
        q = minus(p, self.a)
        d = dot(self.normal, q)
        if not d > 0:
            return None
        return (dot(q, q) - 2 * dot(q, self.C)) / (2 * d)

    def relative(self, h):
        return h * abs(h) * self.S / self.R

    def height_at(self, r):
        return math.sqrt(r * self.R / self.S)

    def centre_at(self, h):
        return tuple(self.a[i] + self.C[i] + h * self.normal[i] for i in range(3))

    def radius_at(self, h):
        return math.sqrt(self.R + h * h * self.S)
