#include "predict/round_faces.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace ravel;

namespace {

// In sixteenths: a sphere of radius 10 about (1, 2, 3), a cylinder of radius 5 along (1, 1, 0)
// through the origin, and a torus about the z axis.
const RoundFace kSphere{RoundKind::sphere, {16, 32, 48}, {}, 160, 0};
const RoundFace kCylinder{RoundKind::cylinder, {0, 0, 0}, {7, 7, 0}, 80, 0};
const RoundFace kTorus{RoundKind::torus, {0, 0, 0}, {0, 0, 3}, 32, 160};

double distance(const RoundFace& face, const Point3& p) {
    return outside_of(shape_of(face), p).distance;
}

}  // namespace

TEST_CASE("how far a point is outside a round face") {
    CHECK(distance(kSphere, {1, 2, 3}) == -10);
    CHECK(distance(kSphere, {1, 14, 3}) == 2);
    CHECK(distance(kCylinder, {4, 4, 7}) == Approx(2));
    CHECK(distance(kCylinder, {100, 100, 0}) == Approx(-5).margin(1e-9));
    CHECK(distance(kTorus, {10, 0, 0}) == -2);
    CHECK(distance(kTorus, {0, -10, 5}) == 3);
    CHECK(distance(kTorus, {0, 0, 0}) == 8);
}

TEST_CASE("out of a round face goes away from its middle") {
    for (const RoundFace& face : {kSphere, kCylinder, kTorus})
        for (int i = 0; i < 60; ++i) {
            const Point3 p{std::sin(i * 1.1) * 12, std::cos(i * 2.3) * 9, std::sin(i * 0.7) * 5};
            const Outside outside = outside_of(shape_of(face), p);
            CHECK(length(outside.way) == Approx(1));
            Point3 q;
            for (std::size_t k = 0; k < 3; ++k) q[k] = p[k] + 0.01 * outside.way[k];
            CHECK(distance(face, q) == Approx(outside.distance + 0.01).margin(1e-4));
            CHECK(distance(face, moved_onto(shape_of(face), p)) == Approx(0).margin(1e-9));
        }
}

TEST_CASE("a coordinate is told by the others where the face is not along its axis") {
    for (const RoundFace& face : {kSphere, kCylinder, kTorus}) {
        const RoundShape shape = shape_of(face);
        int told = 0;
        for (int i = 0; i < 60; ++i) {
            const Point3 on = moved_onto(
                shape, {std::sin(i * 1.1) * 12, std::cos(i * 2.3) * 9, std::sin(i * 0.7) * 5});
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (std::abs(outside_of(shape, on).way[axis]) < 0.5) continue;
                Point3 p = on;
                p[axis] += 0.3;
                CHECK(coordinate_on(shape, p, axis) == Approx(on[axis]).margin(1.0 / 128));
                ++told;
            }
        }
        CHECK(told > 60);
    }
}

TEST_CASE("a coordinate that a face does not tell stays") {
    const RoundShape sphere = shape_of(kSphere);
    CHECK(coordinate_on(sphere, {1, 2, 30}, 0) == 1);   // the face lies along x there
    CHECK(coordinate_on(sphere, {1, 2, 3}, 1) == 2);    // the middle has no way out
    CHECK(coordinate_on(sphere, {60, 60, 4}, 2) == 4);  // beside it
    const RoundShape axle = shape_of({RoundKind::cylinder, {0, 0, 0}, {0, 0, 0}, 16, 0});
    CHECK(std::isfinite(coordinate_on(axle, {3, 0, 0}, 0)));  // no axis: a sphere
    const RoundShape huge = shape_of({RoundKind::torus,
                                      {kMostRoundLength, -kMostRoundLength, 0},
                                      {kMostRoundAxis, 1, -kMostRoundAxis},
                                      kMostRoundLength,
                                      kMostRoundLength});
    for (std::size_t axis = 0; axis < 3; ++axis) {
        CHECK(std::isfinite(coordinate_on(huge, {0x1p53, -0x1p53, 0x1p53}, axis)));
        CHECK(std::isfinite(moved_onto(huge, {0x1p53, -0x1p53, 0x1p53})[axis]));
    }
}

TEST_CASE("vertices lie on the faces that hold them, and a triangle on those of all its corners") {
    RoundFaces faces({{kSphere, kTorus}, 2, 0});
    for (const Point3& p : {Point3{11, 2, 3}, Point3{1, 12, 3}, Point3{1, 2, 13}, Point3{12, 0, 0},
                            Point3{0, 12, 0}, Point3{10, 0, 2}, Point3{50, 50, 50}})
        faces.insert(p);
    const auto face = [&](Id a, Id b, Id c) {
        return faces.of(stencil_of(Configuration::border, {a, b, c, 6}));
    };
    CHECK(face(0, 1, 2) == 0);
    CHECK(face(3, 4, 5) == 1);
    CHECK(face(2, 3, 4) == kNone);
    CHECK(face(0, 1, 6) == kNone);
    CHECK(faces.holds(0, {11.9, 2, 3}));
    CHECK(!faces.holds(0, {12, 2, 3}));
    CHECK(RoundFaces({{kSphere}, 1, 4}).holds(0, {26.9, 2, 3}));
    CHECK(RoundFaces().of(stencil_of(Configuration::border, {0, 1, 2, 6})) == kNone);
}
