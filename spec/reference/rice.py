"""8.6: Rice codes of residuals, by the mean of what came before."""

from conventions import i64, unzigzag, width


class RiceMeans:
    def __init__(self, stream):
        self.stream = stream
        self.means = {}

    def residual(self, context, kind):
        if context >= 64:
            kind = 0
        mean = self.means.get((kind, context), (3 if context % 2 else 2) << min(context // 2, 40))
        k = width((11 * mean) >> 8)
        z = self.stream.rice_residual(kind, context, mean < 16, k)
        self.means[kind, context] = mean + ((16 * min(z, 2**36) + 15) >> 4) - ((mean + 15) >> 4)
        return i64(unzigzag(z))
