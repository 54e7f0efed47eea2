"""8.1, 8.5.5: round faces."""

import math

from conventions import dot, length, minus
from errors import require

SPHERE, CYLINDER, TORUS = range(3)


def read_round_faces(bytes):
    """8.1: the fields from `round_count` to `ring`."""
    count = bytes.u8()
    require(1 <= count <= 16, "round_count")
    slack = bytes.u8()
    require(slack <= 53, "round_slack")
    return RoundFaces([read_round_face(bytes) for _ in range(count)], slack)


def read_round_face(bytes):
    kind = bytes.u8()
    require(kind <= TORUS, "kind of a round face")
    centre = [bytes.zigzag() for _ in range(3)]
    require(all(abs(x) <= 2**58 for x in centre), "centre of a round face")
    axis = [0, 0, 0]
    if kind != SPHERE:
        axis = [bytes.zigzag() for _ in range(3)]
        require(all(abs(x) <= 2**51 for x in axis), "axis of a round face")
    radius = bytes.varint()
    require(radius <= 2**58, "radius of a round face")
    ring = 0
    if kind == TORUS:
        ring = bytes.varint()
        require(ring <= 2**58, "ring of a round face")
    return RoundFace(kind, centre, axis, radius, ring)


class RoundFaces:
    def __init__(self, faces, slack):
        self.faces = faces
        self.slack = float(2**slack)

    def under(self, points):
        """The first face on which all of these lie, None if there is none."""
        for face in self.faces:
            if all(abs(face.outside(p)[0]) < self.slack for p in points):
                return face
        return None


class RoundFace:
    def __init__(self, kind, centre, axis, radius, ring):
        self.kind = kind
        self.C = tuple(float(x) / 16 for x in centre)
        self.R = float(radius) / 16
        self.T = float(ring) / 16
        axis = [float(x) for x in axis]
        l = length(axis)
        self.A = tuple(x / l if l > 0 else 0.0 for x in axis)

    def outside(self, p):
        """distance and way: how far out of the face p lies, and which way is out."""
        q = minus(p, self.C)
        h = 0.0
        if self.kind != SPHERE:
            h = dot(q, self.A)
            q = tuple(x - h * a for x, a in zip(q, self.A))
        l = length(q)
        way = tuple(x / l if l > 0 else 0.0 for x in q)
        if self.kind != TORUS:
            return l - self.R, way
        s = l - self.T
        t = math.sqrt(s * s + h * h)
        way = tuple((s * x + h * a) / t if t > 0 else 0.0 for x, a in zip(way, self.A))
        return t - self.R, way

    def moved(self, guess):
        """The guess, moved onto the face but not yet clamped."""
        distance, way = self.outside(guess)
        return tuple(x - distance * w for x, w in zip(guess, way))

    def x(self, guess, value, last):
        """Where the face has `last`, once `value` has the other two axes."""
        P = list(value)
        P[last] = guess[last]
        for _ in range(8):
            distance, way = self.outside(P)
            if abs(way[last]) < 1 / 16:
                return guess[last]
            step = distance / way[last]
            P[last] = P[last] - step
            if abs(step) < 1 / 16:
                return P[last]
        return guess[last]
