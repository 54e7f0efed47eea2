"""Companions, attributes and orders of a writer that tosses coins."""

import random
import struct
from types import SimpleNamespace

import attributes
import companions
import container
from coin_stream import CoinStream, coin, varint, zigzag
from container import CELL, COMPANION, CORNER, MESH, POINT, SCALARS
from conventions import Bytes, i64
from mesh import build_mesh
from order import Order
from shape import Shape

TYPES = ((1, 1), (3, 2), (5, 3), (9, 4), (7, 5), (7, 0))


def nothing():
    return SimpleNamespace(companions=0, head=None, sections={})


def make_some(head, block, walk):
    """Tries a few times: many coins lead nowhere."""
    for _ in range(8):
        try:
            return make(head, block, walk)
        except attributes.Invalid:
            continue
    return None


def make(head, block, walk):
    block.points = sum(c == 2**32 - 1 for c in walk.copy_of)
    mesh = build_mesh(head, block, walk)
    shape = Shape(head, block, walk, mesh)
    riding = nothing()
    marked_facets = []
    # 10
    count = random.choice((1, 1, 2, 3) if block.edge_points else (0, 0, 1, 2, 3))
    if count and mesh.points:
        block.companions = riding.companions = count
        heads = make_companions(count, block, mesh)
        mesh.companions, marked_facets, section = read(
            heads, lambda data, streams: companions.read_companions(data, block, shape, streams), {"mark_facet": 0.5})
        riding.sections[container.COMPANIONS] = section
    # 11
    elements = attributes.Elements(shape, mesh.companions, marked_facets)
    count = random.choice((0, 1, 2, 3, 6))
    floods = coin(0.3)  # several floods of one place see the walls of those before
    heads = [make_attribute(i, elements, mesh, floods) for i in range(count)]
    if count:
        riding.head = varint(count) + b"".join(h.bytes for h in heads)
        codings = b"".join(make_coding(h, elements, floods) for h in heads)
        planes = b"".join(make_planes(codings, heads, elements))
        chances = {"size": random.choice((0.4, 0.7, -1)), "fresh": 0.5, "outlier": 0.5}
        mesh.attributes, section = read(
            codings + planes,
            lambda data, streams: [attributes.read_attributes(data, heads, elements, streams)], chances)
        riding.sections[container.ATTRIBUTES] = section
    # 12: none
    if coin(0.2):
        riding.sections[container.NAMES] = b"\0\0"
    # 13
    if head.keeps_order:
        cells_first = coin(0.3)
        cells_by = 0 if cells_first or coin(0.6) else random.randrange(1, 4)
        edges_by = random.randrange(4) if walk.edges.ends else 0
        told = cells_first | cells_by << 4 | edges_by << 6
        if not cells_first:
            told |= coin(0.5) << 1 | coin(0.5) << 2
        if not cells_by:
            told |= coin(0.5) << 3
        heads = bytes([told] + [random.randrange(5 if b.hosts else 4) for b in mesh.companions])
        section = read(heads, lambda data, streams: [CoinOrder(data, shape, mesh, elements, streams)][:0], {})[-1]
        riding.sections[container.ORDER] = section
    return riding


def read(fields, reader, chances):
    """What the reader makes of the fields and of coins, and behind it the section."""
    streams = []

    def make_stream(data, kind):
        streams.append(CoinStream(kind, dict(chances)))
        return streams[-1]

    result = reader(fields, make_stream)
    return [*result, fields + b"".join(s.bytes() for s in streams)]


class CoinOrder(Order):
    def read_near(self, guessed, sizes, left):
        number = random.choice(left)
        self.stream.wanted = i64(number - guessed)
        sizes.residual(0)
        return number


def make_companions(count, block, mesh):
    heads = b""
    bodies = b""
    for i in range(count):
        if i == 0 and block.edge_points and coin(0.8):
            heads += varint(companions.QUADRATIC_TET) + varint(6) + varint(block.cells) + b"\3"
            continue
        type, n = random.choice(TYPES)
        kind = random.choice((0, 0, 0, 0, 1, 2, 2, 2, 2)) if block.cells else 0
        marks = random.choice((1, 1, 2, 4)) if kind == 2 and 1 <= n <= 3 else 0
        kind = 0 if kind == 2 and not 1 <= n <= 3 else kind
        rest = random.choice((0, 1, 3, 9))
        heads += varint(type) + varint(n) + varint(marks + rest) + bytes([kind])
        heads += varint(marks) if kind == 2 else b""
        few = random.randint(1, len(mesh.points))
        for _ in range(n):
            bodies += deltas([random.randrange(few) for _ in range(rest)])
        if kind == 1:
            bodies += deltas([random.randrange(block.cells) for _ in range(rest)])
    return varint(count) + heads + bodies


def deltas(values):
    return b"".join(varint(zigzag(v - last)) for last, v in zip([0, *values], values))


def make_attribute(i, elements, mesh, floods):
    h = SimpleNamespace(name=b"a%d" % i, references=[])
    places = [POINT, CORNER, CELL, MESH] + ([COMPANION] if mesh.companions else [])
    h.place = CELL if floods else random.choice(places)
    h.indexed = coin(0.4)
    h.scalar = random.choice(SCALARS + ("f32", "f64") * 4)
    h.arity = random.choice((1, 1, 2, 3, 3, 4, 7))
    count = elements.by_place[h.place].count
    h.tuples = random.choice((0, 1, 2, 5)) if h.indexed or h.place == MESH else count
    has_bound = h.scalar[0] == "f" and coin(0.2)
    out = varint(len(h.name)) + h.name + bytes([h.place | h.indexed << 3 | SCALARS.index(h.scalar) << 4])
    has_references = h.scalar in ("u32", "i32", "u64", "i64") and coin(0.7)
    out += varint(h.arity * 4 + has_bound * 2 + has_references) + varint(h.tuples)
    if has_bound:
        out += struct.pack("<2d", 1.0, 0.5)
    if has_references:
        components = sorted(random.sample(range(h.arity), random.randint(1, h.arity)))
        out += varint(len(components))
        for component in components:
            to_cells = coin(0.5)
            base = random.choice((0, 0, 1, 5, -1 if h.scalar[0] == "i" else 2))
            h.references.append(SimpleNamespace(component=component, to_cells=to_cells, base=base))
            out += varint(component * 2 + to_cells) + varint(zigzag(base))
    h.bytes = out
    return h


def make_coding(h, elements, floods):
    """By chance until it is valid."""
    count = elements.by_place[h.place].count
    for _ in range(200):
        how = attributes.FLOODED if floods else random.randrange(3)
        planes = coin(0.1)
        out = bytes([how | planes << 2 | (0 if planes else random.randrange(16) << 4)])
        if how and not (h.indexed and h.place != MESH):
            out += varint(random.choice((2, 3) if floods else (0, 1, 1, 2, 3, 5)))
        numbers = out[0] >> 6
        if numbers and not planes:
            flags = random.getrandbits(6) & random.getrandbits(6)
            out += bytes([flags])
            if numbers == 2:
                out += varint(zigzag(random.choice((0, 1, 4, 22)) if flags & 8 else random.choice((0, 5, -3, 24, 1000))))
            if flags & 32:
                out += bytes([random.choice((3, 5, 10, 24))])
            elif numbers == 3:
                out += struct.pack("<d", random.choice((1.0, 0.01, 0.25, 1e-300)))
        try:
            bytes_read = Bytes(out)
            attributes.read_coding(bytes_read, h, count)
            bytes_read.end()
            return out
        except attributes.Invalid:
            continue
    raise attributes.Invalid("corrupt", "no coding by chance")


def make_planes(codings, heads, elements):
    fields = Bytes(codings)
    for h in heads:
        a = attributes.read_coding(fields, h, elements.by_place[h.place].count)
        if a.planes:
            yield random.randbytes(a.stored * a.arity * a.size)
