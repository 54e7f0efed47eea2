// Unit vectors as points of a square: the faces of an octahedron, unfolded [CigolleEtAl2014]. The
// same bits on every machine: sums, quotients and square roots of doubles in the order written.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "mesh/point3.h"

namespace ravel {

inline constexpr int kMostOctahedralBits = 24;

// Numbers of a direction are -side .. side; 0, 0 is the z axis.
inline std::int64_t octahedral_side(int bits) {
    return (std::int64_t{1} << (bits - 1)) - 1;
}
// How far a component of a unit vector comes to lie from what it was, at most: half a step in the
// square moves a point of the octahedron by 6^(1/2) / 2 steps, and it is 3^(-1/2) from the middle.
inline double octahedral_bound(int bits) {
    return 2.25 / static_cast<double>(octahedral_side(bits));
}

namespace detail {

// Swaps the inner with the outer triangles of the square, which face down.
inline void fold(double& x, double& y) {
    const double u = std::copysign(1 - std::abs(y), x), v = std::copysign(1 - std::abs(x), y);
    x = u, y = v;
}

}  // namespace detail

inline Point3 octahedral_direction(const std::array<std::int64_t, 2>& numbers, int bits) {
    const auto side = static_cast<double>(octahedral_side(bits));
    double x = static_cast<double>(numbers[0]) / side, y = static_cast<double>(numbers[1]) / side;
    const double z = 1 - std::abs(x) - std::abs(y);
    if (z < 0) detail::fold(x, y);
    const double length = std::sqrt(x * x + y * y + z * z);
    return {x / length, y / length, z / length};
}

// The numbers nearest to a direction; of what is none, 0 and 0.
inline std::array<std::int64_t, 2> octahedral_numbers(const Point3& direction, int bits) {
    const double sum = std::abs(direction[0]) + std::abs(direction[1]) + std::abs(direction[2]);
    if (!(sum > 0) || !std::isfinite(sum)) return {0, 0};
    double x = direction[0] / sum, y = direction[1] / sum;
    if (direction[2] < 0) detail::fold(x, y);
    const auto side = static_cast<double>(octahedral_side(bits));
    const auto whole = [&](double q) {
        return static_cast<std::int64_t>(std::clamp(std::floor(q * side + 0.5), -side, side));
    };
    return {whole(x), whole(y)};
}

}  // namespace ravel
