// Angles between edges of the front, in classes: what is left open between two edges says whether a
// cell closes it.
#pragma once

#include <cstdint>

#include "mesh/point3.h"

namespace ravel {

// 1: under 30 degrees, then up to 45, 75, 105, 125, 145, 160 and more; 0 where an edge has no
// length or the numbers are out of range. Doubles, each operation as written.
inline std::uint32_t angle_class(const Point3& vertex, const Point3& from, const Point3& to) {
    const Point3 u = minus(from, vertex), v = minus(to, vertex);
    const double uv = dot(u, v), square = dot(u, u) * dot(v, v);
    if (!(square > 0)) return 0;
    // Cosine times its absolute value.
    const double c = uv < 0 ? -(uv * uv) : uv * uv;
    if (c > 0.067 * square) return c > 0.5 * square ? (c > 0.75 * square ? 1 : 2) : 3;
    if (c > -0.329476 * square) return c > -0.067 * square ? 4 : 5;
    return c > -0.670761 * square ? 6 : c > -0.8836 * square ? 7 : 8;
}

}  // namespace ravel
