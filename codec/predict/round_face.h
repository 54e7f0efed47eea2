// Round faces: spheres, cylinders and tori on which borders of meshes of machine parts, balls and
// bends lie.
#pragma once

#include <array>
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

// Those of a mesh. What lies less than 2^slack units off a face is on it.
struct RoundFaceList {
    std::array<RoundFace, kMostRoundFaces> face{};
    std::size_t count = 0;
    int slack = 0;

    bool empty() const { return count == 0; }
    bool operator==(const RoundFaceList&) const = default;
};
inline constexpr std::int64_t kMostRoundLength = std::int64_t{1} << 58;
inline constexpr std::int64_t kMostRoundAxis = std::int64_t{1} << 51;
inline constexpr int kMostRoundSlack = 53;

// A round face in doubles; `axis` is of length 1, or 0.
struct RoundShape {
    RoundKind kind = RoundKind::sphere;
    Point3 centre{}, axis{};
    double radius = 0, ring = 0;
};

RoundShape shape_of(const RoundFace& face);

// Where a point is beside a face: how far out, below 0 if inside, and which way is out.
struct Outside {
    double distance = 0;
    Point3 way{};
};
Outside outside_of(const RoundShape& shape, const Point3& p);

// The point of the face nearest to p, or nearly so.
Point3 moved_onto(const RoundShape& shape, const Point3& p);

// p with another coordinate `axis`, such that it is on the face; p's own if Newton's method does
// not find any in eight steps.
double coordinate_on(const RoundShape& shape, Point3 p, std::size_t axis);

}  // namespace ravel
