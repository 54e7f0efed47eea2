// How nearly one facet goes on straight as another, by their normals (or sides, by their ways): 1
// for a fold back, 6 for straight on.
#pragma once

#include <cstdint>

#include "mesh/point3.h"

namespace ravel {

inline std::uint32_t flatness(const Point3& m, const Point3& n) {
    const double d = dot(m, n), square = dot(m, m) * dot(n, n);
    if (!(d > 0)) return 1;
    const double r = d * d;
    return r > 0.9999 * square ? 6
           : r > 0.99 * square ? 5
           : r > 0.9 * square  ? 4
           : r > 0.5 * square  ? 3
                               : 2;
}

}  // namespace ravel
