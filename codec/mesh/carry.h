// Where the apex beyond one tet lies, carried over to another tet.
#pragma once

#include <array>
#include <cmath>

#include "mesh/point3.h"

namespace ravel {

// A gate x0 x1 x2 and the apex behind it.
using Frame = std::array<Point3, 4>;

// The sides of a frame from its first corner.
struct Sides {
    Point3 a, b, c;
};
inline Sides sides_of(const Frame& frame) {
    return {minus(frame[1], frame[0]), minus(frame[2], frame[0]), minus(frame[3], frame[0])};
}

// Where the apex comes with the frame. If it `maps`, by the affine map that takes the corners of
// `from` to those of `to`: exact where meshes are turned or stretched evenly. Where `from` is flat,
// or the map takes the apex farther from where a move of the first corner has it than `to` is long,
// by that move. If not, by the move of the middle of the gate, which is surer where all corners are
// a little astray.
inline Point3 carried(const Point3& apex, const Frame& from, const Frame& to, bool maps) {
    const Point3 way = minus(apex, from[0]);
    const Point3 moved{to[0][0] + way[0], to[0][1] + way[1], to[0][2] + way[2]};
    const Sides u = sides_of(from), v = sides_of(to);
    if (u.a == v.a && u.b == v.b && u.c == v.c) return moved;
    if (!maps) {
        Point3 by;
        for (std::size_t k = 0; k < 3; ++k)
            by[k] = apex[k] +
                    ((to[0][k] + to[1][k] + to[2][k]) - (from[0][k] + from[1][k] + from[2][k])) / 3;
        return by;
    }
    const Point3 bc = cross(u.b, u.c), ca = cross(u.c, u.a), ab = cross(u.a, u.b);
    const double volume = dot(u.a, bc);
    if (!(std::abs(volume) > 0)) return moved;
    const double x = dot(way, bc) / volume, y = dot(way, ca) / volume, z = dot(way, ab) / volume;
    Point3 mapped;
    for (std::size_t k = 0; k < 3; ++k)
        mapped[k] = to[0][k] + (x * v.a[k] + y * v.b[k] + z * v.c[k]);
    const Point3 off = minus(mapped, moved);
    const double length = dot(v.a, v.a) + dot(v.b, v.b) + dot(v.c, v.c);
    return dot(off, off) <= length ? mapped : moved;
}

// How differently two frames are shaped: the largest square of how far apart two of their edges
// end.
inline double mismatch(const Frame& from, const Frame& to) {
    const Sides u = sides_of(from), v = sides_of(to);
    double most = 0;
    for (const Point3& off : {minus(u.a, v.a), minus(u.b, v.b), minus(u.c, v.c)}) {
        const double square = dot(off, off);
        if (square > most) most = square;
    }
    return most;
}

}  // namespace ravel
