"""11.7 and 8.6: residuals and their expected sizes, of three slots."""

from conventions import width

MOST32 = 2**32 - 1


class Sizes:
    """Magnitudes per element and slot, and `usual` per configuration."""

    def __init__(self, stream, configurations):
        self.stream = stream
        self.usual = [256] * configurations
        self.magnitudes = {}

    def begin(self, near, configuration):
        """`near`: up to three elements that have magnitudes."""
        n = len(near)
        usual = self.usual[configuration]
        self.configuration = configuration
        sums = [sum(self.magnitudes[p][k] for p in near) for k in range(3)]
        self.expected = []
        for k in range(3):
            at = usual if n == 0 else (13 * sums[k] + sum(sums)) // n
            self.expected.append((29 * at + 3 * usual) >> 5)
        self.half = [sums[k] // n // 2 if n else 0 for k in range(3)]
        self.r = [0, 0, 0]

    def residual(self, k, context=None):
        """A residual of slot k, under its scale or under a context with bits 2."""
        if context is None:
            context, bits = self.scale(k)
        else:
            bits = 2
        residual = self.stream.residual(context, bits)
        self.r[k] = min(abs(residual), MOST32)
        return residual

    def scale(self, k):
        """The expected size: context and bits."""
        done = sum(self.r[:k])
        if k == 0:
            e = self.expected[0]
        elif k == 1:
            e = (13 * self.expected[1] + 48 * done) >> 4
        else:
            e = (23 * self.expected[2] + 72 * done) >> 5
        b = width(e + 1) - 1
        half = 1 if ((e + 1) << 15) >> b >= 46341 else 0
        return min(2 * b + half, 95), 2 if b < 5 else b - 3

    def keep(self, element, magnitudes=None):
        """The magnitudes of an element: given, or those of its residuals, which change `usual`."""
        if magnitudes is None:
            magnitudes = self.r
            usual = self.usual[self.configuration]
            done = sum(self.r)
            self.usual[self.configuration] = usual + ((16 * done // 3 + 31) >> 5) - ((usual + 31) >> 5)
        self.magnitudes[element] = magnitudes
