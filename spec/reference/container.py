"""Chapter 3: sections, `head` and `block`."""

import math
from types import SimpleNamespace

import zstd
from conventions import Bytes, crc32c
from errors import Invalid, require

VERSION = 19

# in the order in which they come, those that need not be there also in that of the bits of `sections`
ALWAYS = HEAD, BLOCK, CONNECTIVITY, POSITIONS = "head", "block", "connectivity", "positions"
OPTIONAL = COMPANIONS, ATTRIBUTES, NAMES, ORDER = "companions", "attributes", "names", "order"

POINT, CORNER, CELL, COMPANION, MESH = range(5)
SCALARS = ("u8", "i8", "u16", "i16", "u32", "i32", "u64", "i64", "f32", "f64")


def find_sections(data):
    """3, 3.1: the name, the stored bytes and `raw_size` (None: not packed) of each section; the checksum is right."""
    if data[:4] != b"Rav1":
        raise Invalid("not_a_ravel_file", "no magic")
    if len(data) == 4:
        raise Invalid("truncated", "no version")
    if data[4] != VERSION:
        raise Invalid("unsupported_version", f"version is not {VERSION}")
    file = Bytes(data, "truncated", 5)
    told = file.u8()
    require(told < 16, "bits 4 to 7 of `sections`")
    found = []
    for name in ALWAYS + tuple(name for bit, name in enumerate(OPTIONAL) if told >> bit & 1):
        size = file.varint()
        raw_size = file.varint() if size & 1 else None
        found.append((name, file.take(size >> 1), raw_size))
    before = data[: file.at]
    checksum = file.u32()
    require(file.left() == 0, "bytes behind the checksum")
    if crc32c(before) != checksum:
        raise Invalid("checksum_mismatch", "of the file")
    return found


def read_sections(data):
    """3, 3.1: the unpacked bytes of each section by name."""
    sections = {}
    for name, stored, raw_size in find_sections(data):
        if raw_size is not None:
            require(raw_size <= (len(stored) // 4 + 1) * 131072, "raw_size above what the bytes can hold")
            stored = zstd.unpack(stored, raw_size)
        sections[name] = stored
    return sections


def check_sections(sections, head, block):
    """3.1: the sections that are there if and only if the heads say so."""
    for name, wanted in (
        (COMPANIONS, block.companions > 0),
        (ATTRIBUTES, len(head.attributes) > 0),
        (ORDER, head.keeps_order),
    ):
        require((name in sections) == wanted, f"section {name} missing, or there without need")


def read_head(data):
    """3.2"""
    bytes = Bytes(data)
    flags = bytes.u8()
    head = SimpleNamespace(
        tets=bool(flags & 1),
        wide=bool(flags & 2),
        lossless=bool(flags & 4),
        keeps_order=bool(flags & 8),
        attributes=[],
    )
    if head.lossless:
        require(not flags & 112, "narrow_head, whole_origin or half_step with lossless")
    else:
        read_grid(bytes, head, bool(flags & 16), bool(flags & 32), bool(flags & 64))
    count = bytes.varint() if flags & 128 else 0
    require(count <= bytes.left() // 4, "attribute_count")
    for _ in range(count):
        head.attributes.append(read_attribute_head(bytes))
    bytes.end()
    return head


def read_grid(bytes, head, narrow_head, whole_origin, half_step):
    """3.2: the fields from `position_bits` to `error`."""
    real = bytes.f32 if narrow_head else bytes.f64
    bits = bytes.u8()
    coarse_origin = bits >> 7
    bits &= 127
    require(bits <= 64, "position_bits")
    require(whole_origin or not coarse_origin, "coarse_origin without whole_origin")
    unit = 2 ** max(bits - 6, 0) if coarse_origin else 1
    head.step = real()
    require(math.isfinite(head.step) and head.step > 0, "step")
    head.origin = tuple(read_steps(bytes, unit) * head.step if whole_origin else real() for _ in range(3))
    require(all(math.isfinite(x) for x in head.origin), "origin")
    head.bound = head.step / 2 if half_step else real()
    require(math.isfinite(head.bound) and head.bound >= 0, "bound")
    s = bytes.u8() / 255
    head.error = head.bound * ((s * s) * s)


def read_steps(bytes, unit):
    """3.2: n of a coordinate of `origin`, a whole number of steps."""
    n = bytes.zigzag() * unit
    require(abs(n) < 2**53, "origin in steps")
    return float(n)


def read_attribute_head(bytes):
    a = SimpleNamespace(name=bytes.text(), references=[])
    kind = bytes.u8()
    a.place = kind & 7
    a.indexed = bool(kind & 8)
    require(a.place <= MESH, "place")
    require(kind >> 4 < len(SCALARS), "scalar")
    a.scalar = SCALARS[kind >> 4]
    width = bytes.varint()
    a.arity = width >> 2
    require(1 <= a.arity <= 65535, "arity")
    a.tuples = bytes.varint()
    if width & 2:
        require(a.scalar in ("f32", "f64"), "a bound of integers")
        bound = bytes.f64()
        error = bytes.f64()
        require(math.isfinite(bound) and bound > 0, "bound of an attribute")
        require(0 <= error <= bound, "error of an attribute")
    if width & 1:
        require(a.scalar in ("u32", "i32", "u64", "i64"), "references by such a scalar")
        count = bytes.varint()
        require(count <= bytes.left() // 2, "reference_count")
        for _ in range(count):
            word = bytes.varint()
            r = SimpleNamespace(component=word >> 1, to_cells=bool(word & 1), base=bytes.zigzag())
            require(r.component < a.arity, "a reference to a component that is not there")
            require(not a.references or a.references[-1].component < r.component, "references not ascending")
            a.references.append(r)
    return a


LEAST_BASE = {"u32": 0, "u64": 0, "i32": -(2**31), "i64": -(2**40)}
MOST_NUMBER = {"u32": 2**32 - 1, "u64": 2**62, "i32": 2**31 - 1, "i64": 2**62}


def check_references(head, block):
    """3.2, the last paragraph: it needs the numbers of `block`."""
    for a in head.attributes:
        for r in a.references:
            count = block.cells if r.to_cells else block.points + block.unused_points
            require(LEAST_BASE[a.scalar] <= r.base <= 2**40, "base of a reference")
            require(r.base + count <= MOST_NUMBER[a.scalar], "base of a reference")


def read_block(data, tets):
    """3.3"""
    most = 2**32 - 2
    bytes = Bytes(data)
    flags = bytes.u8()
    b = SimpleNamespace(
        has_border=bool(flags & 1),
        has_flips=bool(flags & 2),
        has_copies=bool(flags & 4),
        mirrored=bool(flags & 8),
        edge_points=bool(flags & 32),
        leaders_move=bool(flags & 64),
        has_precedents=bool(flags & 128) and not tets,
        by_folds=bool(flags & 128) and tets,
    )
    require(tets or not b.mirrored, "mirrored polygons")
    require(tets or not b.edge_points, "edge_points of polygons")
    require(tets or not b.leaders_move, "leaders_move of polygons")
    b.cells = bytes.varint()
    require(b.cells < (357913941 if tets else most), "cells")
    if tets:
        b.uniform_degree = 4
        b.corners = 4 * b.cells
    else:
        b.uniform_degree = bytes.varint()
        require(b.uniform_degree < most, "uniform_degree")
        b.corners = b.cells * b.uniform_degree if b.uniform_degree else bytes.varint()
    require(b.corners < most, "corners")
    b.vertices = bytes.varint()
    require(b.vertices <= b.corners, "vertices")
    b.points = bytes.varint() if b.has_copies else b.vertices
    require(b.points <= b.vertices, "points")
    told = bytes.u8()
    require(told < (32 if tets else 16), "bits of `told` for fields that are not there")
    b.unused_points = bytes.varint() if told & 1 else 0
    require(b.vertices + b.unused_points < most, "unused_points")
    b.companions = bytes.varint() if told & 2 else 0
    b.components = bytes.varint() if told & 4 else usual_components(b)
    require(b.components <= b.cells, "components")
    b.links = bytes.varint() if told & 8 else 0
    require(b.links <= b.corners, "links")
    if tets:
        b.shape_step = bytes.varint() if told & 16 else 0
        require(b.shape_step <= 2**52, "shape_step")
        b.grid_side = bytes.varint()
        require(1 <= b.grid_side <= 2**52, "grid_side")
        b.grid_count = [1 if b.by_folds else bytes.varint() for _ in range(3)]
        require(all(1 <= n < 2**32 for n in b.grid_count), "grid_count")
        blocks = math.prod((n + 3) // 4 for n in b.grid_count)
        require(blocks <= b.vertices // 4 + 64, "grid_count: too many blocks of cubes")
    bytes.end()
    return b


def usual_components(block):
    """3.3: `components` where they are not told."""
    return min(block.cells, 1)


def check_memory(head, block, sections, limit):
    """15: what the code beside the specification may take. This decoder takes more."""
    P, Q, V = (100 if head.tets else 52), 80, 772
    if head.keeps_order:
        P, Q, V = P + 24, 192, 828
    if block.edge_points:
        Q += 168
    if block.has_precedents:
        P, Q = P + 6, Q + 6
    if block.has_copies:
        V += 40
    need = block.corners * P + block.cells * Q + (block.vertices + block.unused_points) * V
    weight = {HEAD: 64, BLOCK: 64, COMPANIONS: 40, ATTRIBUTES: 4 if head.keeps_order else 2, NAMES: 72}
    need += sum(len(data) * weight.get(name, 1) for name, data in sections.items())
    if need > limit:
        raise Invalid("limit_exceeded", f"{need} bytes")


def check_sizes(block, sections):
    """3.3, the last paragraph."""
    most = 11088 * (len(sections[CONNECTIVITY]) + len(sections[POSITIONS]) + 16)
    for n in (block.cells, block.vertices, block.corners // 3, block.vertices + block.unused_points):
        require(n <= most, "more than the streams can tell of")
