"""8.6: the signs of residuals of vertices."""

import math


class Signs:
    """Per vertex and axis the sign of its residual; 0 where none was read."""

    def __init__(self, stream):
        self.stream = stream
        self.contexts = stream.blocks
        self.of = []

    def begin(self, near):
        """`near`: those the vertex is told by."""
        self.signs = [sum(self.of[p][k] for p in near) for k in range(3)]

    def read(self, k, part, s):
        """Whether the residual of axis k, of s binary digits, is negative."""
        around = self.signs[k]
        down = self.down(k, part, s)
        if s > 2:
            answer = self.stream.flag(self.contexts["sign_of_large"], abs(around))
        else:
            way = math.trunc(min(abs(part) * 8, 3))
            answer = self.stream.flag(self.contexts["sign"], way, s - 1, 3 + (-around if down else around))
        return down if answer else not down

    def down(self, k, part, s):
        """Whether it is negative if the answer is yes."""
        return self.signs[k] < 0 if s > 2 else part < 0

    def keep(self, signs):
        """Those of the next vertex."""
        self.of.append(tuple(signs))


def sign_of(residual):
    return (residual > 0) - (residual < 0)
