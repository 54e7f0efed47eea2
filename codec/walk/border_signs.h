// What tells whether a new facet of a tet is a border: how it lies beside its neighbours on the
// front, and how its own tet is shaped. Bounds are where they make that flag shortest
// (spec/rationale.md).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "mesh/flatness.h"
#include "mesh/point3.h"

namespace ravel {

struct BorderSigns {
    std::uint32_t vertices = 0;  // of the facet, those on borders
    std::uint32_t beside = 0;    // edges beyond which there is a border
    std::uint32_t flat = 0;      // how nearly the flattest of these goes straight on, 1 .. 6
    std::uint32_t valley = 0;    // 1: a neighbour that is no border rises over it; 2: steeply

    // `side` is -1 where tets are inside out, otherwise 1; `behind` is the apex of the facet's tet.
    BorderSigns(const std::array<Point3, 3>& facet, const Point3& behind, double side)
        : facet_(facet), normal_(normal_of(facet)), square_(dot(normal_, normal_)), side_(side) {
        for (std::size_t e = 0; e < 3; ++e) {
            const Point3 edge = minus(facet[(e + 1) % 3], facet[e]);
            longest_ = std::max(longest_, dot(edge, edge));
        }
        depth_ = side * dot(minus(behind, facet[0]), normal_);
    }

    // How high a point lies over the facet, and how high its own apex, in one measure.
    double height_of(const Point3& p) const { return side_ * dot(minus(p, facet_[0]), normal_); }
    double height_behind() const { return depth_; }

    // The triangle across an edge: how high its vertex lies that is not on it; `points()` are all
    // three.
    template <class Points>
    void meet(double height, bool border, const Points& points) {
        beside += border;
        if (!border && !(height > 0)) return;
        const Point3 normal = normal_of(points());
        if (border)
            flat = std::max(flat, flatness(normal_, normal));
        else
            valley = std::max(valley, dot(normal_, normal) > 0 ? 1u : 2u);
    }

    // How many of its vertices and edges are on borders and, where there are such edges, how flat:
    // below 28.
    std::uint32_t around() const {
        if (beside == 0) return vertices;
        return 4 + 6 * (beside == 1 ? vertices - 2 : beside) + flat - 1;
    }
    // How deep its tet is and how long its longest edge, which is compared to `length`: below 9.
    std::uint32_t shape(double length) const {
        const double wide = square_ * longest_, unit = length * length, d = depth_ * depth_;
        const std::uint32_t deep = d < 0.25 * wide ? 0 : d < 0.49 * wide ? 1 : 2;
        return 3 * deep + (longest_ < 3.61 * unit ? 0 : longest_ < 6.76 * unit ? 1 : 2);
    }

  private:
    static Point3 normal_of(const std::array<Point3, 3>& p) {
        return cross(minus(p[1], p[0]), minus(p[2], p[0]));
    }

    std::array<Point3, 3> facet_;
    Point3 normal_;
    double square_, side_, longest_ = 0, depth_ = 0;
};

}  // namespace ravel
