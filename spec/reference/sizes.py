"""11.7 and 8.6: residuals and their expected sizes, of three slots."""

from collections import defaultdict

from conventions import width

MOST32 = 2**32 - 1

SEED = 0  # the configuration that has variants
TET = 6  # from here on configurations are of tets
BORDER = 7
NO_ONE, SEEDS, EVERYONE = range(3)

OFF_A_PLANE, FOLLOWERS = 4, 5  # their kinds


def scale_of(e):
    """The expected size by e: context and bits."""
    b = width(e + 1) - 1
    half = 1 if ((e + 1) << 15) >> b >= 46341 else 0
    return min(2 * b + half, 95), 2 if b < 5 else b - 3


class Sizes:
    """Magnitudes per element and slot, whom it tells, and `usual` per configuration and variant."""

    def __init__(self, stream, kinds=(0,), start=16):
        """`kinds`: those of the configurations, `start`: as in 8.6."""
        self.stream = stream
        self.kinds = kinds
        self.usual = defaultdict(lambda: 256)
        for configuration, variant in ((SEED, 0), (SEED, 1), (SEED, 2), (TET, 0), (BORDER, 0)):
            self.usual[configuration, variant] = 16 * start
        self.magnitudes = {}
        self.tells = {}
        self.rice = None  # the means of Rice codes, where residuals are such

    def begin(self, near, configuration, variant=0, order=(0, 1, 2)):
        """`near`: up to three elements that have magnitudes; `order`: in which slots are read."""
        self.configuration = configuration
        self.variant = variant if configuration == SEED else 0
        self.order = list(order)
        near = self.told_by = self.who_tells(near)
        n = len(near)
        usual = self.usual[configuration, self.variant]
        sums = [sum(self.magnitudes[p][k] for p in near) for k in range(3)]
        a, b, *self.shares = (3, 2, 6, 9) if configuration >= TET else (1, 1, 4, 6)
        self.expected = []
        for k in range(3):
            at = usual if n == 0 else ((32 - 3 * b) * sums[k] + b * sum(sums)) // 2 // n
            self.expected.append(((32 - a) * at + a * usual) >> 5)
        self.half = [sums[k] // n // 2 if n else 0 for k in range(3)]
        self.r = [0, 0, 0]

    def who_tells(self, near):
        """8.6: those of `near` that the element is told by."""
        if self.configuration != SEED:
            return [p for p in near if self.tells[p] == EVERYONE]
        if self.variant == 0:
            return []
        return [p for p in near if self.tells[p] != NO_ONE]

    def residual(self, k, e=None, sign=None):
        """A residual of slot k, under its scale or by that off a plane; `sign` as for streams."""
        scale = scale_of(self.e(k) if e is None else e)
        kind = self.kinds[self.configuration] if e is None else OFF_A_PLANE
        if self.rice:
            return self.note(k, self.rice.residual(scale[0], kind))
        return self.note(k, self.stream.residual(*scale, kind, sign))

    def residual_under(self, k, context, differs):
        """A residual of slot k under a context with bits 2; `differs` as for streams."""
        return self.note(k, self.stream.residual(context, 2, differs=differs))

    def note(self, k, residual):
        self.r[k] = min(abs(residual), MOST32)
        return residual

    def e(self, k):
        """By the slots that come before slot k."""
        at = self.order.index(k)
        done = sum(self.r[j] for j in self.order[:at])
        if at == 0:
            return self.expected[k]
        c, d = self.shares
        if at == 1:
            return ((32 - c) * self.expected[k] + 16 * c * done) >> 5
        return ((32 - d) * self.expected[k] + 8 * d * done) >> 5

    def keep(self, element, magnitudes=None):
        """The magnitudes of an element: given, or those of its residuals, which change `usual`."""
        self.tells[element] = EVERYONE
        if magnitudes is None:
            magnitudes = self.r
            if self.configuration == SEED:
                self.tells[element] = NO_ONE if self.variant == 0 else SEEDS
            usual = self.usual[self.configuration, self.variant]
            done = sum(self.r)
            usual += ((16 * done // 3 + 31) >> 5) - ((usual + 31) >> 5)
            self.usual[self.configuration, self.variant] = usual
        self.magnitudes[element] = magnitudes


class FollowerSizes:
    """8.6, followers: `usual` of what leaders say, by the variant of a seed."""

    def __init__(self, stream):
        self.stream = stream
        self.usual = {0: 64, 1: 64, 2: 64, None: 64}

    def begin(self, configuration, variant):
        """A vertex that has a leader."""
        self.of = variant if configuration == SEED else None
        self.done = 0

    def far(self):
        return sum(self.usual[self.of] >= bound for bound in (8, 32, 128))

    def residual(self, k, differs):
        """A residual of axis k; `differs` as for streams."""
        context, bits = scale_of(self.e(k))
        residual = self.stream.residual(context & ~1, bits, FOLLOWERS, differs=differs)
        self.done += min(abs(residual), MOST32)
        return residual

    def e(self, k):
        usual = self.usual[self.of]
        if k == 0:
            return usual
        if k == 1:
            return (20 * usual + 192 * self.done) >> 5
        return (16 * usual + 128 * self.done) >> 5

    def keep(self):
        """After a vertex that follows."""
        self.usual[self.of] = (3 * self.usual[self.of] + 16 * self.done // 3) // 4
