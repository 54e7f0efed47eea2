"""5.5: which vertices are copies, and of which."""

from conventions import MASK64, NONE, dot, minus, plus, unzigzag
from errors import require
from ties import Ties, neighbours_of

TIES_LOOKED_AT = 12
NEAREST = 8


class Copies:
    def __init__(self, walk):
        self.walk = walk
        self.ties = Ties()
        self.was_copy = 0
        self.last = 0

    def origin(self, u):
        source = self.walk.copy_of[u]
        return u if source == NONE else source

    def read(self, v, configuration, stencil):
        """The source of the new vertex v; NONE: it is no copy."""
        p = (stencil + [NONE] * 3)[:3]
        neighbours = neighbours_of(configuration, p)
        # 1
        source = NONE
        self.was_copy = self.walk.flag("kCopy", self.was_copy, self.around(neighbours))
        if self.was_copy:
            source = self.last = self.read_source(v, configuration, p, neighbours)
        # 5
        for n in neighbours:
            self.ties.tie(self.origin(n), v if source == NONE else source)
        return source

    def around(self, neighbours):
        copied = sum(self.origin(n) != n for n in neighbours)
        return (0, 1 + copied, 3 + copied)[len(neighbours)]

    def read_source(self, v, configuration, p, neighbours):
        # 2, 3
        if neighbours:
            guess = self.guess(configuration, p)
            candidates = self.candidates(guess, p, neighbours)
            s = self.distance(p[0], guess)
            for i, u in enumerate(candidates):
                d = self.distance(u, guess)
                far = 0 if d * 256 <= s else 1 if d * 16 <= s else 2
                if self.walk.flag("kCopyNear", i, far, i + 1 == len(candidates)):
                    return u
        # 4
        source = (self.last + unzigzag(self.walk.number("kCopyOf"))) & MASK64
        require(source < v and self.walk.copy_of[source] == NONE, "a copy of a later vertex or of a copy")
        return source

    def guess(self, configuration, p):
        place = self.walk.place
        if p[2] == NONE:
            return place(p[0])
        if configuration == "quad_third":
            return plus(place(p[0]), minus(place(p[0]), place(p[2])))
        if configuration in ("quad_fourth", "quad_corner", "triangle"):
            return plus(place(p[0]), minus(place(p[1]), place(p[2])))
        if configuration in ("tet", "led"):
            return tuple((a + b + c) / 3 for a, b, c in zip(*(place(u) for u in p)))
        return place(p[0])

    def distance(self, u, guess):
        w = minus(self.walk.place(u), guess)
        return dot(w, w)

    def candidates(self, guess, p, neighbours):
        origins = [self.origin(n) for n in neighbours]
        found = []
        for n in origins:
            for u in self.ties.latest(n, TIES_LOOKED_AT):
                if u not in origins and u not in found:
                    found.append(u)
        # sort keeps what is equal in the order it came
        found.sort(key=lambda u: self.distance(u, guess))
        del found[NEAREST:]
        for u in p:
            if u != NONE and self.origin(u) not in found:
                found.append(self.origin(u))
        return found
