"""11.3, 11.4: which tuple each element has."""

from beside import NO_TUPLE
from conventions import NONE, width
from errors import require

MOST_CANDIDATES = 12
MOST_LINKS = 16


class Echo:
    """11.3: what followed the last time. `step` is called after each element."""

    def __init__(self, elements):
        n = max(16, min(elements, 2**20))
        self.N = 1 << (n - 1).bit_length()
        self.seen = {}
        self.h = 0
        self.held = 0
        self.at = None  # the element of the echo
        self.values = []

    def value(self):
        """What the echo says; None without one."""
        return None if self.at is None else self.values[self.at]

    def held_class(self):
        return min(width(self.held // 2), 7)

    def step(self, value):
        e = len(self.values)
        if self.at is not None and self.values[self.at] == value:
            self.held += 1
        else:
            self.held = 0
        self.values.append(value)
        number = NONE if value == NO_TUPLE else value
        self.h = ((self.h << 10 & 0xFFFFFFFF) * 0x9E3779B1 + number) & 0xFFFFFFFF
        m = self.h * 0x85EBCA77 & 0xFFFFFFFF
        slot = (m ^ m >> 15) % self.N
        self.at = self.at + 1 if self.held > 0 else self.seen.get(slot)
        self.seen[slot] = e + 1


class TupleReader:
    def __init__(self, stream, pooled, stored):
        self.stream = stream
        self.pooled = pooled
        self.stored = stored
        self.used = 0
        self.recent = []
        self.lacked = False

    def flag(self, name, *coordinates):
        return self.stream.flag(self.stream.blocks[name], *coordinates)

    def read(self, votes, hint):
        """The tuple of an element; `votes` are (tuple, kind, hint) in order."""
        candidates = {}  # in order: [kind, hint, votes]
        for tuple, kind, own_hint in votes:
            if tuple in candidates:
                candidates[tuple][2] += 1
            elif len(candidates) < MOST_CANDIDATES:
                candidates[tuple] = [kind, own_hint, 1]
        tuple = self.choose(candidates, hint)
        if tuple != NO_TUPLE:
            if tuple in self.recent:
                self.recent.remove(tuple)
            self.recent.insert(0, tuple)
            del self.recent[8:]
        return tuple

    def choose(self, candidates, hint):
        # 1
        a = sum(c[2] for c in candidates.values())
        for tuple, (kind, own_hint, votes) in candidates.items():
            a -= votes
            if self.flag("same", kind, own_hint, votes - 1, a):
                return tuple
        # 2
        if self.pooled and NO_TUPLE not in candidates:
            self.lacked = self.flag("lacks", self.lacked, len(candidates) > 0)
            if self.lacked:
                return NO_TUPLE
        # 3
        if self.used < self.stored:
            if self.used == 0 or self.flag("fresh", len(candidates), hint):
                self.used += 1
                return self.used - 1
        # 4
        asked = [t for t in self.recent if t not in candidates]
        for i, tuple in enumerate(asked):
            if self.flag("recent", i):
                return tuple
        # 5
        require(self.used > 0, "a tuple although there are none")
        return self.stream.plain_below(self.used, "a tuple that does not exist")


def read_in_order(reader, elements, beside):
    """11.3; `beside(e, tuple_of)` gives what is beside e and the hint."""
    tuple_of = []
    echo = Echo(elements.count)
    for e in range(elements.count):
        near, hint = beside(e, tuple_of)
        votes = [(tuple_of[b.element], b.kind, hint) for b in near]
        if echo.value() is not None:
            vote = echo.value(), 3, echo.held_class()
            votes = [vote, *votes] if echo.held_class() >= 4 else [*votes, vote]
        tuple_of.append(reader.read(votes, hint))
        echo.step(tuple_of[e])
    return tuple_of


def read_floods(reader, elements, links):
    """11.4"""
    links.begin()
    tuple_of = [None] * elements.count
    known = [False] * elements.count

    def leads_to(f):
        t = links.twin(f)
        return None if t == NONE else links.element(t)

    for s in range(elements.count):
        if known[s]:
            continue
        votes = []
        if s > 0:
            around = [leads_to(f) for f in links.links(s)]
            if not any(E is not None and known[E] and tuple_of[E] == tuple_of[s - 1] for E in around):
                votes = [(tuple_of[s - 1], 0, 0)]
        tuple_of[s] = reader.read(votes, 0)
        known[s] = True
        queue = [s]
        for q in queue:
            for f in links.links(q):
                g = links.twin(f)
                if g == NONE:
                    continue
                E = links.element(g)
                same = []
                against = 0
                for h in list(links.links(E))[:MOST_LINKS]:
                    other = leads_to(h)
                    if other is not None and known[other]:
                        if tuple_of[other] == tuple_of[q]:
                            same.append(h)
                        else:
                            against += 1
                walled = any(h in links.walls for h in same)
                if (tuple_of[E] != tuple_of[q]) if known[E] else walled:
                    links.make_wall(f)
                    links.make_wall(g)
                if known[E] or walled:
                    continue
                if reader.flag(
                    "flood", max(len(same), 1) - 1, against, links.walls_about(f, known), f in links.former
                ):
                    tuple_of[E] = tuple_of[q]
                    known[E] = True
                    queue.append(E)
                else:
                    links.make_wall(f)
                    links.make_wall(g)
    return tuple_of
