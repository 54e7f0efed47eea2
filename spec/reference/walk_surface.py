"""Chapter 6: the walk over surfaces."""

from conventions import NONE, dot, minus
from errors import require
from walk import BORDER, GONE, OPEN, Walk


class SurfaceWalk(Walk):
    def __init__(self, head, block, stream, positions):
        super().__init__(head, block, stream, positions)
        self.next = []
        self.prev = []
        self.seen = []

    # 6.1

    def add_vertex(self):
        self.seen.append(0)

    def degree(self, cell):
        return self.first[cell + 1] - self.first[cell]

    def succ(self, f):
        cell = self.cell_of[f]
        return f + 1 if f + 1 < self.first[cell + 1] else self.first[cell]

    def pred(self, f):
        cell = self.cell_of[f]
        return f - 1 if f > self.first[cell] else self.first[cell + 1] - 1

    def start(self, f):
        return self.vertex[self.succ(f)]

    def end(self, f):
        return self.vertex[f]

    def place(self, v):
        """5.3"""
        return self.positions.value[v]

    def join(self, f, g):
        self.next[f] = g
        self.prev[g] = f

    def zip(self, s, f):
        self.twin[s] = f
        self.twin[f] = s
        self.state[f] = GONE

    # 5.1

    def exit(self, cell):
        for f in range(self.first[cell], self.first[cell + 1]):
            if self.state[f] == OPEN:
                return f
        return NONE

    # 6.2

    def angle(self, at, start, to):
        u = minus(self.place(start), self.place(at))
        v = minus(self.place(to), self.place(at))
        uv = dot(u, v)
        square = dot(u, u) * dot(v, v)
        if not square > 0:
            return 0
        c = -(uv * uv) if uv < 0 else uv * uv
        bounds = (0.75, 0.5, 0.067, -0.067, -0.329476, -0.670761, -0.8836)
        for i, bound in enumerate(bounds):
            if c > bound * square:
                return i + 1
        return 8

    def gate_angles(self, gate):
        if gate == NONE:
            return 25
        coarse = (3, 0, 0, 1, 2, 3, 3, 3, 3)
        after = self.next[gate]
        before = self.prev[gate]
        a = b = 4
        if self.state[after] == OPEN:
            a = coarse[self.angle(self.end(gate), self.start(gate), self.end(after))]
        if self.state[before] == OPEN:
            b = coarse[self.angle(self.start(gate), self.end(gate), self.start(before))]
        return 5 * a + b

    # 6.3

    def read_degree(self, gate):
        if self.block.uniform_degree != 0:
            return self.block.uniform_degree
        across = 0
        if gate != NONE:
            across = {4: 0, 3: 1, 5: 2}.get(self.degree(self.cell_of[gate]), 3)
        angles = self.gate_angles(gate)
        for i, n in enumerate((4, 3, 5, 6, 7, 8)):
            if self.flag("kDegree", across, angles, i):
                return n
        r = self.number("kDegreeRest")
        require(r <= 2 or r < self.block.corners, "kDegreeRest")
        return r if r <= 2 else r + 6

    def visit(self, gate):
        n = self.read_degree(gate)
        require(len(self.vertex) + n <= self.block.corners, "corners beyond `corners`")
        require(n >= 2 or gate == NONE, "degree below 2 behind a gate")
        base = self.add_facets(n)
        self.next += [NONE] * n
        self.prev += [NONE] * n
        if gate == NONE:
            self.place_seed(base, n)
        else:
            self.place_cell(gate, base, n)
        for f in range(base, base + n):
            v = self.vertex[f]
            self.seen[v] = min(self.seen[v] + 1, 255)
            if self.state[f] == BORDER:
                self.on_border[v] = 1
                self.on_border[self.vertex[self.succ(f)]] = 1

    # 6.4

    def place_seed(self, base, n):
        for i in range(n):
            k = self.vertex_count
            if n == 4 and i == 3:
                self.new_vertex(base + i, "quad_fourth", [k - 3, k - 1, k - 2])
            elif i >= 1:
                self.new_vertex(base + i, "seed", [k - 1 - j for j in range(min(i, 3))], variant=min(i, 2))
            else:
                self.new_vertex(base + i, "seed", [k - 1] if k > 0 else [])
        for i in range(n):
            self.make_front(base + i, base + i - 1 if i > 0 else NONE, True, True, False, False)
        for i in range(n):
            self.join(base + i, base + (i - 1) % n)

    def make_front(self, f, before, start_new, end_new, near_start, near_end):
        s = self.vertex[f]
        e = self.vertex[self.succ(f)]
        if s == e:
            self.state[f] = BORDER
        elif not self.block.has_border:
            self.state[f] = OPEN
        else:
            b = near_start or (before != NONE and self.state[before] == BORDER)
            x = 0 if start_new else 1 + self.on_border[s]
            y = 0 if end_new else 1 + self.on_border[e]
            self.state[f] = BORDER if self.flag("kBorder", b, near_end, x, y) else OPEN

    # 6.5

    def place_cell(self, gate, base, n):
        vertex, state, next, prev = self.vertex, self.state, self.next, self.prev
        dc = {4: 0, 3: 1}.get(n, 2)
        # 1
        vertex[base] = self.start(gate)
        vertex[base + 1] = self.end(gate)
        after = next[gate]
        before = prev[gate]
        self.zip(base, gate)
        # 2: zips to the right
        r = 1
        while r < n and state[after] == OPEN:
            if (next[after] == gate) != (r + 1 == n):
                break
            v = vertex[base + r]
            angle = self.angle(v, vertex[base + r - 1], self.end(after))
            if not self.flag("kZipRight", dc, self.seen[v] - 1, angle, 1 if r == 1 else 0):
                break
            self.zip(base + r, after)
            r += 1
            if r < n:
                vertex[base + r] = self.end(after)
            after = next[after]
        if r == n:
            return
        # 3: zips to the left
        l = n
        while l > r + 1 and state[before] == OPEN:
            v = vertex[base] if l == n else vertex[base + l]
            w = vertex[base + 1] if l == n else vertex[base] if l == n - 1 else vertex[base + l + 1]
            angle = self.angle(v, w, self.start(before))
            if not self.flag("kZipLeft", dc, self.seen[v] - 1, angle, 1 if l == n else 0):
                break
            l -= 1
            self.zip(base + l, before)
            vertex[base + l] = self.start(before)
            before = prev[before]
        # 4: corners between
        border_after = 1 if state[after] == BORDER else 0
        border_before = 1 if state[before] == BORDER else 0
        gap = [NONE] * (n + 1)
        gap[r] = after
        fresh = [False] * (n + 1)
        zipped = [False] * (n + 1)
        for i in range(r + 1, l):
            g = gap[i - 1]
            if (
                i - 1 > r
                and g != NONE
                and state[g] == OPEN
                and self.flag("kZipMiddle", dc, self.seen[vertex[base + i - 1]] - 1)
            ):
                self.zip(base + i - 1, g)
                zipped[i - 1] = True
                vertex[base + i] = self.end(g)
                gap[i] = next[g]
            elif self.flag("kNew", dc, r - 1, n - l, border_after + border_before):
                fresh[i] = True
                self.new_vertex(base + i, *self.stencil(gate, base, n, r, l, i, before, after))
            else:
                g = self.old_corner(base, before, after)
                gap[i] = g
                vertex[base + i] = self.start(g)
        # 5: sides between
        for i in range(r, l):
            if not zipped[i]:
                self.make_front(
                    base + i,
                    NONE if i == r or zipped[i - 1] else base + i - 1,
                    fresh[i],
                    i + 1 < l and fresh[i + 1],
                    i == r and border_after,
                    i + 1 == l and border_before,
                )
        # 6: the front
        arrive = {}
        for i in range(r + 1, l):
            if not fresh[i] and not zipped[i - 1]:
                arrive[i] = prev[gap[i]]
        for i in range(r, l):
            if i > r and fresh[i]:
                self.join(base + i, base + i - 1)
                continue
            if i > r and not zipped[i - 1]:
                self.join(arrive[i], base + i - 1)
            if not zipped[i]:
                self.join(base + i, gap[i])
        self.join(before, base + l - 1)

    # 6.6

    def beyond(self, f):
        return self.vertex[self.succ(self.succ(f))], self.vertex[self.pred(f)]

    def far(self, f):
        t = self.twin[self.succ(self.succ(f))]
        if self.degree(self.cell_of[f]) == 4 and t != NONE:
            return self.beyond(t)
        return NONE, NONE

    def stencil(self, gate, base, n, r, l, i, before, after):
        def corner(j):
            return self.vertex[base + j]

        a = corner(0)
        b = corner(1)
        u_start, u_end = self.beyond(gate)
        w_start, w_end = self.far(gate)
        if n == 3:
            return self.triangle_stencil(a, b, u_start, u_end, before, after)
        if n == 4 and r == 2:
            t = self.twin[base + 1]
            v_start, v_end = self.beyond(t)
            x_start, x_end = self.far(t)
            return "quad_corner", [
                a, corner(2), b, u_start, u_end, w_start, w_end, v_end, v_start, x_end, x_start]
        if n == 4 and l == 3:
            t = self.twin[base + 3]
            v_start, v_end = self.beyond(t)
            x_start, x_end = self.far(t)
            return "quad_corner", [
                b, corner(3), a, u_end, u_start, w_end, w_start, v_start, v_end, x_start, x_end]
        if n == 4 and i == 2:
            return "quad_third", [b, a, u_end, u_start, w_end, w_start]
        if n == 4:
            return "quad_fourth", [a, corner(2), b, u_start, u_end, w_start, w_end]
        return "polygon", [
            corner(i - 1),
            corner(i - 2),
            corner(i - 3) if i >= 3 else u_start,
            corner(i + 1) if i + 1 < n else a,
        ]

    def triangle_stencil(self, a, b, u_start, u_end, before, after):
        x = self.start(before)
        y = self.end(after)
        s = self.beyond(after)[0]
        t = self.beyond(before)[1]
        of_a = min(max(self.seen[a], 2), 5) - 2
        of_b = min(max(self.seen[b], 2), 5) - 2
        h = max(of_a, of_b)
        variant = h * (h + 1) // 2 + min(of_a, of_b)
        if of_a <= of_b:
            return "triangle", [a, b, u_start, u_end, y, x, s, t], (), variant
        return "triangle", [b, a, u_end, u_start, x, y, t, s], (), variant

    # 6.7

    def old_corner(self, base, before, after):
        if self.flag("kOldNear", 0):
            back = self.flag("kOldSide", 0)
            d = self.number("kOldSteps")
            require(d < 64, "old corner: 64 steps or more")
            g = before if back else self.next[after]
            for _ in range(d):
                g = self.prev[g] if back else self.next[g]
        else:
            age = self.number("kOldFar")
            require(age < base, "old corner: a facet that does not exist")
            g = base - 1 - age
        require(self.state[g] != GONE, "old corner: a facet that is not on the front")
        require(self.state[self.prev[g]] != GONE, "old corner: a facet whose neighbour is not on the front")
        return g
