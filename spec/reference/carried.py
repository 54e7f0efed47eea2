"""7.9: where a point comes with others; of places (7.9) and of values (8.3)."""

from conventions import cross, dot, minus, plus


def carried(x, a, b, leaders_move):
    """x by the map that takes the four points a to the four points b, or by a move."""
    w = minus(x, a[0])
    u1, u2, u3 = (minus(p, a[0]) for p in a[1:])
    v1, v2, v3 = (minus(p, b[0]) for p in b[1:])
    moved = plus(b[0], w)
    if (u1, u2, u3) == (v1, v2, v3):
        return moved
    if leaders_move:
        return tuple(x[k] + (((b[0][k] + b[1][k]) + b[2][k]) - ((a[0][k] + a[1][k]) + a[2][k])) / 3 for k in range(3))
    c23 = cross(u2, u3)
    c31 = cross(u3, u1)
    c12 = cross(u1, u2)
    volume = dot(u1, c23)
    if not abs(volume) > 0:
        return moved
    r = dot(w, c23) / volume
    s = dot(w, c31) / volume
    t = dot(w, c12) / volume
    mapped = tuple(b[0][k] + ((r * v1[k] + s * v2[k]) + t * v3[k]) for k in range(3))
    off = minus(mapped, moved)
    return mapped if dot(off, off) <= (dot(v1, v1) + dot(v2, v2)) + dot(v3, v3) else moved
