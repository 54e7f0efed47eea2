// The spheres through a triangle, for guessing the apex beyond it: in a Delaunay mesh the apex is
// the vertex whose sphere lies lowest. [BischoffRossignac2005] send Delaunay meshes that way; here
// it is only a guess, which any mesh may contradict.
//
// Coordinates are integers held in doubles; every operation is one IEEE double operation, in the
// order written, so that both sides find the same guess.
#pragma once

#include <array>
#include <cmath>

#include "mesh/point3.h"

namespace ravel {

// A sphere is told by the height of its centre over the triangle, in multiples of the normal's
// length.
class SphereFamily {
  public:
    // (a, b, c) seen counter-clockwise from the side where apexes are looked for; `mirrored`:
    // clockwise.
    SphereFamily(const Point3& a, const Point3& b, const Point3& c, bool mirrored) : a_(a) {
        const Point3 u = minus(b, a), v = minus(c, a);
        normal_ = mirrored ? cross(v, u) : cross(u, v);
        square_ = dot(normal_, normal_);
        flat_ = !(square_ > 0);
        if (flat_) return;
        const Point3 n = cross(u, v);
        const Point3 vn = cross(v, n), nu = cross(n, u);
        const double uu = dot(u, u), vv = dot(v, v);
        for (std::size_t i = 0; i < 3; ++i) centre_[i] = (uu * vn[i] + vv * nu[i]) / (2 * square_);
        radius_square_ = dot(centre_, centre_);
        flat_ = !(radius_square_ > 0);
        if (!flat_) unit_ = std::sqrt(radius_square_ / square_);
    }
    bool flat() const { return flat_; }
    // How far p lies above the triangle, and what its sphere's height would be times twice that.
    struct Lift {
        double above, twice;
    };
    Lift lift_of(const Point3& p) const {
        const Point3 q = minus(p, a_);
        return {dot(normal_, q), dot(q, q) - 2 * dot(q, centre_)};
    }
    // lift_of(p).above alone: the distance times the normal's length.
    double above_of(const Point3& p) const { return dot(normal_, minus(p, a_)); }
    double normal_square() const { return square_; }
    // Height of the centre along the (unnormalised) normal; only of what is above.
    static double height_of(const Lift& lift) { return lift.twice / (2 * lift.above); }
    // The height that equals the triangle's circumradius; others are told in multiples of it.
    double unit() const { return unit_; }
    Point3 centre_at(double height) const {
        return {a_[0] + centre_[0] + height * normal_[0], a_[1] + centre_[1] + height * normal_[1],
                a_[2] + centre_[2] + height * normal_[2]};
    }
    double radius_at(double height) const {
        return std::sqrt(radius_square_ + height * height * square_);
    }

  private:
    Point3 a_, normal_{}, centre_{};
    double square_ = 0, radius_square_ = 0, unit_ = 0;
    bool flat_ = true;
};

}  // namespace ravel
