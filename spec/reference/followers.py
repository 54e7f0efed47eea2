"""8.5.2: courses, leaders and followers."""

import math

from conventions import MASK64, NONE, clamp, cross, dot, minus, plus
from guesses import NUMBER
from leads import Leads


class Followers:
    def __init__(self, block, positions):
        self.positions = positions
        self.course = 1
        self.begin = 0
        self.course_of = []
        self.leads = Leads(block, positions, self.course_of)
        self.before_was_seed = False
        self.history = 0

    def skip(self):
        """A copy or the point of an edge."""
        self.course_of.append(0)

    def advance(self, v, configuration, stencil):
        """1, 2: the course of v."""
        # 1
        seed = configuration == "seed"
        if seed and not self.before_was_seed:
            self.course = 1
            self.begin = v
            self.leads.begin_part()
        self.before_was_seed = seed
        # 2
        course = self.course * 0x9E3779B97F4A7C15 + NUMBER[configuration]
        for p in stencil:
            k = v - p if p != NONE and p >= self.begin else 0
            course = (course * 0xC2B2AE3D27D4EB4F + k) & MASK64
        self.course = course ^ course >> 29
        self.course_of.append(self.course)

    def leader(self, v, configuration, stencil):
        """3 to 5: the leader of v, or NONE."""
        return self.leads.leader(v, configuration, stencil)

    def enter(self, v, configuration, guess):
        """4, 5: after v has its values."""
        if configuration == "seed":
            self.leads.learn(v, guess)
        self.leads.enter(v)

    def says(self, v, leader, configuration, stencil, variant, guess):
        """6: whether v repeats; whole parts, values and coordinates."""
        positions = self.positions
        value = positions.value
        M = float(positions.M)
        by = v - leader
        leaders = [p - by if p != NONE else NONE for p in stencil]
        repeats = True
        for p, q in zip(stencil[:3], leaders[:3]):
            if p == NONE:
                break
            repeats = repeats and all(value[p][k] == value[q][k] for k in range(3))
        coordinate = (None,) * 3
        if repeats:
            said = value[leader]
            coordinate = positions.coordinate[leader]
        else:
            said = self.computed(leader, configuration, stencil, variant, leaders, guess)
        said = [clamp(x, -M, M) for x in said]
        whole = [positions.whole_of(x) for x in said]
        if positions.digits == 0 and not repeats:
            said = [float(x) for x in whole]
        return repeats, whole, said, coordinate

    def computed(self, leader, configuration, stencil, variant, leaders, guess):
        value = self.positions.value
        missed = minus(value[leader], self.positions.guess(configuration, leaders, variant))
        q = plus(guess, missed)
        if configuration == "seed" or NONE in stencil[:3]:
            return q
        p = [value[i] for i in leaders[:3]]
        a = minus(p[1], p[0])
        b = minus(p[2], p[0])
        p = [value[i] for i in stencil[:3]]
        c = minus(p[1], p[0])
        d = minus(p[2], p[0])
        if a == c and b == d:
            return q
        n = cross(a, b)
        m = cross(c, d)
        A = dot(n, n)
        B = dot(m, m)
        if not A > 0 or not B > 0:
            return q
        x = dot(cross(missed, b), n) / A
        y = dot(cross(a, missed), n) / A
        z = dot(missed, n) / A * math.sqrt(math.sqrt(A / B))
        turned = tuple(guess[k] + ((x * c[k] + y * d[k]) + z * m[k]) for k in range(3))
        if all(abs(t) <= 2.0**60 for t in turned):
            return turned
        return q

    def read(self, repeats, far):
        """7"""
        follows = self.positions.flag("follow", self.history, repeats, far)
        self.history = (self.history * 2 + follows) % 8
        return follows
