"""Chapter 13: the order of the mesh before it was encoded."""

import bisect
import itertools
import math

from companions import QUADRATIC_TET
from container import CELL, POINT
from conventions import NONE, Bytes, clamp
from edges import move_edges
from errors import require
from flags import Stream
from sizes import SEED, Sizes
from tuples import Echo
from values import LINEAR, shares

WALK, LOWEST, HIGHEST, FIRST, HOSTS = range(5)
PERMUTATIONS = list(itertools.permutations(range(4)))
AS_THEY_COME, BY_ENDS, BY_CELLS, BY_CELLS_OF_GMSH = range(4)
MASK32 = 2**32 - 1


class Numbers:
    """13.1: numbers that come once, of N elements."""

    def __init__(self, order, N):
        self.order = order
        self.N = N
        self.left = list(range(N))
        self.is_left = [True] * N
        self.number_of = [None] * N
        self.last = MASK32
        self.ways = 0
        self.was_near = False
        self.before = None
        self.echo = Echo(N)
        self.sizes = Sizes(order.stream)

    def tell(self, order, guessing=None):
        """The old numbers of all elements so far; `guessing` are the elements where there are guesses."""
        for e in order:
            near = [self.before] if self.before is not None else []
            guess = math.nan
            if guessing:
                found = guessing.beside(e)
                guess = self.order.guess(guessing, e, found, self.number_of)
                for i, b in enumerate(found[:3]):
                    near[i : i + 1] = [b.element]
            # 1
            step = self.echo.value()
            echoed = NONE if step is None else (self.last + step) & MASK32
            at = bisect.bisect_right(self.left, self.last) if self.last != MASK32 else 0
            next = self.left[at] if at < len(self.left) else self.left[0]
            has_guess = math.isfinite(guess)
            guessed = math.floor(clamp(guess, 0.0, 2.0**32) + 0.5) if has_guess else self.last

            def there(x):
                return 0 <= x < self.N and self.is_left[x]

            # 2
            way = 0
            if there(echoed) and self.order.flag("number_echo", self.echo.held_class()):
                way = 1
                number = echoed
            elif next != echoed and self.order.flag("number_next", self.ways):
                way = 2
                number = next
            elif has_guess and there(guessed) and guessed not in (next, echoed) and self.order.flag("number_guess", self.ways):
                way = 3
                number = guessed
            self.ways = (4 * self.ways + way) % 16
            # 3
            magnitudes = [0, 0, 0]
            if way == 0:
                self.sizes.begin(near, SEED, variant=2)
                self.was_near = self.order.flag("number_near", self.was_near)
                if self.was_near:
                    number = self.order.read_near(guessed, self.sizes, self.left)
                    magnitudes = None
                else:
                    number = self.left[self.order.stream.below(len(self.left))]
                    magnitudes = self.sizes.half
            require(there(number), "an order that is no permutation")
            self.sizes.keep(e, magnitudes)
            # 4
            self.is_left[number] = False
            self.left.pop(bisect.bisect_left(self.left, number))
            self.number_of[e] = number
            self.echo.step((number - self.last) & MASK32)
            self.last = number
            self.before = e
        return self.number_of


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
        self.edges_by = told >> 6
        self.edges = shape.walk.edges
        require(told < 64 or self.edges.ends, "told: edges")
        require(not self.cells_first or not told & 6, "told: cells_first")
        require(self.cells_by == WALK or not told & 9, "told: cells_by")
        self.by = []
        for b in mesh.companions:
            self.by.append(bytes.u8())
            require(self.by[-1] < (5 if b.hosts else 4), "by of companions")
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
        self.read_edge_points()
        self.companion_turns = []
        self.old_companion = []
        for b, by in zip(self.mesh.companions, self.by):
            turns = self.read_companion_turns(b)
            self.companion_turns.append(turns)
            nodes = []
            for cell, turn in zip(b.cells, turns):
                old = [self.old_point[p] for p in cell]
                nodes.append([old[(i - turn) % len(old)] for i in range(len(old))])
            if by == HOSTS:
                order = sorted(range(len(nodes)), key=lambda i: self.old_cell[b.hosts[i]])
            else:
                order = self.sorted_by(by, nodes)
            self.old_companion.append(self.numbers(order))
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
        self.point_numbers = Numbers(self, points.count)
        if self.edges.ends:
            order = order[: self.shape.block.points]
        self.old_point = self.point_numbers.tell(order, points if self.guesses_points else None)

    def read_edge_points(self):
        if not self.edges.ends:
            return
        first = self.shape.block.points
        order = range(len(self.edges.ends))
        if self.edges_by == BY_ENDS:
            point_of = self.shape.mesh.point_of
            order = self.sorted_by(
                LOWEST, [[self.old_point[point_of[v]] for v in ends] for ends in self.edges.ends])
        elif self.edges_by != AS_THEY_COME:
            order = self.edges_of_old_cells()
        told = [first + e for e in order]
        told += range(first + len(told), len(self.mesh.points))
        self.old_point = self.point_numbers.tell(told)

    def edges_of_old_cells(self):
        """As the old cells have them, if a block has them all; then the others."""
        met = dict.fromkeys(())
        first = self.shape.block.points
        for b in self.mesh.companions:
            if b.vtk_type != QUADRATIC_TET or b.nodes_per_cell != 6 or not b.hosts:
                continue
            if len(b.hosts) != len(self.mesh.cells):
                continue
            old = [move_edges(cell, PERMUTATIONS[self.turns[h]]) for cell, h in zip(b.cells, b.hosts)]
            for c in self.by_old_cell():
                nodes = old[c]
                if self.edges_by == BY_CELLS_OF_GMSH:
                    nodes = nodes[:4] + nodes[:3:-1]
                for p in nodes:
                    if first <= p < first + len(self.edges.ends):
                        met.setdefault(p - first)
        for e in range(len(self.edges.ends)):
            met.setdefault(e)
        return list(met)

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
        return Numbers(self, len(order)).tell(order, guessing)

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
