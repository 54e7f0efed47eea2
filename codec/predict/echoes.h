// How a mesh repeats itself: artists' meshes are symmetric, and parts are there again elsewhere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mesh/point3.h"

namespace ravel {

// Axis k of the echo is offset[k] + axis k of the earlier vertex, or offset[k] - it.
struct Echo {
    std::array<bool, 3> mirrored{};
    std::array<std::int64_t, 3> offset{};

    bool operator==(const Echo&) const = default;

    Point3 back(const Point3& p) const {
        Point3 out;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto o = static_cast<double>(offset[k]);
            out[k] = mirrored[k] ? o - p[k] : p[k] - o;
        }
        return out;
    }
};
inline constexpr std::size_t kMostEchoes = 8;
inline constexpr int kMostCubeBits = 54;

}  // namespace ravel
