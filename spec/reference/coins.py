"""A writer that tosses coins: files that are valid, or nearly, and that no sane writer makes.

It drives the walk of this decoder with answers by chance, notes them, and writes the streams from which a
reader reads the same.
"""

import random
import struct
from types import SimpleNamespace

import coins_riding
import coins_rounds
import container
import guesses
from coin_stream import CoinPrecedents, CoinStream, coin, varint, zigzag
from conventions import NONE, crc32c, width
from edges import edges_of
from errors import Invalid
from positions import Positions
from positions_head import BINARY, DECIMAL, GRID
from signs import Signs
from strip import read_strip
from walk import GONE
from walk_folds import MOST_RANKS, FoldWalk
from walk_surface import SurfaceWalk
from walk_tet import TetWalk


class CoinSigns(Signs):
    def read(self, k, part, s):
        if self.stream.wanted is not None:
            self.stream.chosen = (self.stream.wanted < 0) == self.down(k, part, s)
        return super().read(k, part, s)


class CoinPositions(Positions):
    def __init__(self, head, block, p, stream):
        super().__init__(head, block, p, stream)
        self.signs = CoinSigns(stream)

    def residual(self, k, guess, w, off_plane):
        if abs(w) > self.M - 5000:  # `whole` can't be at M, nor beyond
            self.stream.wanted = random.choice((1, 2, 3, 40, 9999)) * (-1 if w > 0 else 1)
        return super().residual(k, guess, w, off_plane)

    def read_rest(self, e):
        rest = random.randrange(1, 10**e if self.base == DECIMAL else 2**e)
        self.stream.plain(width(10**e - 1) if self.base == DECIMAL else e, rest)
        return rest


class CoinWalk:
    """Mixed into both walks: numbers that mostly name something, and an end."""

    most_cells = 30

    def number(self, name):
        pick = None
        if name == "kCopyOf":
            originals = [v for v, c in enumerate(self.copy_of) if c == NONE]
            if originals:
                pick = zigzag(random.choice(originals) - self.copies.last)
        elif name == "kDegreeRest":
            pick = random.choice((0, 1, 2, 3, 4, 9))
            pick = 2 if pick < 2 and self.gate[-1] != NONE else pick
        elif name in ("kOldFar", "kFoldAge"):
            pick = self.pick_old()
        return self.stream.number(self.contexts[name], pick)

    def flag(self, name, *coordinates):
        if self.cell_count >= self.most_cells and name in self.ending:
            block = self.contexts[name]
            return self.stream.note_flag(block, coordinates, self.ending[name])
        if name == "kCopy" and NONE not in self.copy_of:
            return self.stream.note_flag(self.contexts[name], coordinates, False)
        return super().flag(name, *coordinates)

    def run(self):
        """5.1, but for the end: one component after the other until there are enough cells."""
        self.seeds = 0
        while self.cell_count < self.most_cells:
            self.enter(NONE)
            self.seeds += 1
            cell = self.cell_count - 1
            while True:
                out = self.exit(cell)
                if out != NONE:
                    if self.cell_count > 6 * self.most_cells + 100:
                        raise Endless()
                    self.enter(out)
                    cell = self.cell_count - 1
                elif self.gate[cell] == NONE:
                    break
                else:
                    cell = self.cell_of[self.gate[cell]]


class Endless(Exception):
    pass


class CoinSurface(CoinWalk, SurfaceWalk):
    ending = {"kBorder": True, "kZipRight": True, "kZipLeft": True, "kZipMiddle": True}

    def pick_old(self):
        base = self.first[self.cell_count - 1]
        front = [f for f in range(base) if self.state[f] != GONE and self.state[self.prev[f]] != GONE]
        return base - 1 - random.choice(front) if front else None


class CoinTet(CoinWalk, TetWalk):
    ending = {"kBorder": True, "kLedBorder": True, "kGlue": True, "kNew": False, "kLed": False}

    def pick_old(self):
        corners = self.triple(self.gate[-1])
        others = [v for v in range(self.vertex_count) if v not in corners]
        return self.vertex_count - 1 - random.choice(others) if others else None


class CoinFold(CoinWalk, FoldWalk):
    ending = {"kFoldBorders": True, "kFoldBorder": True, "kFoldNew": False}

    pick_old = CoinTet.pick_old

    def read_near(self, z, near, corners):
        places = [i for i, v in enumerate(near) if v not in corners]
        place = random.choice(places) if places and coin(0.7) else None
        block = self.contexts["kFoldNear"]
        if not self.stream.note_flag(block, (z, 0), place is not None):
            return None
        x = 1
        for bit in (2, 1, 0):
            x = 2 * x + self.stream.note_flag(block, (z, x), place >> bit & 1)
        return x - 8

    def read_rank(self, gate, known):
        met = self.meet(gate, known, MOST_RANKS)
        pick = random.randrange(len(met)) if met and coin(0.8) else MOST_RANKS + random.choice((0, 0, 5))
        return self.stream.number(self.contexts["kFoldRank"], pick)


def make_head(keeps_order):
    head = SimpleNamespace(keeps_order=keeps_order, tets=coin(0.5), wide=coin(0.5), lossless=coin(0.6))
    flags = head.tets | head.wide << 1 | head.lossless << 2 | keeps_order << 3
    return head, bytes([flags]) if head.lossless else make_grid(head, flags)


def make_grid(head, flags):
    """The fields of `head` down to `error`; notes `step` and `origin`."""
    narrow_head, whole_origin, half_step = coin(0.5), coin(0.5), coin(0.5)
    real = "<f" if narrow_head else "<d"
    coarse_origin = whole_origin and coin(0.5)
    # with many bits only 0 can be coarse
    bits = random.randrange(20 if coarse_origin and coin(0.7) else 65)
    out = bytes([flags | narrow_head << 4 | whole_origin << 5 | half_step << 6, bits | coarse_origin << 7])
    step = struct.pack(real, random.choice((1.0, 0.001, 2.0**-10, 1e30)))
    head.step = struct.unpack(real, step)[0]
    out += step
    if whole_origin:
        most = random.choice((0, 9, 10**6, 2**53 - 1))
        unit = 2 ** max(bits - 6, 0) if coarse_origin else 1
        most //= unit
        n = [random.choice((-most, most, random.randint(-most, most))) for _ in range(3)]
        head.origin = [x * unit * head.step for x in n]
        out += b"".join(varint(zigzag(x)) for x in n)
    else:
        origin = [struct.pack(real, random.uniform(-9, 9)) for _ in range(3)]
        head.origin = [struct.unpack(real, x)[0] for x in origin]
        out += b"".join(origin)
    if not half_step:
        out += struct.pack(real, random.choice((0.0, 1.0)))
    return out + bytes([random.choice((0, 255, random.randrange(256)))])


def make_positions_head(head):
    """8.1: the fields, and their bytes before the round faces and behind these, which are only known after the walk."""
    p = SimpleNamespace(places=0, digits=0, echoes=[], cube_bits=0, level_bits=0, has_pairs=False, round_faces=None)
    p.has_escapes = coin(0.3)
    p.has_minus_zero = head.lossless and coin(0.3)
    p.base = random.choice((DECIMAL, BINARY)) if head.lossless else GRID
    p.has_levels = coin(0.5)
    p.has_follows = coin(0.5)
    p.has_along = head.tets and coin(0.7)
    if head.lossless:
        p.places = random.randrange(8) if p.base == DECIMAL else random.choice((0, 3, 24, 52, -5, 1000, -1000))
        p.digits = random.choice((0, 0, 0, 3, 9 if p.base == DECIMAL else 24))
    p.has_rice = coin(0.4)
    has_echoes = coin(0.5)
    has_rounds = p.has_along and coin(0.8)
    fitted = random.getrandbits(18) & random.getrandbits(18) | has_rounds << 18 | p.has_rice << 19
    flags = p.has_follows | p.has_along << 1 | p.has_escapes << 2 | p.has_minus_zero << 3
    out = bytes([flags | p.base << 4 | has_echoes << 6 | p.has_levels << 7]) + varint(fitted)
    if head.lossless:
        out += varint(zigzag(p.places)) + bytes([p.digits])
    if has_echoes:
        count = random.choice((1, 2, 3, 8))
        p.cube_bits = random.choice((0, 1, 2, 3, 4, 6, 8, 12, 54))
        out += bytes([count, p.cube_bits])
        for _ in range(count):
            offset = [0 if p.digits or coin(0.2) else random.randint(-60, 60) for _ in range(3)]
            p.echoes.append((random.randrange(8), offset))
            out += bytes([p.echoes[-1][0]]) + b"".join(varint(zigzag(x)) for x in offset)
    if p.has_levels:
        p.level_bits = random.choice((0, 0, 1, 2, 4, 7, 12, 54))
        p.has_pairs = p.level_bits > 0 and coin(0.6)
        out += bytes([p.level_bits | p.has_pairs << 7])
    p.weights = []
    for c, count in enumerate(guesses.WEIGHT_COUNT):
        p.weights.append(guesses.default_weights(c, bool(fitted >> 17 & 1)))
        if fitted >> c & 1:
            most = random.choice((300, 4096, 32767))
            grain = random.choice((0, random.randrange(16)))
            grains = [random.randint(-most - 1 >> grain, most >> grain) for _ in range(count)]
            p.weights[c] = [w * 2**grain for w in grains]
            out += bytes([grain]) + b"".join(varint(zigzag(w)) for w in grains)
    if has_rounds:
        p.round_faces = coins_rounds.CoinRoundFaces(p.base == GRID)
    behind = b""
    if head.tets and head.lossless:
        p.place_origin = tuple(random.uniform(-40, 0) for _ in range(3))
        p.place_scale = random.choice((1.0, 3.7, 0.01, -1.0, 1e5, float("nan")))
        behind = struct.pack("<4d", *p.place_origin, p.place_scale)
    return p, out, behind


def make_file(seed, rides=False):
    """The bytes of a file; None where the coins lead nowhere. `rides`: with companions, attributes, order."""
    random.seed(seed)
    head, head_bytes = make_head(rides and coin(0.5))
    p, before_rounds, behind_rounds = make_positions_head(head)
    edge_points = head.tets and coin(0.4)
    # precedents are found where many cells are alike
    has_precedents = not head.tets and coin(0.6)
    alike = has_precedents and coin(0.7)
    # many borders, and new vertices beside them
    along = p.has_along and coin(0.7)
    H = 256 if alike else random.choice((64, 256) if edge_points or along else (16, 64, 256))
    # N and H depend on the points, so those are decided on before the walk
    points = H - random.choice((0, 0, 1, H // 3)) if p.level_bits else H
    block = SimpleNamespace(
        has_border=coin(0.8), has_flips=coin(0.3), has_copies=coin(0.5), mirrored=head.tets and coin(0.3),
        leaders_move=head.tets and coin(0.3), has_precedents=has_precedents,
        by_folds=head.tets and coin(0.4),
        edge_points=edge_points, cells=2**31, corners=2**31, vertices=points, unused_points=0, uniform_degree=4)
    if head.tets:
        block.grid_side = random.choice((1, 1, 2, 5, 30, 1000, 2**52))
        block.grid_count = [1 if block.by_folds else random.choice((1, 2, 4, 5, 13)) for _ in range(3)]
        # steps of many sizes: gates are seldom of one shape if it is small, nearly all are if it is large
        block.shape_step = random.choice((0, 0, 8, 60, 1000, 2**20, 2**52))
        if block.shape_step:
            # so that the table of 7.9 has the places here that it has in the file
            block.vertices = min(points, 64)
            block.unused_points = points - block.vertices
    else:
        block.uniform_degree = random.choice((0, 0, 0, 0, 2, 3, 4, 5, 11))
    chances = {"kLed": random.choice((0.2, 0.6, 0.9, -1)), "kPrecedent": random.choice((0.5, 0.8, 0.95, -1))}
    if along:
        chances.update(kBorder=random.choice((0.15, 0.3)), kLowest=0.3, kNew=0.8, kNear=0, kLed=0.2)
        chances["kLedBorder"] = chances["kFoldBorder"] = chances["kBorder"]
        chances.update(kFold=0.3, kFoldNew=0.8)
    stream = CoinStream("tet" if head.tets else "surface", chances)
    if alike:
        stream.moods = (0.01, 0.99)
    chances = {"size": random.choice((0.3, 0.5, -1)), "leading": 0.2, "escape": 0.2}
    chances["size_by"] = chances["size"]
    for name in "along", "along_round":
        chances[name] = random.choice((0.3, 0.6, 0.9, -1))
    positions_stream = CoinStream("positions", chances)
    positions = CoinPositions(head, block, p, positions_stream)
    kind_of_walk = CoinSurface if not head.tets else CoinFold if block.by_folds else CoinTet
    walk = kind_of_walk(head, block, stream, positions)
    if block.has_precedents:
        stream.precedents = CoinPrecedents(stream, block)
    # each tet brings some edges, whose points are to fit into H too
    many = H // 8 if edge_points else 5 + H // 4
    walk.most_cells = random.choice((20, 60, 160) if alike else (many,) if along else (1, 5, many))
    try:
        walk.run()
        block.vertices = walk.vertex_count
        walk.edges = edges_of(block, walk)
        # enough points for H to be that of the file, if it has echoes
        least = H // 2 + 1 - walk.vertex_count if p.echoes and H > 16 else 0
        unused_points = max(least, random.choice((0, 0, 1, 4)) + len(walk.edges.ends))
        if p.level_bits:
            unused_points = points - walk.vertex_count
        if walk.vertex_count + unused_points > H or unused_points < len(walk.edges.ends):
            return None
        block.unused_points = unused_points
        positions.read_unused_points(walk.edges)
    except (Endless, Invalid):
        return None
    block.cells = walk.cell_count
    block.corners = len(walk.vertex)
    if block.has_precedents:
        stream.again(block)
    block.links = sum(read_strip(walk))
    riding = coins_riding.make_some(head, block, walk) if rides else coins_riding.nothing()
    if not riding:
        return None
    block.components = walk.seeds
    block.companions = riding.companions
    block.points = walk.copy_of.count(NONE)
    rounds = p.round_faces.bytes() if p.round_faces else b""
    sections = {
        container.HEAD: with_attributes(head_bytes, riding.head),
        container.BLOCK: make_block(head, block),
        container.CONNECTIVITY: stream.bytes(),
        container.POSITIONS: before_rounds + rounds + behind_rounds + positions_stream.bytes(),
        **riding.sections,
    }
    return whole_file(sections)


def with_attributes(fields, attributes):
    """3.2; that there are none is told, too, now and then."""
    if attributes is None:
        if coin(0.8):
            return fields
        attributes = varint(0)
    return bytes([fields[0] | 128]) + fields[1:] + attributes


def make_block(head, block):
    """3.3; fields with their usual values are told, too, now and then."""
    flags = block.has_border | block.has_flips << 1 | block.has_copies << 2 | block.mirrored << 3
    flags |= block.edge_points << 5 | block.leaders_move << 6 | (block.has_precedents or block.by_folds) << 7
    out = bytes([flags]) + varint(block.cells)
    if not head.tets:
        out += varint(block.uniform_degree)
        if block.uniform_degree == 0:
            out += varint(block.corners)
    out += varint(block.vertices)
    if block.has_copies:
        out += varint(block.points)
    usual = 0, 0, container.usual_components(block), 0, 0
    told = 0
    fields = b""
    values = (block.unused_points, block.companions, block.components, block.links)
    for bit, value in enumerate(values + ((block.shape_step,) if head.tets else ())):
        if value != usual[bit] or coin(0.3):
            told |= 1 << bit
            fields += varint(value)
    out += bytes([told]) + fields
    if head.tets:
        out += varint(block.grid_side)
        if not block.by_folds:
            out += b"".join(varint(n) for n in block.grid_count)
    return out


def has_tets(data):
    return container.read_sections(data)[container.HEAD][0] & 1 == 1


def damage(data):
    """A file with a few bits of one section other than they were, or with other sections; checksums right."""
    sections = container.read_sections(data)
    if coin(0.08):
        return whole_file(sections, flipped=1 << random.randrange(8))
    if coin(0.08):
        name = random.choice(container.OPTIONAL)
        if sections.pop(name, None) is None:
            sections[name] = bytes(random.choice((0, 1, 2)))
        return whole_file(sections)
    name = random.choice([name for name in sections if sections[name]])
    damaged = bytearray(sections[name])
    for _ in range(random.choice((1, 1, 2))):
        damaged[random.randrange(len(damaged))] ^= 1 << random.randrange(8)
    if coin(0.1):
        damaged = damaged[: random.randrange(len(damaged))]
    sections[name] = bytes(damaged)
    return whole_file(sections)


def whole_file(sections, flipped=0):
    """3; `flipped`: bits of `sections` that are not as they should be."""
    told = sum(1 << bit for bit, name in enumerate(container.OPTIONAL) if name in sections)
    out = b"Rav1" + bytes([container.VERSION, told ^ flipped])
    for name in container.ALWAYS + container.OPTIONAL:
        if name in sections:
            out += varint(len(sections[name]) * 2) + sections[name]
    return out + struct.pack("<I", crc32c(out))
