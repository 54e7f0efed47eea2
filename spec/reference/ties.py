"""5.5: which vertices are tied to each other."""

from conventions import NONE

MOST_TIES = 2**31 - 1
ONE_NEIGHBOUR = ("seed", "quad_third", "polygon")


def neighbours_of(configuration, stencil):
    """Those of a new vertex: p0 and p1, as far as they are there and neighbours."""
    p = stencil[:1] if configuration in ONE_NEIGHBOUR else stencil[:2]
    return [u for u in p if u != NONE]


class Ties:
    def __init__(self):
        self.ends = {}  # per vertex the other ends of its ties, the latest last
        self.count = 0

    def tie(self, a, b):
        if a == b or self.count == MOST_TIES:
            return
        self.count += 1
        self.ends.setdefault(a, []).append(b)
        self.ends.setdefault(b, []).append(a)

    def latest(self, v, most):
        """The other ends, the latest first, at most so many."""
        return self.ends.get(v, [])[: -most - 1 : -1]
