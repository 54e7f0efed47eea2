// Points and vectors of IEEE doubles, operations in the order written.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace ravel {

using Point3 = std::array<double, 3>;

inline Point3 minus(const Point3& a, const Point3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double dot(const Point3& a, const Point3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double length(const Point3& a) {
    return std::sqrt(dot(a, a));
}
// Of length 1, or 0 if a is.
inline Point3 unit(const Point3& a) {
    const double l = length(a);
    return l > 0 ? Point3{a[0] / l, a[1] / l, a[2] / l} : Point3{};
}
inline Point3 cross(const Point3& a, const Point3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The largest whole number that is not above x, |x| < 2^62. Much faster than std::floor where the
// machine has no instruction for it.
inline std::int64_t whole_below(double x) {
    const auto cut = static_cast<std::int64_t>(x);
    return cut - (static_cast<double>(cut) > x);
}

// How many bits the whole part of x has, 0 <= x < 2^62.
inline std::uint32_t width_of(double x) {
    return static_cast<std::uint32_t>(
        std::bit_width(static_cast<std::uint64_t>(static_cast<std::int64_t>(x))));
}

}  // namespace ravel
