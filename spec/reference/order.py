"""Chapter 13: the order of the mesh before it was encoded."""

import bisect
import itertools
import math

from beside import NO_TUPLE
from companions import QUADRATIC_TET
from container import CELL, COMPANION, CORNER, MESH, POINT
from conventions import NONE, Bytes, clamp
from errors import require
from flags import Stream
from sizes import Sizes
from tuples import Echo
from values import LINEAR, shares

WALK, LOWEST, HIGHEST, FIRST = range(4)
PERMUTATIONS = list(itertools.permutations(range(4)))
EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
MASK32 = 2**32 - 1


class Order:
    def __init__(self, data, shape, mesh, elements, make_stream=Stream):
        self.shape = shape
        self.mesh = mesh
        self.elements = elements
        bytes = Bytes(data)
        told = bytes.u8()
        self.cells_first = bool(told & 1)
        self.turns_by_points = bool(told & 2)
        self.guesses_points = bool(told & 4)
        self.guesses_cells = bool(told & 8)
        self.cells_by = told >> 4 & 3
        require(told < 64, "told")
        require(not self.cells_first or not told & 6, "told: cells_first")
        require(self.cells_by == WALK or not told & 9, "told: cells_by")
        self.by = []
        for b in mesh.companions:
            self.by.append(bytes.u8())
            require(self.by[-1] < 4, "by of companions")
            require(len(b.cells) < 2**30 and len(b.cells) * b.nodes_per_cell < 2**30, "too many companions")
        self.stream = make_stream(bytes.take(bytes.left()), "attributes")
        self.old_point = None
        self.read()
        self.stream.end()

    def flag(self, name, *coordinates):
        return self.stream.flag(self.stream.blocks[name], *coordinates)

    def read(self):
        if self.cells_first:
            self.read_turns()
            self.read_cells()
            self.read_points()
        else:
            self.read_points()
            self.read_turns()
            self.read_cells()
        self.companion_turns = []
        self.old_companion = []
        for b, by in zip(self.mesh.companions, self.by):
            turns = self.read_companion_turns(b)
            self.companion_turns.append(turns)
            nodes = []
            for cell, turn in zip(b.cells, turns):
                old = [self.old_point[p] for p in cell]
                nodes.append([old[(i - turn) % len(old)] for i in range(len(old))])
            self.old_companion.append(self.numbers(self.sorted_by(by, nodes)))
        self.old_tuple = []
        for a in self.mesh.attributes:
            told = a.pooled and a.count > 0
            self.old_tuple.append(self.numbers(range(a.tuples)) if told else None)

    # The orders in which numbers are told

    def read_points(self):
        points = self.elements.by_place[POINT]
        order = range(points.count)
        if self.cells_first:
            order = []
            met = set()
            for c in self.by_old_cell():
                for p in self.old_corners(c):
                    if p not in met:
                        met.add(p)
                        order.append(p)
            order += [p for p in range(points.count) if p not in met]
        self.old_point = self.numbers(order, points if self.guesses_points else None)

    def by_old_cell(self):
        order = [0] * len(self.old_cell)
        for c, old in enumerate(self.old_cell):
            order[old] = c
        return order

    def old_corners(self, c):
        """The points of cell c, in the order of its old corners."""
        cell = self.mesh.cells[c]
        old = [0] * len(cell)
        for i, p in enumerate(cell):
            old[self.old_corner(c, i)] = p
        return old

    def old_corner(self, c, i):
        if self.shape.tets:
            return PERMUTATIONS[self.turns[c]][i]
        return (self.turns[c] + i) % len(self.mesh.cells[c])

    def read_cells(self):
        cells = self.elements.by_place[CELL]
        nodes = None
        if self.cells_by != WALK:
            nodes = [[self.old_point[p] for p in self.old_corners(c)] for c in range(cells.count)]
        order = self.sorted_by(self.cells_by, nodes) if nodes is not None else range(cells.count)
        self.old_cell = self.numbers(order, cells if self.guesses_cells else None)

    @staticmethod
    def sorted_by(by, nodes):
        if by == WALK:
            return range(len(nodes))

        def key(e):
            if by == LOWEST:
                keys = sorted(set(nodes[e]))
            elif by == HIGHEST:
                keys = sorted(set(nodes[e]), reverse=True)
            else:
                keys = nodes[e]
            return (keys[:4] + [-1] * 4)[:4]

        return sorted(range(len(nodes)), key=key)

    # 13.1

    def numbers(self, order, guessing=None):
        """The old numbers of the elements; `guessing` are the elements where there are guesses."""
        order = list(order)
        N = len(order)
        left = list(range(N))
        is_left = [True] * N
        number_of = [None] * N
        last = MASK32
        ways = 0
        was_near = False
        before = None
        echo = Echo(N)
        sizes = Sizes(self.stream, 1)
        for e in order:
            near = [before] if before is not None else []
            guess = math.nan
            if guessing:
                found = guessing.beside(e)
                guess = self.guess(guessing, e, found, number_of)
                for i, b in enumerate(found[:3]):
                    near[i : i + 1] = [b.element]
            # 1
            step = echo.value()
            echoed = NONE if step is None else (last + step) & MASK32
            at = bisect.bisect_right(left, last) if last != MASK32 else 0
            next = left[at] if at < len(left) else left[0]
            has_guess = math.isfinite(guess)
            guessed = math.floor(clamp(guess, 0.0, 2.0**32) + 0.5) if has_guess else last

            def there(x):
                return 0 <= x < N and is_left[x]

            # 2
            way = 0
            if there(echoed) and self.flag("number_echo", echo.held_class()):
                way = 1
                number = echoed
            elif next != echoed and self.flag("number_next", ways):
                way = 2
                number = next
            elif has_guess and there(guessed) and guessed not in (next, echoed) and self.flag("number_guess", ways):
                way = 3
                number = guessed
            ways = (4 * ways + way) % 16
            # 3
            magnitudes = [0, 0, 0]
            if way == 0:
                sizes.begin(near, 0)
                was_near = self.flag("number_near", was_near)
                if was_near:
                    number = self.read_near(guessed, sizes, left)
                    magnitudes = None
                else:
                    number = left[self.stream.below(len(left))]
                    magnitudes = sizes.half
            require(there(number), "an order that is no permutation")
            sizes.keep(e, magnitudes)
            # 4
            is_left[number] = False
            left.pop(bisect.bisect_left(left, number))
            number_of[e] = number
            echo.step((number - last) & MASK32)
            last = number
            before = e
        return number_of

    def read_near(self, guessed, sizes, left):
        return guessed + sizes.residual(0)

    @staticmethod
    def guess(elements, e, found, number_of):
        places = [elements.place(b.element) for b in found]
        share = shares(LINEAR, found, places, elements.place(e))
        guess = 0.0
        for b, s in zip(found, share):
            guess = guess + s * float(number_of[b.element])
        return guess

    # 13.2

    def small(self, n, c):
        for k in range(min(n - 2, 7) + 1):
            if self.flag("turn", c, 0, k):
                return k
        if n <= 9:
            return n - 1
        return self.stream.plain_below(n, "a turn that the cell has not")

    # 13.3

    def read_turns(self):
        self.turns = []
        self.last_turn = 0
        for c, cell in enumerate(self.mesh.cells):
            if self.shape.tets:
                self.turns.append(self.read_tet_turn(c, cell))
            elif len(cell) <= 1:
                self.turns.append(0)
            elif self.turns_by_points:
                self.turns.append(self.read_turn_by_points(cell))
            else:
                self.turns.append(self.small(len(cell), self.left_by(c)))

    def read_turn_by_points(self, nodes):
        n = len(nodes)
        p = self.small(n, self.last_turn)
        self.last_turn = min(p, 7)
        old = [self.old_point[q] for q in nodes]
        return (p + n - old.index(min(old))) % n

    def left_by(self, c):
        gate = self.shape.walk.gate[c]
        if gate == NONE:
            return 8
        g = self.shape.cell_of[gate]
        i = self.shape.element_of[gate] - self.shape.first[g]
        return min(self.old_corner(g, i), 7)

    def read_tet_turn(self, c, cell):
        rank = [0, 1, 2, 3]
        if self.turns_by_points:
            old = [self.old_point[p] for p in cell]
            rank = [sum((old[j], j) < (old[i], i) for j in range(4)) for i in range(4)]
        context = self.last_turn if self.turns_by_points else self.left_by(c)
        rest = [0, 1, 2, 3]

        def take(most, second):
            for k in range(most):
                if self.flag("turn", context, second, k):
                    return rest.pop(k)
            return rest.pop()

        first = take(3, 1)
        second = take(2, 2 + first)
        of_old = [first, second, *rest]  # the rank of each old corner
        if parity(of_old) != parity(rank):
            of_old[2], of_old[3] = of_old[3], of_old[2]
        if self.flag("turn", 0, 6, 0):
            of_old[2], of_old[3] = of_old[3], of_old[2]
        self.last_turn = 2 * first + (second > first) if self.turns_by_points else 0
        return PERMUTATIONS.index(tuple(of_old.index(rank[i]) for i in range(4)))

    def read_companion_turns(self, b):
        self.last_turn = 0
        turns = [0] * len(b.cells)
        if b.nodes_per_cell == 3:
            for i in range(b.marks):
                turns[i] = self.read_turn_by_points(b.cells[i])
        return turns


def parity(numbers):
    return sum(a > b for a, b in itertools.combinations(numbers, 2)) % 2


# 13.4


def moved(values, old):
    result = [None] * len(values)
    for x, i in zip(values, old):
        result[i] = x
    return result


def restore(order):
    """The old mesh, in place."""
    mesh = order.mesh
    old_point, old_cell = order.old_point, order.old_cell
    # where each corner of the new mesh was: old cells follow each other by their degrees
    degree = [len(cell) for cell in mesh.cells]
    old_first = list(itertools.accumulate(moved(degree, old_cell), initial=0))
    old_element = []
    for c in range(len(mesh.cells)):
        old_element += [old_first[old_cell[c]] + order.old_corner(c, i) for i in range(degree[c])]
    old_companion = []
    for b, own in zip(mesh.companions, order.old_companion):
        old_companion += [len(old_companion) + i for i in own]
    old_of = {POINT: old_point, CORNER: old_element, CELL: old_cell, COMPANION: old_companion}
    # attributes
    for a, old_tuple in zip(mesh.attributes, order.old_tuple):
        for r in a.references:
            refer(a, r, old_cell if r.to_cells else old_point)
        if a.place == MESH:
            continue
        if not a.pooled:
            a.values = moved(a.values, old_of[a.place])
            continue
        if old_tuple is not None:
            a.values = moved(a.values, old_tuple)
            a.indices = [t if t == NO_TUPLE else old_tuple[t] for t in a.indices]
        a.indices = moved(a.indices, old_of[a.place])
    # companions
    for b, own, turns in zip(mesh.companions, order.old_companion, order.companion_turns):
        cells = []
        for i, cell in enumerate(b.cells):
            cell = [old_point[p] for p in cell]
            if b.vtk_type == QUADRATIC_TET and b.nodes_per_cell == 6 and b.hosts:
                cell = move_edges(cell, PERMUTATIONS[order.turns[b.hosts[i]]])
            cells.append([cell[(k - turns[i]) % len(cell)] for k in range(len(cell))])
        b.cells = moved(cells, own)
        if b.hosts:
            b.hosts = moved([old_cell[h] for h in b.hosts], own)
    # cells and points
    mesh.cells = moved([[old_point[p] for p in order.old_corners(c)] for c in range(len(mesh.cells))], old_cell)
    mesh.points = moved(mesh.points, old_point)


def move_edges(nodes, permutation):
    """The mid-edge nodes of a tet whose new corner i is old corner permutation[i]."""
    result = [None] * 6
    for (a, b), node in zip(EDGES, nodes):
        ends = {permutation[a], permutation[b]}
        result[next(k for k, edge in enumerate(EDGES) if set(edge) == ends)] = node
    return result


def refer(a, r, old):
    for t, value in enumerate(a.values):
        n = (value[r.component] - r.base) % 2**64
        if n < len(old):
            new = list(value)
            new[r.component] = old[n] + r.base
            a.values[t] = tuple(new)
