"""8.1: head of the section `positions`."""

from types import SimpleNamespace

import guesses
from conventions import Bytes
from errors import require
from rounds import read_round_faces

GRID, DECIMAL, BINARY = range(3)


def read_positions_head(data, head):
    """The fields down to `place_scale`, and the bits behind them."""
    bytes = Bytes(data)
    p = SimpleNamespace(places=0, digits=0, echoes=[], cube_bits=0, level_bits=0, has_pairs=False, round_faces=None)
    flags = bytes.u8()
    p.has_follows = bool(flags & 1)
    p.has_along = bool(flags & 2)
    require(head.tets or not p.has_along, "has_along of polygons")
    p.has_escapes = bool(flags & 4)
    p.has_minus_zero = bool(flags & 8)
    p.base = flags >> 4 & 3
    has_echoes = bool(flags & 64)
    p.has_levels = bool(flags & 128)
    require(p.base != 3 and (p.base == GRID) == (not head.lossless), "base")
    require(head.lossless or not p.has_minus_zero, "has_minus_zero of a grid")
    fitted = bytes.varint()
    has_rounds = bool(fitted >> 18 & 1)
    p.has_rice = bool(fitted >> 19 & 1)
    require(fitted < 2**20 and (p.has_along or not has_rounds), "fitted")
    if head.lossless:
        p.places = bytes.zigzag()
        p.digits = bytes.u8()
        if p.base == DECIMAL:
            require(0 <= p.places <= 22 and p.digits <= 17, "places or digits")
        else:
            require(-1200 <= p.places <= 1200 and p.digits <= 53, "places or digits")
    if has_echoes:
        count = bytes.u8()
        require(1 <= count <= 8, "echo_count")
        p.cube_bits = bytes.u8()
        require(p.cube_bits <= 54, "cube_bits")
        for _ in range(count):
            mirrored = bytes.u8()
            require(mirrored < 8, "mirrored of an echo")
            offset = [bytes.zigzag() for _ in range(3)]
            require(all(abs(x) <= 2**53 for x in offset), "offset of an echo")
            require(p.digits == 0 or not any(offset), "offset of an echo with digits")
            p.echoes.append((mirrored, offset))
    if p.has_levels:
        levels = bytes.u8()
        p.level_bits = levels & 127
        p.has_pairs = bool(levels & 128)
        require(p.level_bits <= 54, "level_bits")
        require(p.level_bits > 0 or not p.has_pairs, "has_pairs without level_bits")
    p.weights = []
    for c, count in enumerate(guesses.WEIGHT_COUNT):
        if fitted >> c & 1:
            grain = bytes.u8()
            require(grain <= 15, "grain")
            weights = [bytes.zigzag() * 2**grain for _ in range(count)]
            require(all(-32768 <= w <= 32767 for w in weights), "a weight beyond 16 bits")
        else:
            weights = guesses.default_weights(c, bool(fitted >> 17 & 1))
        p.weights.append(weights)
    if has_rounds:
        p.round_faces = read_round_faces(bytes)
    if head.tets and head.lossless:
        bytes.error = "truncated"
        p.place_origin = (bytes.f64(), bytes.f64(), bytes.f64())
        p.place_scale = bytes.f64()
    p.bits = bytes.take(bytes.left())
    return p
