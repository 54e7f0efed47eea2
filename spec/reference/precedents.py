"""5.6: flags that are told by what was said when the same came before."""

from conventions import MASK64, clamp, width

FACTOR = 0xD6E8FEB86659FD93
BASE = 0x9E3779B97F4A7C15
ORDERS = (1, 4, 12)

# entries of `said`: a mark, or 2 * context + answer
SEED, CELL = "seed", "cell"


class Precedents:
    """Of one stream; `at` and places in the tables are places in `said`, None where the text has NONE."""

    def __init__(self, stream, block):
        self.stream = stream
        self.question = stream.blocks["kPrecedent"]
        self.said = []
        self.most = min(3 * block.corners + 16, 2**32 - 16)
        self.at = None
        self.agreed = 0
        self.bits = width(clamp(block.cells // 8, 16, 2**22) - 1)
        self.tables = {n: {} for n in ORDERS}  # slots that are not empty: check and place
        self.print = 0
        self.prints = [0] * ORDERS[-1]  # of cells, the last one last

    def keep(self, entry):
        if len(self.said) < self.most:
            self.said.append(entry)

    # when a cell is entered

    def enter(self, is_seed):
        mark = SEED if is_seed else CELL
        # 1
        self.prints = self.prints[1:] + [self.print ^ self.print >> 32]
        self.print = 2 if is_seed else 1
        # 2
        found = None
        for n in ORDERS:
            place = self.find(n)
            found = found if place is None else place
        # 3
        if self.entry() == mark and self.agreed > 0:
            self.at += 1
        else:
            self.agreed = 0
            self.at = None if found is None else found + 1
        # 4
        self.keep(mark)

    def find(self, n):
        """The place that the order has found; from now on its slot is that of the mark to come."""
        s = 0
        for cell_print in self.prints[-n:]:
            s = (s * BASE + cell_print) & MASK64
        key = ((s ^ self.print) * FACTOR) & MASK64
        slot = key >> (64 - self.bits)
        check = key & 0xFFFFFFFF
        slot_check, place = self.tables[n].get(slot, (None, None))
        if len(self.said) < self.most:
            self.tables[n][slot] = check, len(self.said)
        return place if slot_check == check else None

    def entry(self):
        if self.at is None or self.at >= len(self.said):
            return None
        return self.said[self.at]

    # a flag

    def flag(self, block, context):
        t = self.told(context)
        if t is None:
            self.at = None
            self.agreed = 0
            answer = self.stream.read(block, context)
        else:
            self.at += 1
            agrees = self.agrees(t, context)
            self.agreed = min(self.agreed + 1, 4) if agrees else 0
            answer = t == agrees
            self.stream.update(context, answer)
        entry = 2 * context + answer
        self.keep(entry)
        self.print = ((self.print ^ entry) * FACTOR) & MASK64
        return answer

    def told(self, context):
        """What the precedent says under this context, None if it says nothing."""
        entry = self.entry()
        if entry in (None, SEED, CELL) or entry >> 1 != context:
            return None
        return bool(entry & 1)

    def agrees(self, t, context):
        often = (0, 1, 2, 2, 3)[self.agreed]
        likely, c = self.stream.expect(context)
        question = self.question(often, likely == t, c // 5)
        return self.stream.read(self.question, question)
