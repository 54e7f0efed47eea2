"""Round faces of a writer that tosses coins."""

import random

from coin_stream import coin, varint, zigzag
from conventions import clamp, cross, dot, length, minus, plus, times, width
from rounds import CYLINDER, SPHERE, TORUS, RoundFace, RoundFaces


class CoinRoundFaces(RoundFaces):
    """Faces that are decided on when the first three points are asked about, so that some go through these."""

    def __init__(self, is_grid):
        self.round_slack = random.choice((0, 0, 0, 0, 1, 2, 3, 5, 8, 12, 53))
        super().__init__([], self.round_slack)
        self.count = random.choice((1, 1, 1, 2, 3, 7, 16))
        self.fields = b""
        self.first = random.choice((None, face_missed, face_far if is_grid else None))

    def under(self, points):
        self.decide(points)
        return super().under(points)

    def decide(self, points):
        if points and self.first and not self.faces:
            self.add(self.first(points[0]))
            self.round_slack = slack_of(self.faces[0], points)
            self.slack = float(2**self.round_slack)
        while len(self.faces) < self.count:
            fields = face_through(points) if points and coin(0.6) else None
            self.add(fields or (face_at(points[0]) if points and coin(0.3) else face_by_chance()))

    def add(self, fields):
        self.fields += bytes_of(*fields)
        self.faces.append(RoundFace(*fields))

    def bytes(self):
        """8.1: the fields from `round_count` to `ring`."""
        self.decide(None)
        return bytes([self.count, self.round_slack]) + self.fields


def bytes_of(kind, centre, axis, radius, ring):
    out = bytes([kind]) + b"".join(varint(zigzag(x)) for x in centre)
    if kind != SPHERE:
        out += b"".join(varint(zigzag(x)) for x in axis)
    return out + varint(radius) + (varint(ring) if kind == TORUS else b"")


def axis_by_chance():
    most = random.choice((1, 1, 3, 1000, 2**51))
    if coin(0.4):
        axis = [0, 0, 0]
        axis[random.randrange(3)] = random.choice((-most, most))
        return axis
    return [random.randint(-most, most) for _ in range(3)]


def face_by_chance():
    """Often without an axis, radius or ring; or through about 0."""
    most = random.choice((0, 100, 1000, 10**5, 2**40, 2**58))
    kind = random.choice((SPHERE, CYLINDER, TORUS))
    centre = [random.choice((0, -most, most, random.randint(-most, most))) for _ in range(3)]
    axis = [0, 0, 0] if kind == SPHERE or coin(0.3) else axis_by_chance()
    far = min(int(length(tuple(float(x) for x in centre))), 2**58)
    ring = random.choice((0, far, random.randint(0, most))) if kind == TORUS else 0
    return kind, centre, axis, random.choice((0, far, abs(far - ring), random.randint(0, most))), ring


def face_at(p):
    """Of no size or a small one: vertices lie on it where `round_slack` is large."""
    kind = random.choice((SPHERE, CYLINDER, TORUS))
    axis = [0, 0, 0] if kind == SPHERE or coin(0.3) else axis_by_chance()
    return face(kind, p, axis, random.choice((0, 0, 3)), random.choice((0, 0, 3)) if kind == TORUS else 0)


def face_far(p):
    """So far from p that a guess near it is moved beyond 2^40, on one axis or more."""
    way = random.choice(((1, 0, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1), (1, -1, 0), (-3, 1, 2)))
    far = 2.0 ** random.randrange(41, 52)
    return face(random.choice((SPHERE, TORUS)), plus(p, times(way, far)), [0, 0, 0], 8 * far, 0.0)


def face_missed(p):
    """So small that the line along the last axis may pass it: then the eight rounds of 8.5.5 do not meet."""
    kind = random.choice((SPHERE, SPHERE, CYLINDER, TORUS))
    radius = random.choice((1, 3, 10, 30, 100, 1000))
    ring = random.choice((0, 1, 10)) * radius if kind == TORUS else 0
    return face(kind, p, [0, 0, 0] if kind == SPHERE else axis_by_chance(), radius, ring)


def slack_of(face, points):
    """The least `round_slack` with which the points lie on the face, if there is one."""
    return min(width(int(max(abs(face.outside(p)[0]) for p in points))), 53)


def face_through(points):
    """A face that three points lie on; None where there is none of the kind that the coins want."""
    kind = random.choice((SPHERE, SPHERE, CYLINDER, CYLINDER, TORUS))
    if kind == SPHERE:
        return sphere_through(points)
    axis = axis_by_chance()
    A = RoundFace(CYLINDER, (0, 0, 0), axis, 0, 0).A
    if kind == TORUS:
        return torus_through(points, axis, A)
    # along the axis, all of a cylinder is one circle
    middle, _ = circle([minus(p, times(A, dot(p, A))) for p in points])
    if not middle:
        return None
    beside = random.choice((0, 0, 30, -1000))
    return face(CYLINDER, plus(middle, times(A, beside)), axis, distance(points[0], middle, A), 0.0)


def sphere_through(points):
    """Also as what a cylinder or a torus is without an axis, or a torus without a ring."""
    middle, up = circle(points)
    if not middle:
        return None
    beside = random.choice((0, 0, 1, -0.5, 10)) * length(minus(points[0], middle))
    middle = plus(middle, times(up, beside))
    radius = length(minus(points[0], middle))
    kind = random.choice((SPHERE, SPHERE, SPHERE, CYLINDER, TORUS))
    if kind == TORUS and coin(0.5):
        return face(TORUS, middle, axis_by_chance(), radius, 0.0)
    ring = radius * random.choice((0, 0.5, 1)) if kind == TORUS else 0.0
    return face(kind, middle, [0, 0, 0], radius - ring, ring)


def torus_through(points, axis, A):
    """Any torus about an axis is a circle in the half plane beside that."""
    most = random.choice((0, 10, 100, 1000))
    start = tuple(float(random.randint(-most, most)) for _ in range(3))
    flat = [(distance(p, start, A), dot(minus(p, start), A), 0.0) for p in points]
    middle, _ = circle(flat)
    if not middle or middle[0] < 0:
        return None
    centre = plus(start, times(A, middle[1]))
    return face(TORUS, centre, axis, length(minus(flat[0], middle)), middle[0])


def distance(p, middle, A):
    """Of p from the line through the middle."""
    q = minus(p, middle)
    return length(minus(q, times(A, dot(q, A))))


def circle(p):
    """The middle of the circle through three points and the way out of its plane; both None of points on a line."""
    u = minus(p[1], p[0])
    v = minus(p[2], p[0])
    n = cross(u, v)
    square = dot(n, n)
    if not square > 0:
        return None, None
    to = plus(times(cross(v, n), dot(u, u)), times(cross(n, u), dot(v, v)))
    return plus(p[0], times(to, 1 / (2 * square))), times(n, 1 / length(n))


def face(kind, middle, axis, radius, ring):
    """In sixteenths, as far as there is place for them."""
    *centre, radius, ring = (round(clamp(16 * x, -(2.0**58), 2.0**58)) for x in (*middle, radius, ring))
    return kind, centre, axis, radius, ring
