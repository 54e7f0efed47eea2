"""Chapter 1: types, lists, doubles and vectors."""

import math
import struct

from errors import Invalid, corrupt, require

NONE = 2**32 - 1
MASK64 = 2**64 - 1


def i64(u):
    """A u64 as the i64 with the same bits; any integer modulo 2^64."""
    u &= MASK64
    return u - 2**64 if u >> 63 else u


def unzigzag(u):
    return (u >> 1) ^ -(u & 1)


def width(x):
    return x.bit_length()


class Bytes:
    """Fields read from unpacked bytes; what is not there is `error`."""

    def __init__(self, data, error="corrupt", at=0):
        self.data = data
        self.at = at
        self.error = error

    def left(self):
        return len(self.data) - self.at

    def take(self, n):
        if n > self.left():
            raise Invalid(self.error, "the data end too early")
        self.at += n
        return self.data[self.at - n : self.at]

    def u8(self):
        return self.take(1)[0]

    def u32(self):
        return struct.unpack("<I", self.take(4))[0]

    def f32(self):
        return struct.unpack("<f", self.take(4))[0]

    def f64(self):
        return struct.unpack("<d", self.take(8))[0]

    def varint(self):
        value = 0
        for i in range(10):
            byte = self.u8()
            value |= (byte & 127) << (7 * i)
            if byte < 128:
                if (byte == 0 and i > 0) or value > MASK64:
                    break
                return value
        raise Invalid(self.error, "a varint that is not in shortest form or above 2^64 - 1")

    def zigzag(self):
        return unzigzag(self.varint())

    def deltas(self, n):
        values = []
        last = 0
        for _ in range(n):
            last = (last + self.zigzag()) & MASK64
            values.append(last)
        return values

    def text(self):
        return bytes(self.take(self.varint()))

    def end(self):
        require(self.left() == 0, "bytes left over in a section")


def _crc_table():
    table = []
    for i in range(256):
        for _ in range(8):
            i = (i >> 1) ^ (0x82F63B78 if i & 1 else 0)
        table.append(i)
    return table


CRC_TABLE = _crc_table()


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc = (crc >> 8) ^ CRC_TABLE[(crc ^ byte) & 255]
    return crc ^ 0xFFFFFFFF


# Floating point. Python's float operations are single IEEE 754 binary64 operations.


def scale(x, n):
    """x * 2^n, correctly rounded, beyond the range to infinity."""
    try:
        return math.ldexp(x, n)
    except OverflowError:
        return math.copysign(math.inf, x)


def f32(x):
    """A double rounded to binary32, beyond the range to infinity."""
    try:
        return struct.unpack("<f", struct.pack("<f", x))[0]
    except OverflowError:
        return math.copysign(math.inf, x)


def to_24_digits(x):
    """A double rounded to 24 binary digits, ties to even."""
    if x == 0:
        return x
    m, e = math.frexp(x)
    return math.ldexp(round(m * 2**24), e - 24)


def clamp(x, a, b):
    return a if x < a else b if b < x else x


def divide(a, b):
    """IEEE division; Python's own raises where b is 0."""
    if b != 0:
        return a / b
    if a == 0 or a != a:
        return math.nan
    return math.copysign(math.inf, a) * math.copysign(1.0, b)


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def plus(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def times(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def length(a):
    return math.sqrt(dot(a, a))


def unimage(i, bits):
    """The bits of the float with image i."""
    high = 1 << (bits - 1)
    return i - high if i & high else ~i & (2 * high - 1)
