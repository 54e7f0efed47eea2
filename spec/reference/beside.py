"""11.2: what is beside an element."""

import math
from collections import namedtuple

from container import CORNER
from conventions import NONE
from guesses import PLACES, ROWS

MOST_BESIDE = 12
MOST_CORNERS = 16
NO_TUPLE = 2**64 - 1  # the index of an element without a tuple

Beside = namedtuple("Beside", "element kind share", defaults=(0, 0))


def base_factors(configuration):
    return ROWS[configuration][0]


class Points:
    def __init__(self, shape, companions):
        self.shape = shape
        self.count = len(shape.mesh.points)
        self.hint_of = [3] * self.count
        for b in companions:
            if b.kind != 1 and b.nodes_per_cell > 0:
                for p in {p for cell in b.cells for p in cell}:
                    self.hint_of[p] = min(self.hint_of[p], min(b.nodes_per_cell, 4) - 1)
        for p in shape.points_on_border():
            self.hint_of[p] += 4

    def hint(self, e):
        return self.hint_of[e]

    def beside(self, e):
        edge = e - self.shape.block.points
        if 0 <= edge < len(self.shape.walk.edges.ends):
            ends = self.shape.walk.edges.ends[edge]
            return [Beside(self.shape.mesh.point_of[v], i) for i, v in enumerate(ends)]
        if edge >= 0:
            return [Beside(e - 1)] if e > 0 else []
        configuration, stencil = self.shape.walk.stencils[self.shape.mesh.vertex_of[e]]
        if configuration == "led":
            stencil = stencil[:7]
        stencil = stencil + [NONE] * (PLACES - len(stencil))
        factors = [0] * PLACES
        if configuration in ROWS:
            base = base_factors(configuration)
            if all(p != NONE for p, factor in zip(stencil, base) if factor):
                factors = base
        return [
            Beside(self.shape.mesh.point_of[p], 0 if i == 0 else 1, factors[i])
            for i, p in enumerate(stencil)
            if p != NONE
        ]

    def place(self, e):
        return self.shape.place[e]


class Cells:
    def __init__(self, shape):
        self.shape = shape
        self.count = shape.cells

    def hint(self, e):
        return 0

    def beside(self, e):
        shape = self.shape
        gate = shape.walk.gate[e]
        entry = shape.twin[gate] if gate != NONE else NONE
        found = [Beside(shape.cell_of[gate])] if gate != NONE else []
        for f in shape.corners(e):
            t = shape.twin[f]
            if f != entry and t != NONE and shape.cell_of[t] < e:
                found.append(Beside(shape.cell_of[t], 1))
        if not found and e > 0:
            found.append(Beside(e - 1, 2))
        return found[:MOST_BESIDE]

    def place(self, e):
        corners = self.shape.corners(e)[:MOST_CORNERS]
        return mean([self.shape.at(c) for c in corners]) if corners else (math.nan, math.nan, math.nan)


class Companions:
    def __init__(self, links):
        self.links = links
        self.count = len(links.nodes)

    def hint(self, e):
        return 0

    def beside(self, e):
        found = []
        for f in self.links.links(e):
            t = self.links.twin(f)
            if t != NONE and self.links.element(t) < e:
                found.append(Beside(self.links.element(t)))
        if not found and e > 0:
            found.append(Beside(e - 1, 1))
        return found[:MOST_BESIDE]

    def place(self, e):
        nodes = self.links.nodes[e][: max(1, len(self.links.links(e)))]
        return mean([self.links.place[p] for p in nodes])


class Mesh:
    count = 0

    def hint(self, e):
        return 0

    def beside(self, e):
        return [Beside(t) for t in (e - 1, e - 2) if t >= 0]

    def place(self, e):
        return (float(e), 0.0, 0.0)


class Corners:
    """`tuple_of` has the tuples of the elements told so far, and None where there is none yet."""

    def __init__(self, shape):
        self.shape = shape
        self.count = len(shape.vertex)
        self.same_vertex = {}
        for c, v in enumerate(shape.vertex):
            self.same_vertex.setdefault(v, []).append(c)

    def place(self, e):
        return self.shape.at(self.shape.walk_corner[e])

    def before_at_vertex(self, c):
        """The corners before c with its vertex, latest first."""
        same = self.same_vertex[self.shape.vertex[c]]
        return reversed(same[: same.index(c)])

    def beside_for_tuples(self, e, tuple_of):
        """What is beside e, and the hint."""
        shape = self.shape
        c = shape.walk_corner[e]
        K = shape.cell_of[c]
        element = shape.element_of
        neighbours = []  # (order, agreement, element)
        order = {1: 0, 0: 1, 2: 2}

        def neighbour(corner, ends):
            agreement = 0
            if ends and element[ends[0]] < e:
                agreement = 1 if tuple_of[element[ends[0]]] == tuple_of[element[ends[1]]] else 2
            neighbours.append((order[agreement], agreement, element[corner]))

        if shape.tets:
            for f in shape.corners(K):
                t = shape.twin[f]
                if f != c and t != NONE and shape.cell_of[t] < K:
                    for j in shape.corners(shape.cell_of[t]):
                        if shape.vertex[j] == shape.vertex[c]:
                            neighbour(j, None)
        else:
            a = shape.twin[c]
            if a != NONE and shape.cell_of[a] < K:
                neighbour(shape.succ(a), (shape.succ(c), a))
            b = shape.twin[shape.pred(c)]
            if b != NONE and shape.cell_of[b] < K:
                neighbour(b, (shape.pred(c), shape.succ(b)))
        neighbours.sort(key=lambda n: n[0])
        hint = neighbours[0][1] + 3 if neighbours else 0
        found = [Beside(n[2]) for n in neighbours]
        for i, j in enumerate(self.before_at_vertex(c)):
            if i == 6:
                break
            if element[j] < e:
                found.append(Beside(element[j], 1))
        if e > 0 and shape.cell_of[shape.walk_corner[e - 1]] == K:
            found.append(Beside(e - 1, 2))
        return found[:MOST_BESIDE], hint

    def beside_for_values(self, e, known, tuple_of=None):
        """`known` tells whether an element is known; `tuple_of` only if values are those of tuples."""
        shape = self.shape
        c = shape.walk_corner[e]
        K = shape.cell_of[c]
        n = shape.degree(K)
        found = []

        def knows(corner):
            return known(shape.element_of[corner])

        def add(corner, share=0):
            found.append(Beside(shape.element_of[corner], 0, share))

        if shape.tets:
            for j in shape.corners(K):
                if j != c and knows(j):
                    add(j)
        elif n >= 3:
            next = shape.succ(c)
            prev = shape.pred(c)
            opposite = shape.succ(next)
            if n == 4 and knows(next) and knows(prev) and knows(opposite):
                add(next, 1)
                add(prev, 1)
                add(opposite, -1)
            else:
                for j in (prev, next, opposite) if n > 3 else (prev, next):
                    if knows(j):
                        add(j)
        for f in shape.corners(K)[:MOST_CORNERS]:
            g = shape.twin[f]
            if g == NONE:
                continue
            beyond = shape.corners(shape.cell_of[g])[:MOST_CORNERS]
            if not shape.tets:
                if tuple_of:
                    element = shape.element_of
                    if (
                        tuple_of[element[f]] != tuple_of[element[shape.succ(g)]]
                        or tuple_of[element[shape.succ(f)]] != tuple_of[element[g]]
                    ):
                        continue
                beyond = [j for j in beyond if j not in (g, shape.succ(g))]
            for j in beyond:
                if knows(j):
                    add(j)
        if not found:
            for j in self.before_at_vertex(c):
                if knows(j):
                    add(j)
                    break
        return found[:MOST_BESIDE]


def mean(places):
    if not places:
        return (0.0, 0.0, 0.0)
    total = [0.0, 0.0, 0.0]
    for p in places:
        total = [total[k] + p[k] for k in range(3)]
    return tuple(x / len(places) for x in total)


class Tuples:
    """Of a pool: what is beside a tuple stands beside the first element that has it."""

    def __init__(self, place, elements, tuple_of, stored):
        self.is_corner = place == CORNER
        self.elements = elements
        self.tuple_of = tuple_of
        self.element_of = [None] * stored
        self.all_elements = [[] for _ in range(stored)]
        for e, t in enumerate(tuple_of):
            if t != NO_TUPLE:
                if self.element_of[t] is None:
                    self.element_of[t] = e
                self.all_elements[t].append(e)

    def beside(self, t):
        e = self.element_of[t]
        found = []
        if e is not None:
            tuple_of = self.tuple_of
            if self.is_corner:
                near = self.elements.beside_for_values(
                    e, lambda x: tuple_of[x] != NO_TUPLE and tuple_of[x] < t, tuple_of)
            else:
                near = self.elements.beside(e)
            found = [b for b in near if tuple_of[b.element] != NO_TUPLE and tuple_of[b.element] < t]
            spoilt = any(b.share != 0 and b not in found for b in near)
            found = [Beside(tuple_of[b.element], b.kind, 0 if spoilt else b.share) for b in found]
        if not found and t > 0:
            found = [Beside(t - 1)]
        return found

    def place(self, t):
        e = self.element_of[t]
        return (0.0, 0.0, 0.0) if e is None else self.elements.place(e)
