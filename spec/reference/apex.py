"""7.3, 7.4, the end of 7.5: the apex of a tet."""

from conventions import NONE, dot, minus
from errors import require
from spheres import Spheres, longest, normal
from walk import BORDER

MOST = 12
HEIGHT_BOUNDS = (-0.5, 0.0, 0.2, 0.35, 0.5, 0.67, 0.9, 1.2, 1.6, 2.2, 3.5, 7.7)
STEEPNESS_BOUNDS = (0.09, 0.3025, 0.64, 1.21)
REACH_BOUNDS = (3.24, 5.76, 10.24)


class Candidate:
    def __init__(self, vertex, height):
        self.vertex = vertex
        self.height = height  # None: not above
        self.times = 0
        self.fan = 0

    def above(self):
        return self.height is not None


class Apex:
    """One apex being read: `corners` are corners 0, 1, 2 of the new tet."""

    def __init__(self, walk, gate, corners):
        self.walk = walk
        self.gate = gate
        self.corners = corners
        self.spheres = Spheres(*(walk.place(v) for v in corners), walk.block.mirrored)
        self.list = []
        self.worth = 0 if self.spheres.flat else self.spheres.unit / 32

    def rank(self, c):
        if c.above():
            return c.height - self.worth * c.times
        return 1e300 / (1 + c.times)

    def put_in_order(self):
        """By rank; sort keeps what is equal in the order it came."""
        self.list.sort(key=self.rank)

    def find(self, v):
        return next((c for c in self.list if c.vertex == v), None)

    def search(self, h):
        return self.walk.grid.search(self.spheres, h, self.walk.place, self.corners)

    def read(self):
        """7.3: the kind, and the vertex unless it is fresh."""
        walk, list, spheres = self.walk, self.list, self.spheres
        # 1
        borders = 0
        for e in range(3):
            v = walk.apex_across(self.gate, e)
            beyond = walk.state[walk.across(self.gate, e)] == BORDER
            borders += beyond
            if walk.open_count[v] == 0 or v in self.corners:
                continue
            c = self.find(v)
            if not c:
                c = Candidate(v, None if spheres.flat else spheres.height(walk.place(v)))
                list.append(c)
            c.times += 1
            if not beyond:
                c.fan = max(c.fan, walk.fan[3 * self.gate + e])
        # 2
        if not spheres.flat and not any(c.above() and c.times >= 2 for c in list):
            self.find_near()
        self.put_in_order()
        # 3
        h = 13
        t = 0
        if list:
            c = list[0]
            h = self.height_class(c)
            t = c.times
            looks = 4 * self.steepness(c.vertex) + self.reach(c.vertex)
            if walk.flag("kLowest", (h + 1) >> 1, self.fold_class(c), self.gap_class(), looks):
                return self.told(c)
        # 4
        if walk.flag("kNew", h, t, borders, self.second_class()):
            return "fresh", NONE
        # 5
        del list[MOST:]
        for i in range(1, len(list)):
            c = list[i]
            if walk.flag("kNext", i - 1, c.times, c.above()):
                return self.told(c)
        # 6
        above = -1e300
        for m in () if spheres.flat else (4.0, 10.0):
            if walk.flag("kNear", 0):
                rank = walk.number("kNearRank")
                far = [
                    (height, v)
                    for v, height in self.search(m * spheres.unit)
                    if height > above and not self.find(v)
                ]
                require(rank < 64 and rank < len(far), "apex by rank that is not there")
                return "old", sorted(far)[rank][1]
            above = m * spheres.unit
        # 7
        age = walk.number("kOldFar")
        require(age < walk.vertex_count, "apex by age that does not exist")
        return "old", walk.vertex_count - 1 - age

    def told(self, c):
        return ("fold" if c.times > 0 else "old"), c.vertex

    def height_class(self, c):
        if not c.above():
            return 13
        m = c.height / self.spheres.unit
        return sum(m > bound for bound in HEIGHT_BOUNDS)

    def fold_class(self, c):
        if c.times == 0:
            return 0
        return (1 if c.times == 1 else 3) + (c.fan > 2)

    def gap_class(self):
        list = self.list
        if not list[0].above() or len(list) < 2 or not list[1].above():
            return 3
        g = (list[1].height - list[0].height) / self.spheres.unit
        return 0 if g < 0.03 else 1 if g < 0.12 else 2 if g < 0.35 else 3

    def second_class(self):
        list = self.list
        if len(list) < 2 or not list[1].above():
            return 5
        m = list[1].height / self.spheres.unit
        return 0 if m < 0.35 else 1 if m < 0.67 else 2 if m < 1.2 else 3 if m < 2.2 else 4

    # 7.5

    def steepness(self, v):
        p = [self.walk.place(corner) for corner in self.corners]
        N = normal(p)
        d = dot(minus(self.walk.place(v), p[0]), N)
        high = d * d
        wide = dot(N, N) * longest(p)
        return sum(high >= bound * wide for bound in STEEPNESS_BOUNDS)

    def reach(self, v):
        ways = [minus(self.walk.place(v), self.walk.place(corner)) for corner in self.corners]
        farthest = max(dot(w, w) for w in ways)
        return sum(farthest >= bound * self.walk.grid.unit for bound in REACH_BOUNDS)

    # 7.4

    def find_near(self):
        lowest = min((c.height for c in self.list if c.above()), default=1e300)
        for multiple in (1.0, 2.0):
            h = min(multiple * self.spheres.unit, lowest)
            found = [(v, height) for v, height in self.search(h) if not self.find(v)]
            for v, height in found:
                self.list.append(Candidate(v, height))
            if found or h == lowest:
                break
