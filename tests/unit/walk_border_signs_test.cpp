#include "walk/border_signs.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "walk/apex_signs.h"

using namespace ravel;

namespace {

// Counter-clockwise from above, its tet below.
const std::array<Point3, 3> kFacet{{{0, 0, 0}, {100, 0, 0}, {50, 87, 0}}};
const Point3 kBehind{50, 29, -80};

// Across the first edge of kFacet, turned upwards by `angle` from going straight on.
std::array<Point3, 3> mate_at(double angle) {
    return {{{100, 0, 0}, {0, 0, 0}, {50, -87 * std::cos(angle), 87 * std::sin(angle)}}};
}
void meet(BorderSigns& signs, double angle, bool border) {
    const auto mate = mate_at(angle);
    signs.meet(signs.height_of(mate[2]), border, [&] { return mate; });
}

ApexSigns signs_of(const std::array<Point3, 3>& gate, const Point3& apex) {
    return {gate, SphereFamily(gate[0], gate[1], gate[2], false), apex};
}

}  // namespace

TEST_CASE("a border beside is the flatter the less it turns, whichever way") {
    std::uint32_t flattest = 7;
    for (const double angle : {0.0, 0.05, 0.2, 0.6, 1.0, 2.0})
        for (const double turned : {angle, -angle}) {
            BorderSigns signs(kFacet, kBehind, 1);
            signs.vertices = 2;
            meet(signs, turned, true);
            CHECK(signs.beside == 1);
            CHECK(signs.flat <= flattest);
            CHECK(signs.flat >= 1);
            CHECK(signs.valley == 0);
            CHECK(signs.around() == 3 + signs.flat);
            flattest = signs.flat;
        }
    CHECK(flattest == 1);
}

TEST_CASE(
    "a neighbour that is no border makes a valley where it rises, a steep one from upright on") {
    const auto valley = [](double angle, double side) {
        BorderSigns signs(kFacet, kBehind, side);
        meet(signs, angle, false);
        CHECK(signs.beside == 0);
        return signs.valley;
    };
    CHECK(valley(-0.5, 1) == 0);
    CHECK(valley(0.5, 1) == 1);
    CHECK(valley(2, 1) == 2);
    CHECK(valley(0.5, -1) == 0);
    CHECK(valley(-2, -1) == 2);
}

TEST_CASE("what is around a facet has a number of its own, below 28") {
    std::vector<bool> seen(28);
    const auto take = [&](std::uint32_t vertices, std::uint32_t beside, std::uint32_t flat) {
        BorderSigns signs(kFacet, kBehind, 1);
        signs.vertices = vertices;
        signs.beside = beside;
        signs.flat = flat;
        REQUIRE(signs.around() < seen.size());
        CHECK_FALSE(seen[signs.around()]);
        seen[signs.around()] = true;
    };
    for (std::uint32_t n = 0; n < 4; ++n) take(n, 0, 0);
    for (std::uint32_t flat = 1; flat <= 6; ++flat) {
        take(2, 1, flat);
        take(3, 1, flat);
        take(3, 2, flat);
        take(3, 3, flat);
    }
    CHECK(std::count(seen.begin(), seen.end(), true) == 28);
}

TEST_CASE("shapes are told by ratios, and a facet without an area has one, too") {
    const auto shape = [](double scale, double depth, double length) {
        auto facet = kFacet;
        for (Point3& p : facet)
            for (double& x : p) x *= scale;
        return BorderSigns(facet, {50 * scale, 29 * scale, -depth * scale}, 1)
            .shape(length * scale);
    };
    for (const double scale : {1.0, 0x1p-20, 0x1p30}) {
        CHECK(shape(scale, 40, 60) == 0);
        CHECK(shape(scale, 60, 60) == 3);
        CHECK(shape(scale, 80, 60) == 6);
        CHECK(shape(scale, 80, 50) == 7);
        CHECK(shape(scale, 80, 30) == 8);
    }
    BorderSigns none({}, {}, 1);
    meet(none, 1, false);
    CHECK(none.around() == 0);
    CHECK(none.shape(1) < 9);
}

TEST_CASE("an apex is told by its height and by how far it is") {
    const auto at = [](double height) { return signs_of(kFacet, {50, 29, height}); };
    std::uint32_t last = 0;
    for (const double height : {0.0, 20.0, 40.0, 60.0, 90.0, 120.0}) {
        CHECK(at(height).height() >= last);
        CHECK(at(-height).height() == at(height).height());
        last = at(height).height();
    }
    CHECK(last == 4);
    CHECK(at(80).reach(100) == 0);
    CHECK(at(80).reach(50) == 1);
    CHECK(at(80).reach(20) == 3);
    CHECK(signs_of({}, {}).height() == 4);
}
