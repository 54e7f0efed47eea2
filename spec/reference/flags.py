"""Chapter 4: flags, plain bits and numbers."""

import math
import os

from conventions import clamp, i64, width
from errors import require

CLASS_BOUND = (4, 8, 16, 31, 51, 82, 135, 205, 307, 451, 655, 901, 1229, 1597)
RUN_OF = (1, 2, 2, 3, 5, 7, 11, 17, 26, 43, 69, 121, 231, 462, 1386)

# 4.1: the class of each p
CLASS_OF = [next((14 - i for i, bound in enumerate(CLASS_BOUND) if p <= bound), 0) for p in range(2048)]

# 4.6
PRIOR = dict(zip("ABCDEFGHIJKLMNO", (
    39, 98, 262, 590, 1180, 2294, 3932, 5898, 8520, 11796, 15073, 19005, 22938, 26870, 30147)))
PRIOR.update(zip("QRSTUVWXYZabcde", (
    35388, 38665, 42597, 46530, 50462, 53739, 57015, 59637, 61603, 63241, 64355, 64945, 65273, 65437, 65496)))


class Block:
    """4.5: contexts with up to four coordinates."""

    def __init__(self, name, base, sizes):
        self.name = name
        self.base = base
        self.sizes = sizes
        self.letters = ""

    def __call__(self, i, j=0, k=0, l=0):
        a, b, c, d = self.sizes
        i = min(i, a - 1)
        j = min(j, b - 1)
        k = min(k, c - 1)
        l = min(l, d - 1)
        return self.base + ((i * b + j) * c + k) * d + l


class Kind:
    """A kind of stream: its blocks by name and what its models know at the start."""

    def __init__(self, seen):
        self.blocks = {}
        self.seen = seen

    def contexts(self):
        return "".join(block.letters for block in self.blocks.values())


def read_priors(path):
    kinds = {}
    block = None
    with open(path, encoding="ascii") as file:
        for line in file:
            words = line.split("#")[0].split()
            if not words:
                continue
            if words[0] == "stream":
                kind = kinds[words[1]] = Kind(int(words[2]))
            elif words[0] == "block":
                block = Block(words[1], int(words[2]), tuple(int(x) for x in words[3].split(",")))
                kind.blocks[words[1]] = block
            else:
                block.letters += words[0]
    # 4.6: whatever the kind, as the expected sizes of stencils start
    positions = kinds["positions"].blocks
    kinds_of_guess, *context = positions["size_by"].sizes
    positions["size_by"].letters = positions["size"].letters[: math.prod(context)] * kinds_of_guess
    return kinds


# 11.1: what the streams of companions, attributes and order have besides the contexts of `positions`
ATTRIBUTE_BLOCKS = (
    ("same", 4, 8, 4, 4),
    ("lacks", 2, 2),
    ("fresh", 3, 8),
    ("recent", 8),
    ("flood", 4, 3, 21, 2),
    ("outlier", 2),
    ("minus_zero", 3),
    ("mark_facet", 2, 4, 4, 7),
    ("mark_line", 7, 4, 4),
    ("mark_point", 4, 2),
    ("mark_turn", 2, 2, 2),
    ("mark_block", 3),
    ("number_echo", 8),
    ("number_next", 16),
    ("number_guess", 16),
    ("number_near", 2),
    ("turn", 9, 9, 8),
)


def attribute_kind(positions):
    """11.1: of the contexts of residuals `size`, `second` and `size_by` are used, the others start even."""
    kind = Kind(positions.seen)
    kind.blocks = {name: positions.blocks[name] for name in ("size", "second")}
    base = kind.blocks["second"].base + 256
    size_by = positions.blocks["size_by"]
    block = kind.blocks["size_by"] = Block("size_by", base, size_by.sizes)
    block.letters = size_by.letters
    base += len(block.letters)
    for name, *sizes in ATTRIBUTE_BLOCKS:
        sizes += [1] * (4 - len(sizes))
        block = kind.blocks[name] = Block(name, base, tuple(sizes))
        block.letters = "P" * math.prod(sizes)
        base += len(block.letters)
    return kind


KINDS = read_priors(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "priors.txt"))

KINDS["attributes"] = attribute_kind(KINDS["positions"])

# The blocks of each kind of stream under which flags were read; `check` reports the others.
USED = {}


class Models:
    """4.1: what the contexts of one stream know. `blocks` are the blocks of its contexts by name."""

    def __init__(self, kind):
        self.used = USED.setdefault(kind, {})
        self.kind = KINDS[kind]
        self.blocks = self.kind.blocks
        self.begin()

    def begin(self):
        """All models as at the start."""
        kind = self.kind
        letters = kind.contexts()
        self.fast = [2097152 if c == "P" else PRIOR[c] * 64 for c in letters]
        self.slow = list(self.fast)
        self.seen = [0 if c == "P" else kind.seen for c in letters]

    def expect(self, context):
        """The likely value and the class."""
        chance = (self.fast[context] + self.slow[context]) >> 7
        likely = chance >= 32768
        return likely, CLASS_OF[((65535 - chance) if likely else chance) >> 4]

    def update(self, context, answer):
        goal = 4194303 if answer else 0
        rate = 655360 // (10 * self.seen[context] + 13)
        self.slow[context] += ((goal - self.slow[context]) * rate) >> 16
        self.fast[context] += ((goal - self.fast[context]) * max(rate, 3276)) >> 16
        self.seen[context] = min(self.seen[context] + 1, 510)


    def number(self, block):
        """4.3"""
        n = 1
        while n < 64 and self.flag(block, n - 1):
            n += 1
        return 2 ** (n - 1) + self.plain(n - 1) - 1

    def rice(self, k):
        """4.3"""
        q = 0
        while q < 16 and not self.plain(1):
            q += 1
        if q == 16:
            return (16 << k) + self.plain(self.plain(6))
        return (q << k) + self.plain(k)

    def rice_residual(self, kind, context, asks, k):
        """8.6: z"""
        if asks and self.node(kind, context, 0):
            return 0
        return self.rice(k) + asks

    def node(self, kind, context, n):
        """8.6: the flag at node n."""
        if kind == 0 or context >= 64:
            return self.flag(self.blocks["size"], context, n)
        return self.flag(self.blocks["size_by"], kind - 1, context, n)

    def residual(self, context, bits, kind=0, sign=None, differs=False):
        """8.6; `sign` tells of the binary digits whether it is negative, None: a plain bit does; `differs`: from 0."""
        if not differs and self.node(kind, context, 0):
            return 0
        s = bits
        step = 0
        if self.node(kind, context, 1):
            while s < 64 and self.node(kind, context, 2 + min(step, 20)):
                s += 1
                step += 1
        else:
            s -= 1
            while s > 1 and not self.node(kind, context, 23 + min(step, 9)):
                s -= 1
                step += 1
        m = 1
        if s >= 2:
            m = 2 + self.flag(self.blocks["second"], clamp(s + 8, bits, bits + 15) - bits, s)
        rest = max(s, 2) - 2
        negative = sign(s) if sign else None
        m = m * 2**rest + self.plain(rest)
        if not sign:
            negative = self.plain(1)
        return i64(-m if negative else m)


class Stream(Models):
    """A stream of bits and its runs."""

    def __init__(self, data, kind):
        super().__init__(kind)
        self.data = data
        self.at = 0
        self.bits = 8 * len(data)
        self.left = [0] * 15
        self.ends_in_miss = [False] * 15
        self.precedents = None

    def plain(self, n):
        require(n <= self.bits - self.at, "a stream is asked for more bits than it has")
        value = 0
        for at in range(self.at, self.at + n):
            value = value * 2 + (self.data[at >> 3] >> (7 - (at & 7)) & 1)
        self.at += n
        return value

    def below(self, s):
        """4.2: truncated binary."""
        if s <= 1:
            return 0
        w = width(s - 1)
        b = 2**w - s
        v = self.plain(w - 1)
        return v if v < b else v * 2 + self.plain(1) - b

    def flag(self, block, *coordinates):
        """True for yes."""
        context = block(*coordinates)
        if self.precedents:
            return self.precedents.flag(block, context)
        return self.read(block, context)

    def read(self, block, context):
        """4.2; the context is one of the block."""
        self.used[block.name] = self.used.get(block.name, 0) + 1
        likely, c = self.expect(context)
        # 1
        if self.left[c] == 0:
            if self.plain(1):
                self.left[c] = RUN_OF[c]
                self.ends_in_miss[c] = False
            else:
                self.left[c] = self.below(RUN_OF[c]) + 1
                self.ends_in_miss[c] = True
        # 2
        self.left[c] -= 1
        missed = self.left[c] == 0 and self.ends_in_miss[c]
        # 3
        answer = likely != missed
        self.update(context, answer)
        return answer

    def plain_below(self, n, why):
        """As many plain bits as n - 1 has; `corrupt` unless they are below n."""
        value = self.plain(width(n - 1))
        require(value < n, why)
        return value

    def leaf_below(self, block, depth, n, why):
        """8.5.2: the leaf that so many flags lead to in a tree; `corrupt` unless it is below n."""
        node = 1
        for _ in range(depth):
            node = 2 * node + self.flag(block, node)
        require(node - 2**depth < n, why)
        return node - 2**depth

    def end(self):
        """4.4"""
        left = self.bits - self.at
        require(left < 8, "a stream with 8 bits or more left over")
        require(self.plain(left) == 0, "padding that is not 0")
