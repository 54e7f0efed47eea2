"""8.3: stencils, weights and guesses."""

import math

from carried import carried
from conventions import NONE, cross, divide, dot, length, minus, plus, times

NAMES = ("seed", "quad_third", "quad_fourth", "quad_corner", "triangle", "polygon", "tet", "border", "led", "edge")
NUMBER = {name: i for i, name in enumerate(NAMES)}
KINDS = (0, 1, 2, 3, 4, 4, 1, 2, 3, 4)  # 8.6, by number
PLACES = 12  # of a stencil
TRIANGLE_SET = 7  # the first of its ten
WEIGHT_COUNT = (2, 5, 6, 10, 3, 7, 5) + 10 * (7,)  # per set
DEFAULTS = {
    4: [2048, 0, 1024],
    5: [160, 450, 1230, 2040, -730, 4430, -520],
    6: [450, 190, 2860, 90, 0],
    7: [-1630, 84, -378, -37, -7, -33, 236],
    8: [-2934, -527, -1097, 250, -88, -236, -283],
    9: [-2678, -345, -634, 119, 134, -181, -188],
    10: [-3751, -1091, -1927, 1548, -123, -919, -169],
    11: [0, -416, -540, 408, 31, -386, -48],
    12: [0, -1099, -1993, 1001, 888, -656, -494],
    13: [0, -1011, -2649, 1871, -72, -673, -264],
    14: [0, -1078, -2096, 1366, 288, -762, -393],
    15: [0, -1008, -1883, 953, 721, -655, -480],
    16: [0, -1445, -2619, 1257, 636, -588, -530],
}
_SET = {"seed": 0, "quad_third": 1, "quad_fourth": 2, "quad_corner": 3, "polygon": 4, "tet": 5, "border": 6}


def default_weights(c, no_triangles):
    if c not in DEFAULTS or (no_triangles and c >= TRIANGLE_SET):
        return [0] * WEIGHT_COUNT[c]
    return DEFAULTS[c]


def set_of(configuration, variant):
    """The number of its set of weights; None where it has none."""
    return TRIANGLE_SET + variant if configuration == "triangle" else _SET.get(configuration)


def _row(text):
    factors = [int(x) for x in text.split()]
    return factors + [0] * (PLACES - len(factors))


def _rows(base, *weights):
    return [_row(base)] + [_row(w) for w in weights]


_FOURTH = ("0 1 -1", "1 0 -1", "1 0 -1 -1 1", "0 0 1 0 -1", "1 0 0 -2 0 1", "0 0 1 0 -2 0 1")

# the base, then a row for each weight
ROWS = {
    "seed": _rows("1", "1 -1", "0 1 -1"),
    "quad_third": _rows("2 0 -1", "1 0 -1", "-1 1", "1 -1 -1 1", "1 0 -2 0 1", "0 1 0 -2 0 1"),
    "quad_fourth": _rows("1 1 -1", *_FOURTH),
    "quad_corner": _rows(
        "1 1 -1", *_FOURTH,
        "0 1 -1 0 0 0 0 -1 1", "0 0 1 0 0 0 0 0 -1", "0 1 0 0 0 0 0 -2 0 1", "0 0 1 0 0 0 0 0 -2 0 1"),
    "triangle": _rows(
        "1 1 -1", "0 0 -1 1", "1 -1", "0 1 0 -1",
        "0 -1 0 0 1", "-1 0 0 0 0 1", "0 -1 0 0 0 0 1", "-1 0 0 0 0 0 0 1"),
    "polygon": _rows("1", "1 -1", "0 1 -1", "-1 0 0 1"),
}


def guess(configuration, stencil, value, weights, mirrored, leaders_move):
    """g on each axis, but for `edge`; `stencil` has 12 places, `value` the values of the vertices."""
    if configuration == "tet":
        return _guess_tet([value[v] for v in stencil[:7]], weights, mirrored)
    if configuration == "border":
        return _guess_border([value[v] for v in stencil[:4]], weights)
    if configuration == "led":
        p = [value[v] for v in stencil]
        return carried(p[11], p[7:11], p[:4], leaders_move)
    total = [0] * PLACES
    for row, w in zip(ROWS[configuration], [4096] + weights):
        if any(factor != 0 and stencil[i] == NONE for i, factor in enumerate(row)):
            continue
        for i, factor in enumerate(row):
            total[i] += w * factor
    g = []
    for axis in range(3):
        x = 0.0
        for i in range(PLACES):
            if total[i] != 0:
                x = x + value[stencil[i]][axis] * float(total[i])
        g.append(x / 4096)
    return tuple(g)


def _thirds(a):
    return (a[0] / 3, a[1] / 3, a[2] / 3)


def _guess_tet(p, weights, mirrored):
    u = minus(p[1], p[0])
    v = minus(p[2], p[0])
    w = minus(p[2], p[1])
    middle = _thirds(plus(plus(p[0], p[1]), p[2]))
    t = [(0.0, 0.0, 0.0)] * 7
    t[0] = minus(middle, p[3])
    t[1] = minus(_thirds(plus(plus(p[4], p[5]), p[6])), middle)
    n = cross(u, v)
    square = dot(n, n)
    edge = (length(u) + length(v) + length(w)) / 3
    if square > 0:
        up = times(n, (-1 if mirrored else 1) / math.sqrt(square))
        beside = 0.0
        for k in range(3):
            beside = beside + (
                length(minus(p[4 + k], p[(k + 1) % 3])) + length(minus(p[4 + k], p[(k + 2) % 3]))
            )
        behind = 0.0
        for k in range(3):
            behind = behind + length(minus(p[3], p[k]))
        t[2] = times(up, edge)
        t[3] = times(up, beside / 6)
        t[4] = times(up, behind / 3)
        vn = times(cross(v, n), dot(u, u))
        nu = times(cross(n, u), dot(v, v))
        centre = plus(p[0], times(plus(vn, nu), 1 / (2 * square)))
        aside = minus(centre, middle)
        if length(aside) < edge:
            t[5] = aside
    pull = (0.0, 0.0, 0.0)
    all = 0.0
    for k in range(3):
        way = minus(p[4 + k], middle)
        share = 1 / (dot(way, way) + 1)
        pull = plus(pull, times(way, share))
        all = all + share
    t[6] = times(pull, divide(1.0, all))
    sum = (0.0, 0.0, 0.0)
    for i in range(7):
        sum = plus(sum, times(t[i], float(weights[i])))
    return tuple(middle[axis] + sum[axis] / 4096 for axis in range(3))


def _guess_border(p, weights):
    u = minus(p[1], p[0])
    n = cross(u, minus(p[2], p[0]))
    square = dot(n, n)
    edge = length(u)
    base = times(plus(p[0], p[1]), 0.5)
    t = [(0.0, 0.0, 0.0)] * 5
    t[0] = minus(base, p[2])
    if square > 0:
        up = times(n, 1 / math.sqrt(square))
        away = cross(u, up)
        t[1] = away
        t[2] = times(away, (length(minus(p[2], p[0])) + length(minus(p[2], p[1]))) / (2 * edge))
        beyond = minus(p[3], base)
        t[3] = minus(beyond, times(up, dot(beyond, up)))
        t[4] = times(up, edge)
    sum = (0.0, 0.0, 0.0)
    for i in range(5):
        sum = plus(sum, times(t[i], float(weights[i])))
    return tuple(base[axis] + sum[axis] / 4096 for axis in range(3))
