"""11.6: guesses for values: shares and normals."""

import math

from beside import MOST_CORNERS, NO_TUPLE
from conventions import cross, divide, dot, minus, plus, times

NEAREST, MEAN, LINEAR, NORMAL = range(4)

ARC = (
    -0.0012624911, 0.0066700901, -0.0170881256, 0.0308918810,
    -0.0501743046, 0.0889789874, -0.2145988016, 1.5707963050)


def shares(guess, near, places, own_place):
    """The share of each of `near`; `places` are theirs."""
    n = len(near)
    if guess in (NEAREST, NORMAL):
        return [1.0 if i == 0 else 0.0 for i in range(n)]
    if guess == MEAN:
        return [1.0 / n for _ in range(n)]
    return linear_shares(near, places, own_place) if n else []


def linear_shares(near, places, own_place):
    way = [minus(p, own_place) for p in places]
    q = [dot(w, w) for w in way]
    nearest = q[0]
    for x in q:
        nearest = x if x < nearest else nearest
    b = 0.0
    for x in near:
        b = b + float(x.share)
    weight = [divide(1.0, x + nearest / 8) for x in q]
    W = 0.0
    middle = (0.0, 0.0, 0.0)
    for w, x in zip(way, weight):
        W = W + x
        middle = plus(middle, times(w, x))
    middle = tuple(divide(x, W) for x in middle)
    A = [[0.0] * 3 for _ in range(3)]
    for w, x in zip(way, weight):
        e = minus(w, middle)
        for r in range(3):
            for c in range(3):
                A[r][c] = A[r][c] + x * e[r] * e[c]
    more = (A[0][0] + A[1][1] + A[2][2]) / 8192
    for r in range(3):
        A[r][r] = A[r][r] + more
    share = [float(near[i].share) / b if b > 0 else divide(weight[i], W) for i in range(len(near))]
    carry = (0.0, 0.0, 0.0)
    for w, x in zip(way, share):
        carry = minus(carry, times(w, x))
    s = solve(A, list(carry))
    for i in range(len(near)):
        more = weight[i] * dot(minus(way[i], middle), s)
        if math.isfinite(more):
            share[i] = share[i] + more
        if not math.isfinite(share[i]):
            share[i] = 1.0 if i == 0 else 0.0
    return share


def solve(a, b):
    """Elimination without pivoting."""
    for i in range(3):
        for r in range(i + 1, 3):
            f = divide(a[r][i], a[i][i])
            for c in range(i, 3):
                a[r][c] = a[r][c] - f * a[i][c]
            b[r] = b[r] - f * b[i]
    for i in (2, 1, 0):
        for c in range(i + 1, 3):
            b[i] = b[i] - a[i][c] * b[c]
        b[i] = divide(b[i], a[i][i])
    return b


def root(x):
    return math.sqrt(x) if x >= 0 else math.nan


def angle(shape, c):
    u = minus(shape.at(shape.succ(c)), shape.at(c))
    v = minus(shape.at(shape.pred(c)), shape.at(c))
    cosine = divide(dot(u, v), root(dot(u, u) * dot(v, v)))
    x = abs(cosine)
    x = 1.0 if 1.0 < x else x
    p = ARC[0]
    for a in ARC[1:]:
        p = p * x + a
    result = root(1 - x) * p
    return 3.14159265358979323846 - result if cosine < 0 else result


class Normals:
    """The normal of an element, of length 1."""

    def __init__(self, shape, by_angle):
        self.shape = shape
        self.by_angle = by_angle
        self.of_polygons = {}
        self.corners_of_point = {}
        for c in range(len(shape.vertex)):
            self.corners_of_point.setdefault(shape.point(c), []).append(c)

    def of_polygon(self, cell):
        if cell not in self.of_polygons:
            shape = self.shape
            corners = shape.corners(cell)[:MOST_CORNERS]
            n = (0.0, 0.0, 0.0)
            for c in corners[1:-1]:
                first = shape.at(corners[0])
                n = plus(n, cross(minus(shape.at(c), first), minus(shape.at(c + 1), first)))
            if shape.walk.flipped[cell]:
                n = (-n[0], -n[1], -n[2])
            self.of_polygons[cell] = n
        return self.of_polygons[cell]

    def of_corner(self, c):
        """`c` is a corner of the walk."""
        n = self.of_polygon(self.shape.cell_of[c])
        if self.by_angle:
            n = times(n, divide(angle(self.shape, c), root(dot(n, n))))
        return n

    def of_corner_element(self, e):
        return self.of_corner(self.shape.walk_corner[e])

    def of_point(self, p):
        n = (0.0, 0.0, 0.0)
        for c in self.corners_of_point.get(p, ()):
            n = plus(n, self.of_corner(c))
        return n


def unit(n):
    length = root(dot(n, n))
    return tuple(divide(x, length) for x in n)
