"""Chapter 5: the walk, as far as it is the same for surfaces and tets."""

from conventions import NONE
from copies import Copies
from edges import edges_of
from errors import require
from precedents import Precedents

OPEN, BORDER, GONE = "open", "border", "gone"


class Walk:
    def __init__(self, head, block, stream, positions):
        self.block = block
        self.lossless = head.lossless
        self.stream = stream
        self.contexts = self.stream.blocks
        self.positions = positions
        # 5: state
        self.first = [0]
        self.vertex = []
        self.twin = []
        self.state = []
        self.cell_of = []
        self.gate = []
        self.on_border = []
        self.vertex_count = 0
        self.cell_count = 0
        # what chapter 9 asks for
        self.flipped = []
        self.copy_of = []
        self.stencils = []
        # 5.5, 5.6
        self.copies = Copies(self) if block.has_copies else None
        if block.has_precedents:
            stream.precedents = Precedents(stream, block)

    def flag(self, name, *coordinates):
        return self.stream.flag(self.contexts[name], *coordinates)

    def number(self, name):
        return self.stream.number(self.contexts[name])

    def add_facets(self, n):
        """The facets of a new cell; the number of the first."""
        base = len(self.vertex)
        self.vertex += [NONE] * n
        self.twin += [NONE] * n
        self.state += [GONE] * n
        self.cell_of += [self.cell_count - 1] * n
        self.first.append(base + n)
        return base

    def run(self):
        """5.1, 5.4"""
        block = self.block
        seeds = 0
        while self.cell_count < block.cells:
            self.enter(NONE)
            seeds += 1
            cell = self.cell_count - 1
            while True:
                out = self.exit(cell)
                if out != NONE:
                    require(self.cell_count < block.cells, "a cell although `cells` are visited")
                    self.enter(out)
                    cell = self.cell_count - 1
                elif self.gate[cell] == NONE:
                    break
                else:
                    cell = self.cell_of[self.gate[cell]]
        require(self.vertex_count == block.vertices, "vertices")
        require(len(self.vertex) == block.corners, "corners")
        require(seeds == block.components, "components")
        require(sum(c == NONE for c in self.copy_of) == block.points, "points")
        self.edges = edges_of(block, self)
        self.positions.read_unused_points(self.edges)
        self.stream.end()
        self.positions.stream.end()

    def enter(self, gate):
        self.cell_count += 1
        self.gate.append(gate)
        if self.stream.precedents:
            self.stream.precedents.enter(gate == NONE)
        self.visit(gate)
        # 5.2: flips
        flipped = False
        if self.block.has_flips:
            flipped = self.flag("kFlip", self.flipped[-1] if self.flipped else 0)
        self.flipped.append(flipped)

    def new_vertex(self, c, configuration, stencil, borders=(), variant=0):
        """5.2"""
        v = self.vertex_count
        require(v < self.block.vertices, "a new vertex although there are `vertices`")
        self.vertex_count += 1
        self.vertex[c] = v
        self.on_border.append(0)
        self.add_vertex()
        self.stencils.append((configuration, stencil))
        copied = NONE
        if self.copies:
            copied = self.copies.read(v, configuration, stencil)
        self.copy_of.append(copied)
        if copied != NONE:
            self.positions.copy(copied)
        else:
            self.positions.read(configuration, stencil, borders, variant)
