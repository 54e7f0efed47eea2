// A new vertex of a tet that goes on with the border beyond an edge of the gate lies in the plane
// of the border's triangle there, or nearly so. The plane tells one coordinate from the other two.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/point3.h"
#include "mesh/stencil.h"

namespace ravel {

// The stencil of a vertex that goes on with the border across edge e of a tet's gate.
inline Stencil along_border(const Stencil& tet, std::size_t e) {
    return stencil_of(Configuration::border,
                      {tet.at[(e + 1) % 3], tet.at[(e + 2) % 3], tet.at[4 + e], tet.at[e]});
}

// The axes in the order in which the coordinates of a point are coded that lies across `normal`:
// the one along which that is longest comes last.
inline std::array<std::size_t, 3> axes_across(const Point3& normal) {
    std::size_t last = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
        if (std::abs(normal[axis]) >= std::abs(normal[last])) last = axis;
    return {last == 0 ? std::size_t{1} : 0, last == 2 ? std::size_t{1} : 2, last};
}

class BorderPlane {
  public:
    BorderPlane() = default;
    // Of a `border` stencil.
    BorderPlane(const Stencil& stencil, const std::vector<Point3>& values) {
        const Point3& foot = values[stencil.at[0]];
        const Point3 edge = minus(values[stencil.at[1]], foot);
        normal_ = cross(edge, minus(values[stencil.at[2]], foot));
        square_ = dot(normal_, normal_);
        axes_ = axes_across(normal_);
        const Point3 gate = cross(minus(values[stencil.at[3]], foot), edge);
        const double d = dot(gate, normal_), q = dot(gate, gate) * square_;
        if (q > 0)
            opening_ = static_cast<std::uint32_t>(std::clamp(8 + 8 * d / std::sqrt(q), 0.0, 15.0));
    }
    // Has the triangle an area?
    bool exists() const { return square_ > 0; }
    // How far the gate is turned from the triangle, in classes: 0 lies on it, 15 goes straight on.
    std::uint32_t opening() const { return opening_; }
    // The axes in the order in which they are coded: that across which the plane lies comes last.
    const std::array<std::size_t, 3>& axes() const { return axes_; }
    // The last coordinate in the plane's parallel through `guess`, the others being known.
    double carried(const Point3& guess, const Point3& value) const {
        const auto [a, b, last] = axes_;
        return guess[last] -
               (normal_[a] * (value[a] - guess[a]) + normal_[b] * (value[b] - guess[b])) /
                   normal_[last];
    }

  private:
    Point3 normal_{};
    double square_ = 0;
    std::array<std::size_t, 3> axes_{};
    std::uint32_t opening_ = 0;
};

// How far a vertex lies off the plane, times the normal's length.
struct OffPlane {
    double distance = 0, normal_square = 0, edge_square = 0;
};
inline OffPlane off_plane(const Stencil& border, const std::vector<Point3>& values,
                          const Point3& value) {
    const Point3& foot = values[border.at[0]];
    const Point3 edge = minus(values[border.at[1]], foot);
    const Point3 normal = cross(edge, minus(values[border.at[2]], foot));
    return {dot(minus(value, foot), normal), dot(normal, normal), dot(edge, edge)};
}
// Does it lie near the plane, beside the length of the edge? A writer's guess before it knows what
// either way takes.
inline bool lies_along(const Stencil& border, const std::vector<Point3>& values,
                       const Point3& value) {
    const OffPlane off = off_plane(border, values, value);
    return 16 * off.distance * off.distance < off.edge_square * off.normal_square;
}
}  // namespace ravel
