#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "predict/border_plane.h"
#include "predict/predictor.h"
#include "predict/residual_context.h"

namespace {

using namespace ravel;

// A gate on edge a b of length 100 along x; the border's triangle lies behind it in z = 0, and the
// gate's third vertex is turned by `angle` from that triangle, through the mesh below.
std::vector<Point3> gate_at(double angle) {
    return {{0, 0, 0},      {100, 0, 0},   {50, -90 * std::cos(angle), -90 * std::sin(angle)},
            {50, -90, -90}, {50, 90, -90}, {50, -90, -90},
            {50, -90, 0}};
}
Stencil stencil_of_gate() {
    Stencil stencil = stencil_of(Configuration::tet, {0, 1, 2, 3, 4, 5, 6});
    stencil.borders = 4;
    return stencil;
}

}  // namespace

TEST_CASE("the stencil along a border is the edge, the triangle's apex and the gate's") {
    const Stencil border = along_border(stencil_of_gate(), 2);
    CHECK(border.configuration == Configuration::border);
    CHECK(border.at[0] == 0);
    CHECK(border.at[1] == 1);
    CHECK(border.at[2] == 6);
    CHECK(border.at[3] == 2);
    CHECK(std::all_of(border.at.begin() + 4, border.at.end(), [](Id v) { return v == kNone; }));
}

TEST_CASE("a gate opens from a border's triangle in classes") {
    const Stencil border = along_border(stencil_of_gate(), 2);
    const double half_turn = std::acos(-1.0);
    std::uint32_t last = 0;
    for (int step = 0; step <= 16; ++step) {
        const BorderPlane plane(border, gate_at(half_turn * step / 16));
        REQUIRE(plane.exists());
        CHECK(plane.opening() >= last);
        last = plane.opening();
        if (step == 0) CHECK(last == 0);
        if (step == 8) CHECK((last == 7 || last == 8));
    }
    CHECK(last == 15);
}

TEST_CASE("a border's plane tells the coordinate across which it lies") {
    // x + 2 y + 4 z = 0
    const std::vector<Point3> values{{0, 0, 0}, {4, 0, -1}, {0, -2, 1}, {1, 1, 1}};
    const Stencil border = stencil_of(Configuration::border, {0, 1, 2, 3});
    const BorderPlane plane(border, values);
    CHECK(plane.axes() == std::array<std::size_t, 3>{0, 1, 2});
    CHECK(plane.carried({0, 0, 0}, {8, 4, 0}) == -4);
    // Parallel to it through a guess that is not on it.
    CHECK(plane.carried({0, 0, 5}, {8, 4, 0}) == 1);
    CHECK(lies_along(border, values, {8, 4, -4}));
    CHECK(!lies_along(border, values, {8, 4, 0}));
}

TEST_CASE("the axis across a plane is the last, of equals the highest") {
    const auto axes_of = [](const Point3& b, const Point3& y) {
        const std::vector<Point3> values{{0, 0, 0}, b, y, {0, 0, 0}};
        return BorderPlane(stencil_of(Configuration::border, {0, 1, 2, 3}), values).axes();
    };
    CHECK(axes_of({0, 1, 0}, {0, 0, 1}) == std::array<std::size_t, 3>{1, 2, 0});
    CHECK(axes_of({1, 0, 0}, {0, 0, 1}) == std::array<std::size_t, 3>{0, 2, 1});
    CHECK(axes_of({1, -1, 0}, {0, 1, -1}) == std::array<std::size_t, 3>{0, 1, 2});
    CHECK(axes_of({1, -1, 0}, {0, 0, 1}) == std::array<std::size_t, 3>{0, 2, 1});
}

TEST_CASE("a border without area has no plane") {
    const std::vector<Point3> values{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 1, 0}};
    const Stencil border = stencil_of(Configuration::border, {0, 1, 2, 3});
    CHECK(!BorderPlane(border, values).exists());
    CHECK(!lies_along(border, values, {0, 0, 0}));
}

TEST_CASE("a vertex along a border is guessed beyond the edge, in the triangle's plane") {
    const Stencil border = along_border(stencil_of_gate(), 2);
    const Point3 g = Predictor(kDefaultWeights, false).guess(border, gate_at(2));
    CHECK(g[0] == Approx(50));
    CHECK(g[1] > 40);
    CHECK(g[1] < 120);
    CHECK(g[2] == Approx(0).margin(1e-9));
}

TEST_CASE("how far off a plane is expected from those before, not from the axis") {
    ResidualSizes sizes;
    Stencil stencil;
    const auto vertex = [&](std::uint64_t off, std::uint64_t by_guess) {
        sizes.begin(stencil);
        for (std::size_t axis = 0; axis < 2; ++axis) sizes.coded(axis, 1000);
        const Scale scale = sizes.scale_off_plane();
        sizes.coded(2, off);
        sizes.coded_off_plane(2, by_guess);
        sizes.push();
        return scale.bits;
    };
    const std::uint32_t first = vertex(1, 1000);
    stencil = stencil_of(Configuration::border, {0, kNone, kNone});
    std::uint32_t least = first;
    for (Id v = 1; v < 40; ++v) {
        stencil.at[0] = v - 1;
        least = vertex(1, 1000);
    }
    CHECK(least < first);
    // The axis itself is expected to be as large as it was without the plane.
    sizes.begin(stencil);
    CHECK(sizes.scale(2, 2).bits > least + 4);
}
