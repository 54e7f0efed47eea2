"""8.5.2, 3 to 5: leaders, told or guessed."""

import math

from conventions import NONE, clamp, length, minus

MOST_SEEDS_LOOKED_AT = 96
MOST_SEEDS = 32
MOST_LOOKED_AT = 64
PLACE_FLAGS = 4
MOST_OTHERS = 2**PLACE_FLAGS


class Leads:
    """`course_of`: the courses of all vertices so far, v among them."""

    def __init__(self, block, positions, course_of):
        self.positions = positions
        self.course_of = course_of
        least = clamp(block.vertices + block.unused_points, 256, 2**24)
        self.C = 1 << (least - 1).bit_length()
        self.by = 0
        self.led = False
        self.last_in = {}
        self.before = {}  # the vertex that was last in its slot before
        self.history = 0
        # seeds
        self.S = []
        self.m = {}
        self.candidates = []  # (number, vertex) of the seed that is being read
        self.misses = [2**23] * (1 + MOST_SEEDS)

    # 3

    def begin_part(self):
        """1 sets `begin`."""
        self.led = False

    def can_lead(self, u, v, stencil):
        return u < v and self.course_of[u] == self.course_of[v] and all(p == NONE or p >= v - u for p in stencil)

    def goes_on(self, v, stencil):
        return 0 < self.by <= v and self.can_lead(v - self.by, v, stencil)

    def leader(self, v, configuration, stencil):
        """The leader of v, or NONE."""
        if configuration == "seed":
            return self.leader_of_seed(v, stencil)
        g = self.goes_on(v, stencil)
        if self.led and g:
            return v - self.by
        leader = self.read(g, self.listed(v, stencil, g))
        if leader != NONE:
            self.by = v - leader
            self.led = True
        return leader

    # 4

    def leader_of_seed(self, v, stencil):
        self.candidates = []
        if self.goes_on(v, stencil) and v - self.by in self.m:
            self.candidates.append((0, v - self.by))
        last = self.S[: -MOST_SEEDS_LOOKED_AT - 1 : -1]
        those = [u for u in last if self.can_lead(u, v, stencil)]
        self.candidates += enumerate(those[:MOST_SEEDS], 1)
        # of equal ones min takes the first
        return min(self.candidates, key=lambda c: self.misses[c[0]], default=(0, NONE))[1]

    def learn(self, v, guess):
        """Seed v has its values."""
        self.m[v] = minus(self.positions.value[v], guess)
        self.S.append(v)
        for i, c in self.candidates:
            off = [abs(x - y) for x, y in zip(self.m[v], self.m[c])]
            digits = sum(math.trunc(min(x + 0.5, 2.0**60)).bit_length() for x in off)
            self.misses[i] = self.misses[i] // 2 + 65536 * digits

    # 5

    def slot(self, v):
        return (self.course_of[v] >> 32) % self.C

    def listed(self, v, stencil, g):
        """The list of v; `g`: the part goes on."""
        entered = []
        u = self.last_in.get(self.slot(v), NONE)
        while u != NONE and len(entered) < MOST_LOOKED_AT and self.can_lead(u, v, stencil):
            entered.append(u)
            u = self.before[u]
        first = [v - self.by] if g else []
        others = [u for u in entered if u not in first]
        # sort keeps what is equal in the order it came
        others.sort(key=lambda u: self.unlike(v, u, stencil))
        return first + others[:MOST_OTHERS]

    def unlike(self, v, u, stencil):
        """How unlike v vertex u is."""
        by = v - u
        value = self.positions.value
        off = []
        for a, b in ((1, 0), (2, 0), (2, 1)):
            p, q = stencil[a], stencil[b]
            if p == NONE or q == NONE:
                off.append(0.0)
            else:
                d = minus(value[p], value[q])
                e = minus(value[p - by], value[q - by])
                off.append(abs(length(e) - length(d)))
        return off[0] + off[1] + off[2]

    def read(self, g, listed):
        """The leader of those in the list."""
        if len(listed) < 2:
            return listed[0] if listed else NONE
        first = self.positions.flag("lead", g, self.history)
        self.history = (self.history * 2 + first) % 8
        if first:
            return listed[0]
        block = self.positions.contexts["lead_place"]
        why = "a leader that its list does not reach"
        return listed[g + self.positions.stream.leaf_below(block, PLACE_FLAGS, len(listed) - g, why)]

    def enter(self, v):
        """Vertex v has its values."""
        slot = self.slot(v)
        self.before[v] = self.last_in.get(slot, NONE)
        self.last_in[slot] = v
