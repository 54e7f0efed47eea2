"""7.10: the walk over tets by folds."""

from conventions import NONE
from errors import require
from walk import BORDER, GONE, OPEN
from walk_tet import TetWalk

LOOKED_AT = 192
MOST_RANKS = 247


class FoldWalk(TetWalk):
    def opened(self, f):
        self.open_facets[tuple(sorted(self.triple(f)))] = f

    def closed(self, f):
        del self.open_facets[tuple(sorted(self.triple(f)))]

    # joining

    def join_seed(self, base):
        self.join(range(base, base + 4), True)

    def join_cell(self, base, kind):
        """visit, steps 1 and 2"""
        left = []
        for i in range(3):
            f = base + (self.met_first + i) % 3
            g = None if kind == "fresh" else self.open_facets.get(tuple(sorted(self.triple(f))))
            if g is None:
                left.append(f)
                continue
            self.twin[f] = g
            self.twin[g] = f
            self.closed(g)
            self.state[g] = GONE
            self.glue(f, g)
        self.join(left, kind == "fresh")

    def join(self, left, fresh):
        contacts = [self.contact(f) for f in left]
        apart = sum(c < 2 for c in contacts)
        any_border = False
        if self.block.has_border and apart > 0:
            any_border = self.flag("kFoldBorders", apart, fresh)
        for f, contact in zip(left, contacts):
            if self.block.has_border and (any_border or contact >= 2) and self.flag("kFoldBorder", contact):
                self.become_border(f)
            else:
                self.state[f] = OPEN
                self.opened(f)

    def contact(self, f):
        mates = [e for e in range(3) if self.is_border_across(f, e)]
        if not mates:
            return sum(self.on_border[v] for v in self.triple(f))
        return 4 + 6 * (len(mates) - 1) + min(max(self.fan[3 * f + e] for e in mates), 6) - 1

    def is_border_across(self, f, e):
        return self.state[self.across(f, e)] == BORDER

    # the apex

    def read_apex(self, gate, corners):
        # 1
        t = [0 if self.is_border_across(gate, e) else self.fan[3 * gate + e] for e in range(3)]
        borders = sum(self.is_border_across(gate, e) for e in range(3))
        first = t.index(max(t))
        second = max(t[e] for e in range(3) if e != first)
        across = [self.apex_across(gate, e) for e in range(3)]
        u = across[first]
        self.met_first = 0
        # 2
        if u not in corners and self.flag("kFold", t[first], second, across.count(u) - 1, borders):
            if t[first] > 0:
                self.met_first = first
            return "fold", u
        # 3
        beside = sum(self.on_border[v] for v in corners)
        if self.flag("kFoldNew", t[first], second, borders, beside):
            return "fresh", NONE
        return "old", self.read_old(gate, corners, first, u)

    def read_old(self, gate, corners, first, u):
        # 4
        a, b = (first + 1) % 3, (first + 2) % 3
        z = self.is_border_across(gate, a) + 2 * self.is_border_across(gate, b)
        near = [self.apex_across(gate, a), self.apex_across(gate, b)]
        for e in (a, b, first):
            g, d = divmod(self.mate[3 * gate + e], 3)
            near += [self.apex_across(g, (d + i) % 3) for i in (1, 2)]
        place = self.read_near(z, near, corners)
        if place is not None:
            return near[place]
        # 5
        r = self.read_rank(gate, [*corners, u, *near])
        if r < MOST_RANKS:
            met = self.meet(gate, [*corners, u, *near], r + 1)
            require(r < len(met), "apex by rank that is not there")
            return met[r]
        # 6
        age = self.number("kFoldAge")
        require(age < self.vertex_count, "apex by age that does not exist")
        return self.vertex_count - 1 - age

    def read_near(self, z, near, corners):
        """4: the place of the apex in `near`, or None."""
        if not self.flag("kFoldNear", z, 0):
            return None
        x = 1
        for _ in range(3):
            x = 2 * x + self.flag("kFoldNear", z, x)
        return x - 8

    def read_rank(self, gate, known):
        return self.number("kFoldRank")

    def meet(self, gate, known, most):
        """5: the first vertices that the search meets."""
        known = set(known)
        met = []
        queue = [gate]
        marked = {gate}
        for f in queue:
            for e in range(3):
                g, d = divmod(self.mate[3 * f + e], 3)
                if g in marked or len(queue) == LOOKED_AT:
                    continue
                marked.add(g)
                if self.state[g] == BORDER:
                    continue
                queue.append(g)
                v = self.triple(g)[d]
                if v not in known:
                    known.add(v)
                    met.append(v)
                    if len(met) == most:
                        return met
        return met

    def exit(self, cell):
        facets = [f for f in range(4 * cell, 4 * cell + 4) if self.state[f] == OPEN]
        return min(facets, key=lambda f: (-sum(self.fan[3 * f : 3 * f + 3]), f), default=NONE)
