// How a gate and a vertex would make a tet: what tells whether they do, beside the sphere through
// them. Bounds are where they make that flag shortest (spec/rationale.md).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "mesh/point3.h"
#include "walk/sphere_family.h"

namespace ravel {

class ApexSigns {
  public:
    // `spheres`: those through the gate.
    ApexSigns(const std::array<Point3, 3>& gate, const SphereFamily& spheres, const Point3& apex) {
        const double height = spheres.above_of(apex);
        double longest = 0;
        for (std::size_t e = 0; e < 3; ++e) {
            const Point3 edge = minus(gate[(e + 1) % 3], gate[e]), way = minus(apex, gate[e]);
            longest = std::max(longest, dot(edge, edge));
            farthest_ = std::max(farthest_, dot(way, way));
        }
        height_ = height * height;
        wide_ = spheres.normal_square() * longest;
    }

    // How high the apex is over the gate, compared to the gate's longest edge: below 5.
    std::uint32_t height() const {
        return (height_ >= 0.09 * wide_) + (height_ >= 0.3025 * wide_) + (height_ >= 0.64 * wide_) +
               (height_ >= 1.21 * wide_);
    }
    // How long the longest edge to the apex is, compared to `length`: below 4.
    std::uint32_t reach(double length) const {
        const double unit = length * length;
        return (farthest_ >= 3.24 * unit) + (farthest_ >= 5.76 * unit) +
               (farthest_ >= 10.24 * unit);
    }

  private:
    double height_ = 0, wide_ = 0, farthest_ = 0;  // squares
};

}  // namespace ravel
