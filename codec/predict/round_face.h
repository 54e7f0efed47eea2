// Round faces: spheres, cylinders and tori on which borders of meshes of machine parts, balls and
// bends lie.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "mesh/point3.h"

namespace ravel {

enum class RoundKind : std::uint8_t { sphere, cylinder, torus, count };

// Lengths are in sixteenths of a unit.
struct RoundFace {
    RoundKind kind = RoundKind::sphere;
    std::array<std::int64_t, 3> centre{};  // of a cylinder: any point of its axis
    std::array<std::int64_t, 3> axis{};    // of any length; a sphere has none
    std::int64_t radius = 0;               // of a torus: of its tube
    std::int64_t ring = 0;                 // of a torus: how far the tube's middle is from the axis

    bool operator==(const RoundFace&) const = default;
};
inline constexpr std::size_t kMostRoundFaces = 16;
inline constexpr std::int64_t kMostRoundLength = std::int64_t{1} << 58;
inline constexpr std::int64_t kMostRoundAxis = std::int64_t{1} << 51;
inline constexpr int kMostRoundSlack = 53;

// A round face in doubles; `axis` is of length 1, or 0.
struct RoundShape {
    RoundKind kind = RoundKind::sphere;
    Point3 centre{}, axis{};
    double radius = 0, ring = 0;
};

inline RoundShape shape_of(const RoundFace& face) {
    RoundShape shape{face.kind,
                     {},
                     {},
                     static_cast<double>(face.radius) / 16,
                     static_cast<double>(face.ring) / 16};
    for (std::size_t k = 0; k < 3; ++k) {
        shape.centre[k] = static_cast<double>(face.centre[k]) / 16;
        shape.axis[k] = static_cast<double>(face.axis[k]);
    }
    const double l = length(shape.axis);
    for (double& x : shape.axis) x = l > 0 ? x / l : 0;
    return shape;
}

// Where a point is beside a face: how far out, below 0 if inside, and which way is out.
struct Outside {
    double distance = 0;
    Point3 way{};
};
inline Outside outside_of(const RoundShape& shape, const Point3& p) {
    Point3 q = minus(p, shape.centre);
    double h = 0;
    if (shape.kind != RoundKind::sphere) {
        h = dot(q, shape.axis);
        for (std::size_t k = 0; k < 3; ++k) q[k] = q[k] - h * shape.axis[k];
    }
    const double l = length(q);
    for (double& x : q) x = l > 0 ? x / l : 0;
    if (shape.kind != RoundKind::torus) return {l - shape.radius, q};
    const double s = l - shape.ring, t = std::sqrt(s * s + h * h);
    for (std::size_t k = 0; k < 3; ++k) q[k] = t > 0 ? (s * q[k] + h * shape.axis[k]) / t : 0;
    return {t - shape.radius, q};
}

// The point of the face nearest to p, or nearly so.
inline Point3 moved_onto(const RoundShape& shape, const Point3& p) {
    const Outside outside = outside_of(shape, p);
    Point3 q;
    for (std::size_t k = 0; k < 3; ++k) q[k] = p[k] - outside.distance * outside.way[k];
    return q;
}

// p with another coordinate `axis`, such that it is on the face; p's own if Newton's method does
// not find any.
inline double coordinate_on(const RoundShape& shape, Point3 p, std::size_t axis) {
    constexpr int kSteps = 8;
    constexpr double kSteep = 1.0 / 16, kNear = 1.0 / 16;
    const double start = p[axis];
    for (int i = 0; i < kSteps; ++i) {
        const Outside outside = outside_of(shape, p);
        if (std::abs(outside.way[axis]) < kSteep) return start;
        const double step = outside.distance / outside.way[axis];
        p[axis] = p[axis] - step;
        if (std::abs(step) < kNear) return p[axis];
    }
    return start;
}

}  // namespace ravel
