"""The streams of a writer that tosses coins, and the fields of its sections."""

import random

from conventions import width
from flags import RUN_OF, Models
from precedents import Precedents


class CoinPrecedents(Precedents):
    """Where the next flag is chosen, whether the precedent agrees follows from it."""

    def agrees(self, t, context):
        if self.stream.chosen is not None:
            self.stream.chosen = self.stream.chosen == t
        return super().agrees(t, context)

    def enter(self, is_seed):
        self.stream.events.append(("cell", is_seed))
        super().enter(is_seed)


class CoinStream(Models):
    """Answers by chance where a stream would answer what it holds."""

    def __init__(self, kind, chances):
        super().__init__(kind)
        self.chances = chances
        self.moods = (0.03, 0.2, 0.5, 0.8, 0.97, -1, -1)  # of blocks that `chances` does not have
        self.noted = []  # (class, missed) of a flag, (None, bits as text)
        self.wanted = None  # the next residual, where it is not by chance
        self.chosen = None  # the next flag, likewise
        self.precedents = None
        self.events = []  # what was read and which cells were entered, for `again`

    def toss(self, name, likely):
        chance = self.chances.get(name)
        if chance is None:
            chance = self.chances[name] = random.choice(self.moods)
        if chance < 0:  # mostly what the model expects
            return likely if random.random() < 0.9 else not likely
        return random.random() < chance

    def note_flag(self, block, coordinates, answer):
        self.chosen = bool(answer)
        return self.flag(block, *coordinates)

    def flag(self, block, *coordinates):
        context = block(*coordinates)
        if self.precedents:
            answer = self.precedents.flag(block, context)
        else:
            answer = self.read(block, context)
        self.events.append(("flag", block, coordinates, answer))
        return answer

    def read(self, block, context):
        self.used[block.name] = self.used.get(block.name, 0) + 1
        likely, c = self.expect(context)
        answer = bool(self.toss(block.name, likely)) if self.chosen is None else self.chosen
        self.chosen = None
        self.noted.append((c, answer != likely))
        self.update(context, answer)
        return answer

    def plain(self, n, value=None):
        if value is None:
            value = random.getrandbits(n)
        self.note_bits(bin(int(value))[2:].zfill(n) if n else "")
        return value

    def note_bits(self, bits):
        self.noted.append((None, bits))
        self.events.append(("bits", bits))

    def number(self, block, value=None):
        if value is None:
            value = int(random.expovariate(0.4))
        n = width(value + 1)
        for i in range(1, n):
            self.note_flag(block, (i - 1,), True)
        if n < 64:
            self.note_flag(block, (n - 1,), False)
        self.plain(n - 1, value + 1 - 2 ** (n - 1))
        return value

    def plain_below(self, n, why):
        return self.plain(width(n - 1), random.randrange(n))

    def below(self, s):
        value = random.randrange(s)
        self.note_bits(below(s, value))
        return value

    def leaf_below(self, block, depth, n, why):
        leaf = random.randrange(min(n, 2**depth))
        node = 1
        for i in reversed(range(depth)):
            answer = leaf >> i & 1
            self.note_flag(block, (node,), answer)
            node = 2 * node + answer
        return leaf

    def residual(self, context, bits, kind=0, sign=None, differs=False):
        if self.wanted is None:
            return super().residual(context, bits, kind, sign, differs)
        r = self.wanted
        m = abs(r)
        digits = width(m)

        def note(n, answer):
            self.chosen = answer
            self.node(kind, context, n)

        if not differs:
            note(0, m == 0)
        if m > 0:
            note(1, digits >= bits)
            if digits >= bits:
                for step in range(digits - bits):
                    note(2 + min(step, 20), True)
                if digits < 64:
                    note(2 + min(digits - bits, 20), False)
            else:
                for step, s in enumerate(range(bits - 1, 1, -1)):
                    note(23 + min(step, 9), s == digits)
                    if s == digits:
                        break
            if digits >= 2:
                at = min(max(digits + 8, bits), bits + 15) - bits
                self.note_flag(self.blocks["second"], (at, digits), m >> (digits - 2) & 1)
            if sign:
                sign(digits)  # chooses by what is wanted
            rest = max(digits, 2) - 2
            self.plain(rest, m & ((1 << rest) - 1))
            if not sign:
                self.plain(1, r < 0)
        self.wanted = None
        return r

    def rice(self, k, value=None):
        if value is None:
            value = int(random.expovariate(2.0**-k * random.choice((0.05, 0.5, 1, 4))))
        if value >> k < 16:
            self.note_bits("0" * (value >> k) + "1")
            self.plain(k, value & ((1 << k) - 1))
        else:
            over = value - (16 << k)
            self.note_bits("0" * 16)
            self.plain(6, width(over))
            self.plain(width(over), over)
        return value

    def rice_residual(self, kind, context, asks, k):
        if self.wanted is None:
            return super().rice_residual(kind, context, asks, k)
        z = zigzag(self.wanted)
        self.wanted = None
        if asks:
            self.chosen = z == 0
            if self.node(kind, context, 0):
                return 0
        return self.rice(k, z - asks) + asks

    def end(self):
        pass

    def again(self, block):
        """The same answers, by precedents that know the numbers of `block` as they have turned out."""
        events, self.events, self.noted = self.events, [], []
        self.begin()
        self.precedents = CoinPrecedents(self, block)
        for kind, *what in events:
            if kind == "cell":
                self.precedents.enter(*what)
            elif kind == "bits":
                self.note_bits(*what)
            else:
                self.note_flag(*what)

    def bytes(self):
        """4.2, turned round: the code of a run stands where its first flag is asked for."""
        misses = [[] for _ in RUN_OF]
        for c, what in self.noted:
            if c is not None:
                misses[c].append(what)
        at = [0] * len(RUN_OF)
        left = [0] * len(RUN_OF)
        bits = []
        for c, what in self.noted:
            if c is None:
                bits.append(what)
                continue
            if left[c] == 0:
                run = misses[c][at[c] : at[c] + RUN_OF[c]]
                if True in run:
                    left[c] = run.index(True) + 1
                    bits.append("0" + below(RUN_OF[c], left[c] - 1))
                else:
                    left[c] = RUN_OF[c]
                    bits.append("1")
            left[c] -= 1
            at[c] += 1
        bits = "".join(bits)
        bits += "0" * (-len(bits) % 8)
        return bytes(int(bits[i : i + 8], 2) for i in range(0, len(bits), 8))


def below(s, value):
    if s <= 1:
        return ""
    w = width(s - 1)
    b = 2**w - s
    if value < b:
        return bin(value)[2:].zfill(w - 1) if w > 1 else ""
    return bin(value + b)[2:].zfill(w)


def zigzag(v):
    return v * 2 if v >= 0 else -v * 2 - 1


def varint(u):
    out = b""
    while u >= 128:
        out += bytes([u & 127 | 128])
        u >>= 7
    return out + bytes([u])


def coin(chance):
    return random.random() < chance
