"""Chapter 10: companions."""

from types import SimpleNamespace

from conventions import NONE, Bytes
from errors import require
from flags import Stream
from shape import flatness

QUADRATIC_TET = 24


def read_companions(data, block, shape, make_stream=Stream):
    """The blocks, and the marked facets."""
    bytes = Bytes(data)
    count = bytes.varint()
    require(count == block.companions and count <= bytes.left() // 4, "companions not as many as announced")
    blocks = []
    for _ in range(count):
        b = SimpleNamespace(marks=0, cells=[], hosts=None)
        b.vtk_type = bytes.varint()
        require(b.vtk_type <= 65535, "vtk_type")
        b.nodes_per_cell = bytes.varint()
        require(b.nodes_per_cell < 2**32, "nodes_per_cell")
        b.cell_count = bytes.varint()
        b.kind = bytes.u8()
        require(b.kind <= 3, "kind of companions")
        if b.kind == 3:
            require(block.edge_points, "nodes on edges that have no points")
            require((b.vtk_type, b.nodes_per_cell) == (QUADRATIC_TET, 6), "nodes on edges of other cells")
            require(b.cell_count == block.cells, "nodes on edges of some tets")
        if b.kind == 2:
            b.marks = bytes.varint()
            require(b.marks <= b.cell_count, "marks")
            require(b.marks <= 3 * block.corners + len(shape.mesh.points), "marks")
            require(1 <= b.nodes_per_cell <= 3, "nodes_per_cell of marks")
        blocks.append(b)
    require(sum(b.cell_count for b in blocks) <= 2**62, "cell_count")
    for b in blocks:
        if b.kind == 3:
            b.cells = [[block.points + e for e in six] for six in shape.walk.edges.of]
            b.hosts = list(range(block.cells))
            continue
        rest = b.cell_count - b.marks
        require(b.nodes_per_cell * rest <= bytes.left(), "more companions than bytes")
        require(b.kind != 1 or rest <= bytes.left(), "more companions than bytes")
        columns = [bytes.deltas(rest) for _ in range(b.nodes_per_cell)]
        require(all(n < len(shape.mesh.points) for column in columns for n in column), "a node that does not exist")
        b.cells = [[column[i] for column in columns] for i in range(rest)]
        if b.kind == 1:
            b.hosts = bytes.deltas(rest)
            require(all(h < block.cells for h in b.hosts), "a host that does not exist")
    marked = []
    if any(b.kind == 2 for b in blocks):
        marks = Marks(blocks, shape, make_stream(bytes.take(bytes.left()), "attributes"))
        marks.read()
        marked = marks.marked_facets
    bytes.end()
    return blocks, marked


class Marks:
    """10.2"""

    def __init__(self, blocks, shape, stream):
        self.blocks = blocks
        self.shape = shape
        self.stream = stream
        self.told = [[] for _ in blocks]
        self.last_turn = False
        self.marked_facets = []
        self.lines = {}
        self.flow = {}

    def flag(self, name, *coordinates):
        return self.stream.flag(self.stream.blocks[name], *coordinates)

    def read(self):
        for n in (3, 2, 1):
            self.n = n
            self.open = [i for i, b in enumerate(self.blocks) if b.marks > 0 and b.nodes_per_cell == n]
            self.left = sum(self.blocks[i].marks for i in self.open)
            self.last_block = 0
            if self.left == 0:
                continue
            require(n < 3 or self.shape.tets, "marks of three nodes in a mesh of polygons")
            self.candidates(n)
            require(self.left == 0, "more marks than candidates")
        for b, told in zip(self.blocks, self.told):
            b.cells = told + b.cells
        self.stream.end()

    def candidates(self, n):
        if n == 3:
            self.facets()
        elif n == 1:
            self.points()
        elif self.shape.tets:
            self.edges()
        else:
            self.sides()

    def candidate(self, nodes, context, found=False, reversed=False, block=0):
        """Whether the candidate is a mark, whether it is reversed, and its block."""
        # 1
        if not self.flag(*context):
            return False, False, 0
        # 2
        if len(self.open) == 1:
            chosen = self.open[0]
        else:
            chosen = self.last_block = self.choose(found, block)
        # 3
        if self.n > 1:
            t = self.flag("mark_turn", self.n - 2, found, self.last_turn)
            reversed = t != reversed
            self.last_turn = t
        # 4
        require(len(self.told[chosen]) < self.blocks[chosen].marks, "more marks than the block has")
        nodes = list(nodes)
        if self.n > 1 and reversed:
            nodes[0], nodes[1] = nodes[1], nodes[0]
        self.told[chosen].append(nodes)
        self.left -= 1
        return True, reversed, chosen

    def choose(self, found, block):
        if found and self.flag("mark_block", 0):
            return block
        l = max(self.last_block, self.open[0])
        if (not found or l != block) and self.flag("mark_block", 1 if found else 2):
            return l
        return self.open[self.stream.plain_below(len(self.open), "a mark of a block that is not there")]

    def facets(self):
        shape = self.shape
        marks = {}  # facet: reversed, block
        for border in (True, False):
            touched_points = set()
            for f in range(len(shape.vertex)):
                if self.left == 0:
                    return
                if shape.is_earlier(f) and (shape.twin[f] == NONE) == border:
                    self.facet(f, border, marks, touched_points)

    def facet(self, f, border, marks, touched_points):
        shape = self.shape
        nodes = [shape.point(c) for c in shape.outward(f)]
        touched = sum(p in touched_points for p in nodes)
        marked = unmarked = flat = block = 0
        found = reversed = False
        if border or touched > 1:
            for s in (f, shape.twin[f]):
                if s == NONE:
                    continue
                for turn in shape.turns(s):
                    for g in turn:
                        t = shape.twin[g]
                        h = g if t == NONE else min(g, t)
                        if h >= f and (border or t != NONE):
                            continue
                        if h not in marks:
                            unmarked += t == NONE
                            continue
                        marked += 1
                        e = flatness(shape.normal(s), shape.normal(g))
                        if e > flat:
                            flat = e
                            found = True
                            block = marks[h][1]
                            reversed = marks[h][0] ^ (g != h) ^ (s != f)
                        break
        context = "mark_facet", border, marked, unmarked, flat
        is_mark, reversed, block = self.candidate(nodes, context, found, reversed, block)
        if is_mark:
            marks[f] = reversed, block
            touched_points.update(nodes)
            self.marked_facets.append(f)

    def sides(self):
        shape = self.shape
        for f in range(len(shape.vertex)):
            if self.left == 0:
                return
            if not shape.is_earlier(f):
                continue
            t = shape.twin[f]
            flat = 0 if t == NONE else flatness(shape.normal(f), shape.normal(t))
            if self.line(shape.point(f), shape.point(shape.succ(f)), flat):
                self.marked_facets.append(f)

    def edges(self):
        shape = self.shape
        for f in range(len(shape.vertex)):
            if shape.twin[f] != NONE:
                continue
            outward = shape.outward(f)
            for k in range(3):
                if self.left == 0:
                    return
                across = NONE
                for g in shape.turn(f, outward[(k + 2) % 3]):
                    if shape.twin[g] == NONE:
                        across = g
                if across < f:
                    continue
                flat = 0 if across == NONE else flatness(shape.normal(f), shape.normal(across))
                self.line(shape.point(outward[k]), shape.point(outward[(k + 1) % 3]), flat)

    def line(self, a, b, flat):
        la = self.lines.get(a, 0)
        lb = self.lines.get(b, 0)
        fa = self.flow.get(a, 0)
        fb = self.flow.get(b, 0)
        context = "mark_line", flat, max(la, lb), min(la, lb)
        is_mark, reversed, _ = self.candidate(
            (a, b), context, fa != 0 or fb != 0, fa < 0 or fb > 0, self.last_block)
        if is_mark:
            for p in (a, b):
                self.lines[p] = min(self.lines.get(p, 0) + 1, 3)
            self.flow[a] = 1 if reversed else -1
            self.flow[b] = -1 if reversed else 1
        return is_mark

    def points(self):
        border = self.shape_border()
        for p in range(self.shape.block.points):
            if self.left == 0:
                return
            self.candidate((p,), ("mark_point", self.lines.get(p, 0), p in border))

    def shape_border(self):
        shape = self.shape
        if shape.tets:
            return shape.points_on_border()
        return {shape.point(f) for f in range(len(shape.vertex)) if shape.twin[f] == NONE}
