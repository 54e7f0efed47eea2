"""Chapter 11: attributes."""

import math
import struct
from types import SimpleNamespace

import beside as around
from beside import NO_TUPLE
from container import CELL, COMPANION, CORNER, MESH, POINT
from conventions import Bytes, clamp, f32, i64, scale, unimage, unzigzag
from errors import Invalid, require
from flags import Stream
from guesses import KINDS
from links import CellLinks, CompanionLinks
from sizes import Sizes
from tuples import TupleReader, read_floods, read_in_order
from values import LINEAR, NEAREST, NORMAL, Normals, root, shares, unit

SIZE = {"u8": 1, "i8": 1, "u16": 2, "i16": 2, "u32": 4, "i32": 4, "u64": 8, "i64": 8, "f32": 4, "f64": 8}
OWN, IN_ORDER, FLOODED = range(3)
INTEGER, IMAGE, UNIT, GRID = range(4)


class Elements:
    """All that 11.2 and 11.5 ask for, by place."""

    def __init__(self, shape, blocks, marked_facets):
        self.shape = shape
        self.cell_links = CellLinks(shape, marked_facets)
        self.companion_links = CompanionLinks(shape, blocks)
        self.by_place = {
            POINT: around.Points(shape, blocks),
            CORNER: around.Corners(shape),
            CELL: around.Cells(shape),
            COMPANION: around.Companions(self.companion_links),
            MESH: around.Mesh(),
        }


def read_attributes(data, heads, elements, make_stream=Stream):
    bytes = Bytes(data)
    # 1
    attributes = [read_coding(bytes, a, elements.by_place[a.place].count) for a in heads]
    # 2
    for a in attributes:
        if a.planes:
            read_planes(bytes, a)
    # 3
    stream = make_stream(bytes.take(bytes.left()), "attributes")
    for a in attributes:
        read_attribute(stream, a, elements)
    stream.end()
    return attributes


def read_coding(bytes, head, count):
    a = SimpleNamespace(**vars(head))
    a.count = count
    a.size = SIZE[a.scalar]
    a.is_float = a.scalar[0] == "f"
    a.pooled = a.indexed and a.place != MESH
    coding = bytes.u8()
    a.how = coding & 3
    a.planes = bool(coding & 4)
    a.guess = coding >> 4 & 3
    a.numbers = coding >> 6
    require(a.how < 3 and not coding & 8, "coding of an attribute")
    require(not a.planes or coding >> 4 == 0, "coding with planes")
    require(a.how != 0 or not a.pooled, "how of a pool")
    require(a.how == 0 or a.place != MESH, "how of an attribute of the mesh")
    require(a.how != FLOODED or a.place in (CELL, COMPANION), "flooded")
    require(a.pooled or a.place == MESH or a.tuples == count, "tuples that are not as many as elements")
    if max(count, a.tuples) >= 2**30:
        require(a.how == 0 and a.planes, "too many elements for this coding")
    a.stored = a.tuples
    if a.how != 0 and not a.pooled:
        a.stored = bytes.varint()
        require(a.stored < 2**30 and a.stored <= count, "pool")
    if a.planes:
        return a
    require((a.numbers == INTEGER) == (not a.is_float), "numbers")
    a.has_outliers = a.unit_length = a.minus_zero = a.decimal = a.by_angle = a.octahedral = False
    a.places = 0
    if a.numbers == INTEGER:
        return a
    flags = bytes.u8()
    require(flags < 64, "flags of an attribute")
    a.has_outliers = bool(flags & 1)
    a.unit_length = bool(flags & 2)
    a.minus_zero = bool(flags & 4)
    a.decimal = bool(flags & 8)
    a.by_angle = bool(flags & 16)
    a.octahedral = bool(flags & 32)
    require(not a.has_outliers or a.numbers != IMAGE, "has_outliers")
    require(not a.unit_length or a.arity == 3, "unit_length")
    require(not (a.minus_zero or a.decimal) or a.numbers == UNIT, "minus_zero or decimal")
    require(not a.by_angle or a.guess == NORMAL, "by_angle")
    require(not a.octahedral or (a.arity == 3 and a.numbers == GRID and not a.unit_length), "octahedral")
    if a.numbers == UNIT:
        a.places = bytes.zigzag()
        require(0 <= a.places <= 22 if a.decimal else -1200 <= a.places <= 1200, "places")
    if a.octahedral:
        a.bits = bytes.u8()
        require(3 <= a.bits <= 24, "bits")
    elif a.numbers == GRID:
        a.step = bytes.f64()
        require(math.isfinite(a.step) and a.step > 0, "step of an attribute")
    return a


def read_planes(bytes, a):
    N = a.stored * a.arity
    require(N * a.size <= bytes.left(), "more values than bytes")
    planes = bytes.take(N * a.size)
    bits = 8 * a.size
    last = [0] * a.arity
    a.values = []
    for t in range(a.stored):
        for k in range(a.arity):
            i = t * a.arity + k
            u = sum(planes[b * N + i] << (8 * b) for b in range(a.size))
            last[k] = (last[k] + unzigzag(u)) % 2**bits
        a.values.append(tuple(value_of_image(a, x) for x in last))


def value_of_image(a, image):
    """Floats are kept as their bits."""
    if a.is_float:
        return unimage(image, 8 * a.size)
    return signed(image, 8 * a.size) if a.scalar[0] == "i" else image


def signed(x, bits):
    return x - 2**bits if x >> (bits - 1) else x


def read_attribute(stream, a, elements):
    place = elements.by_place[a.place]
    a.tuple_of = list(range(a.stored))
    if a.how != OWN or not a.planes:
        stream.begin()
    if a.how != OWN:
        a.tuple_of = read_tuples(stream, a, elements, place)
    if not a.planes:
        Values(stream, a, elements, place).read()
    a.indices = a.tuple_of if a.pooled else None
    if a.how != OWN and not a.pooled:
        a.values = [a.values[t] for t in a.tuple_of]


def read_tuples(stream, a, elements, place):
    if not a.pooled and a.stored == 1:
        return [0] * a.count
    reader = TupleReader(stream, a.pooled, a.stored)
    if a.how == FLOODED:
        links = elements.cell_links if a.place == CELL else elements.companion_links
        tuple_of = read_floods(reader, place, links)
    elif a.place == CORNER:
        tuple_of = read_in_order(reader, place, place.beside_for_tuples)
    else:
        tuple_of = read_in_order(reader, place, lambda e, _: (place.beside(e), place.hint(e)))
    require(a.pooled or reader.used == a.stored, "a pool that is not used up")
    return tuple_of


class Values:
    """11.6"""

    def __init__(self, stream, a, elements, place):
        self.stream = stream
        self.a = a
        self.shape = elements.shape
        self.place = place
        self.tuples = None
        if a.how != OWN:
            self.tuples = around.Tuples(a.place, place, a.tuple_of, a.stored)
        if a.guess == NORMAL:
            self.normals = Normals(self.shape, a.by_angle)
        self.units = 1.0
        if a.numbers == UNIT:
            self.units = float(10**a.places) if a.decimal else scale(1.0, a.places)
        elif a.numbers == GRID and not a.octahedral:
            self.units = 1 / a.step
        self.sizes = [Sizes(stream, KINDS) for _ in range((a.arity + 2) // 3)]
        self.known = []
        self.number = []
        self.values = []

    def flag(self, name, *coordinates):
        return self.stream.flag(self.stream.blocks[name], *coordinates)

    def beside(self, t):
        if self.tuples:
            return self.tuples.beside(t)
        if self.a.place == CORNER:
            return self.place.beside_for_values(t, lambda e: e < t)
        return self.place.beside(t)

    def place_of(self, t):
        return (self.tuples or self.place).place(t)

    def normal(self, t):
        """The normal of tuple t."""
        of = {
            POINT: self.normals.of_point,
            CORNER: self.normals.of_corner_element,
            CELL: self.normals.of_polygon,
        }.get(self.a.place)
        if of is None or self.shape.tets:
            return unit((0.0, 0.0, 0.0))
        if not self.tuples:
            return unit(of(t))
        n = (0.0, 0.0, 0.0)
        for e in self.tuples.all_elements[t]:
            m = of(e)
            n = (n[0] + m[0], n[1] + m[1], n[2] + m[2])
        return unit(n)

    def read(self):
        a = self.a
        was_outlier = False
        for t in range(a.stored):
            near = self.beside(t)
            # 1
            if a.has_outliers:
                was_outlier = self.flag("outlier", was_outlier)
                if was_outlier:
                    self.values.append(tuple(self.stream.plain(8 * a.size) for _ in range(a.arity)))
                    first = near[0].element if near else None
                    self.known.append([0.0] * a.arity if first is None else self.known[first])
                    self.number.append([0] * a.arity if first is None else self.number[first])
                    for sizes in self.sizes:
                        sizes.keep(t, [0, 0, 0])
                    continue
            self.known.append([0.0] * a.arity)
            self.number.append([0] * a.arity)
            self.value = [0] * a.arity
            guess = self.guesses(t, near)
            for group, sizes in enumerate(self.sizes):
                # 2
                sizes.begin([b.element for b in near[:3]], min(3, len(near)))
                # 3
                if a.octahedral:
                    self.read_octahedral(t, guess, sizes)
                elif a.unit_length:
                    self.read_unit_length(t, near, guess, sizes)
                else:
                    for slot, k in enumerate(range(3 * group, min(3 * group + 3, a.arity))):
                        self.read_component(t, near, k, slot, guess[k], sizes)
                # 4
                sizes.keep(t)
            self.values.append(tuple(self.value))
        a.values = self.values

    def guesses(self, t, near):
        a = self.a
        if a.guess == NORMAL:
            n = self.normal(t)
            return [n[k % 3] * self.units for k in range(a.arity)]
        places = own = None
        if a.guess == LINEAR:
            places = [self.place_of(b.element) for b in near]
            own = self.place_of(t)
        share = shares(a.guess, near, places, own)
        guess = []
        for k in range(a.arity):
            g = 0.0
            for b, s in zip(near, share):
                g = g + s * self.known[b.element][k]
            guess.append(g)
        return guess

    def read_unit_length(self, t, near, guess, sizes):
        order = [0, 1, 2]
        for i in (0, 1):
            if abs(guess[order[i]]) > abs(guess[order[2]]):
                order[i], order[2] = order[2], order[i]
        order[:2] = sorted(order[:2])
        rest = 1.0
        for slot, k in enumerate(order):
            g = guess[k]
            if slot == 2:
                g = math.copysign(root(max(rest, 0.0)) * self.units, g if math.isfinite(g) else 1.0)
            self.read_component(t, near, k, slot, g, sizes)
            x = self.known[t][k] / self.units
            rest = rest - x * x

    def read_component(self, t, near, k, slot, guess, sizes):
        a = self.a
        r = sizes.residual(slot)
        n = i64(r + self.nearest(near, k, guess))
        bits = 8 * a.size
        if a.numbers == INTEGER:
            self.value[k] = n = value_of_image(a, n % 2**bits)
            self.known[t][k] = float(n)
        elif a.numbers == IMAGE:
            n %= 2**bits
            self.value[k] = unimage(n, bits)
            self.known[t][k] = self.float_of(self.value[k])
        else:
            require(abs(n) < 2**53, "a number of an attribute")
            if a.numbers == GRID:
                value = a.step * float(n)
            else:
                value = float(n) / float(10**a.places) if a.decimal else scale(float(n), -a.places)
                if n == 0 and a.minus_zero and self.flag("minus_zero", slot):
                    value = -0.0
            self.value[k] = self.bits_of(value)
            self.known[t][k] = float(n)
        self.number[t][k] = n

    def nearest(self, near, k, guess):
        a = self.a
        if not math.isfinite(guess) or (a.guess == NEAREST and a.numbers in (INTEGER, IMAGE)):
            return self.number[near[0].element][k] if near else 0
        if a.numbers == IMAGE:
            return image(self.bits_of(guess), 8 * a.size)
        m = 2.0**53 if a.numbers in (UNIT, GRID) else 2.0**62
        return math.floor(clamp(guess, -m, m) + 0.5)

    def float_of(self, bits):
        if self.a.size == 8:
            return struct.unpack("<d", struct.pack("<Q", bits))[0]
        return struct.unpack("<f", struct.pack("<I", bits))[0]

    def bits_of(self, x):
        if self.a.size == 8:
            return struct.unpack("<Q", struct.pack("<d", x))[0]
        return struct.unpack("<I", struct.pack("<f", f32(x)))[0]

    def read_octahedral(self, t, guess, sizes):
        S = 2 ** (self.a.bits - 1) - 1
        x, y, z = guess
        s = abs(x) + abs(y) + abs(z)
        at = [0, 0]
        if 0 < s < math.inf:
            u = x / s
            v = y / s
            if z < 0:
                u, v = fold(u, v)
            at = [int(clamp(math.floor(w * S + 0.5), -S, S)) for w in (u, v)]
        n = [i64(at[slot] + sizes.residual(slot)) for slot in (0, 1)]
        require(all(abs(x) <= S for x in n), "an octahedral number")
        u = n[0] / S
        v = n[1] / S
        z = 1 - abs(u) - abs(v)
        if z < 0:
            u, v = fold(u, v)
        l = root(u * u + v * v + z * z)
        self.known[t] = [u / l, v / l, z / l]
        self.value = [self.bits_of(x) for x in self.known[t]]


def fold(u, v):
    return math.copysign(1 - abs(v), u), math.copysign(1 - abs(u), v)


def image(bits, width):
    high = 1 << (width - 1)
    return ~bits & (2 * high - 1) if bits & high else bits + high
