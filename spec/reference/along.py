"""8.5.5: along a border; 8.6: off a plane."""

import math

from conventions import NONE, clamp, cross, dot, minus
from guesses import PLACES


class Border:
    """What a vertex goes on with: the stencil it has from here on, its round face or None, N, the order of axes."""

    def __init__(self, stencil, N, face):
        self.stencil = stencil + [NONE] * (PLACES - len(stencil))
        self.N = N
        self.face = face

    def begin(self, guess, M):
        """The guess from here on, of that by the stencil; says N and the order of the axes."""
        if self.face:
            moved = self.face.moved(guess)
            self.N = self.face.outside(moved)[1]
            guess = tuple(clamp(x, -M, M) for x in moved)
        # of equal ones the highest
        self.last = max(range(3), key=lambda k: (abs(self.N[k]), k))
        self.order = [k for k in range(3) if k != self.last] + [self.last]
        return guess

    def x(self, guess, value):
        """Where the plane or the round face has `last`, once `value` has the other two axes."""
        i, j, last = self.order
        if self.face:
            return self.face.x(guess, value, last)
        N = self.N
        return guess[last] - (N[i] * (value[i] - guess[i]) + N[j] * (value[j] - guess[j])) / N[last]


class Along:
    def __init__(self, positions, round_faces):
        self.positions = positions
        self.round_faces = round_faces  # None if there are none
        self.off = {}  # of the vertices that have one
        self.usual_off = 256

    def read(self, stencil, borders):
        """8.4 step 4: the `Border` that the vertex goes on with, None if it does with none."""
        value = self.positions.value
        asked = 0
        for e in borders:
            own = [stencil[(e + 1) % 3], stencil[(e + 2) % 3], stencil[4 + e], stencil[e]]
            a, b, y, z = (value[p] for p in own)
            edge = minus(b, a)
            N = cross(edge, minus(y, a))
            S = dot(N, N)
            if not S > 0:
                continue
            face = self.round_faces.under((a, b, y)) if self.round_faces else None
            block = "along_round" if face else "along"
            if self.positions.flag(block, asked, self.opening(minus(z, a), edge, N, S)):
                return Border(own, N, face)
            asked += 1
        return None

    def opening(self, way, edge, N, S):
        """How far the gate is turned against the border's triangle; `way` is that from a to z."""
        G = cross(way, edge)
        d = dot(G, N)
        q = dot(G, G) * S
        return math.trunc(clamp(8 + 8 * d / math.sqrt(q), 0.0, 15.0)) if q > 0 else 0

    # 8.6

    def expected(self, border):
        """e of the last axis."""
        near = [self.off[p] for p in border.stencil[:3] if p in self.off]
        at = 16 * sum(near) // len(near) if near else self.usual_off
        return (29 * at + 3 * self.usual_off) >> 5

    def keep(self, v, magnitude):
        """Once the last axis of v is done."""
        magnitude = min(magnitude, 2**32 - 2)
        self.off[v] = magnitude
        self.usual_off = self.usual_off + ((16 * magnitude + 31) >> 5) - ((self.usual_off + 31) >> 5)
