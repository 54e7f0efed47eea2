#include "encode/round_fit.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace ravel;

namespace {

// A piece of a face about a point of it: points that lie on it but for `noise`, and small facets.
Patch patch_of(const RoundShape& shape, const Point3& about, double reach, double noise) {
    Patch patch;
    const auto at = [&](double a, double b, double c) {
        const Point3 p =
            moved_onto(shape, {about[0] + reach * a, about[1] + reach * b, about[2] + reach * c});
        return minus(p, about);
    };
    for (int i = 0; i < 40; ++i) {
        const double a = std::sin(i * 1.7), b = std::sin(i * 2.9 + 1), c = std::sin(i * 4.3 + 2);
        Point3 p = at(a, b, c);
        const Point3 q = at(a + 0.1, b, c), r = at(a, b + 0.1, c + 0.1);
        const Point3 n = cross(minus(q, p), minus(r, p));
        const double l = length(n);
        patch.facets.push_back(
            {{(p[0] + q[0] + r[0]) / 3, (p[1] + q[1] + r[1]) / 3, (p[2] + q[2] + r[2]) / 3},
             {n[0] / l, n[1] / l, n[2] / l}});
        for (double& x : p) x += noise * std::sin(i * 31.7 + x);
        patch.points.push_back(p);
        patch.size = std::max(patch.size, length(p));
    }
    return patch;
}

// Is one of the shapes that come near, refined, the one that was asked for?
bool finds(const RoundShape& shape, const Point3& near, double reach, double noise) {
    const Point3 about = moved_onto(shape, near);
    const Patch patch = patch_of(shape, about, reach, noise);
    for (RoundShape found : rounds_near(patch)) {
        if (found.kind != shape.kind) continue;
        if (!(refine(found, patch.points, patch.size, 16) < noise + 1e-6)) continue;
        if (std::abs(found.radius - shape.radius) < (noise + 1e-6) * 100 &&
            std::abs(found.ring - shape.ring) < (noise + 1e-6) * 100)
            return true;
    }
    return false;
}

constexpr double kPart = 0.6, kRest = 0.8;  // of an axis of length 1

}  // namespace

TEST_CASE("a sphere is found from a piece of it") {
    CHECK(finds({RoundKind::sphere, {100, 200, -50}, {}, 1000, 0}, {900, 200, 300}, 300, 0));
    CHECK(finds({RoundKind::sphere, {100, 200, -50}, {}, 1000, 0}, {900, 200, 300}, 600, 0.3));
}

TEST_CASE("a cylinder is found from a piece of it") {
    for (const Point3& axis : {Point3{0, 0, 1}, Point3{kPart, 0, kRest}})
        CHECK(finds({RoundKind::cylinder, {10, 20, 30}, axis, 400, 0}, {700, 600, 200}, 300, 0.2));
}

TEST_CASE("a torus is found from a piece of it, thick or thin") {
    for (const double ring : {700.0, 1500.0, 6000.0})
        for (const Point3& axis : {Point3{0, 0, 1}, Point3{0, kPart, kRest}})
            CHECK(finds({RoundKind::torus, {10, 20, 30}, axis, 400, ring}, {ring + 300, 200, 200},
                        350, 0));
}
