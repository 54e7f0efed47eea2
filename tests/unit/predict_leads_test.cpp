// Which earlier part leads the one at hand, and how far off what it says is expected to be.
#include <catch2/catch.hpp>

#include <limits>
#include <vector>

#include "predict/follow_sizes.h"
#include "predict/leads.h"

using namespace ravel;

namespace {

// A part of one quad: three seeds, then the fourth corner.
constexpr Id kCorners = 4;
Stencil stencil_at(Id v) {
    if (v % kCorners == 3) return stencil_of(Configuration::quad_fourth, {v - 3, v - 1, v - 2});
    Stencil stencil;
    for (Id k = 0; k < 3 && k < v; ++k) stencil.at[k] = v - 1 - k;
    stencil.variant = static_cast<std::uint8_t>(v % kCorners);
    return stencil;
}

// The place of corner v: rectangles of the given widths, in a row.
Point3 corner(Id v, double width) {
    const double x = v % kCorners == 1 || v % kCorners == 2 ? width : 0;
    return {100.0 * (v / kCorners) + x, v % kCorners >= 2 ? 7.0 : 0.0, 0};
}

}  // namespace

TEST_CASE("leaders: the part that led goes on, then those with sides most alike, the last first") {
    const std::vector<double> widths{10, 20, 30, 20, 12, 20};
    Courses courses(256);
    std::vector<Point3> values;
    for (Id v = 0; v < kCorners * widths.size(); ++v) {
        const Stencil stencil = stencil_at(v);
        courses.enter(stencil, v);
        if (v == 23) {
            LeadList list(courses, stencil, v);
            CHECK_FALSE(list.goes_on());
            REQUIRE(list.size() == 5);
            list.sort(values, 5);
            // Of width 20, 20, 12, 10 and 30: of those as unlike the last comes first.
            for (std::size_t i = 0; i < 5; ++i)
                CHECK(list[i] == std::vector<Id>{15, 7, 19, 3, 11}[i]);
            courses.lead(3, 7);  // four vertices before: the part before this one
            LeadList on(courses, stencil, v);
            CHECK(on.goes_on());
            REQUIRE(on.size() == 5);
            on.sort(values, 3);
            CHECK(on[0] == 19);
            CHECK(on[1] == 15);
            CHECK(on[2] == 7);
        } else {
            CHECK(courses.in_seed() == (v % kCorners != 3));
        }
        courses.insert(v);
        values.push_back(corner(v, widths[v / kCorners]));
    }
}

TEST_CASE("seeds are led by what was so many parts before, as it served of late") {
    // Three widths take turns: after a few parts the one three parts before leads.
    Courses courses(256);
    SeedLeads seeds;
    for (Id v = 0; v < 120; ++v) {
        const Stencil stencil = stencil_at(v);
        courses.enter(stencil, v);
        if (courses.in_seed()) {
            const Id leader = seeds.leader(courses, stencil, v);
            if (v < kCorners) CHECK(leader == kNone);
            if (v >= 40 && v % kCorners != 0) CHECK(leader == v - 3 * kCorners);
            if (v % kCorners == 1 && v >= 2 * kCorners) CHECK(leader % kCorners == 1);
            const double width = 10.0 * (1 + v / kCorners % 3);
            seeds.missed(courses, v, v % kCorners == 0 ? Point3{90, 0, 0} : Point3{width, 1, 0});
        }
        courses.insert(v);
    }
}

TEST_CASE("what leaders say is expected to be off as it was, seeds apart from others") {
    FollowSizes sizes;
    const Stencil seed, other = stencil_at(3);
    const auto follow = [&](const Stencil& stencil, std::int64_t off) {
        sizes.begin(stencil);
        for (std::size_t axis = 0; axis < 3; ++axis) sizes.coded(off);
        sizes.end();
    };
    for (int i = 0; i < 20; ++i) follow(seed, 1 << 20), follow(other, 0);
    sizes.begin(other);
    CHECK(sizes.far() == 0);
    CHECK(sizes.scale(0).context < 4);
    sizes.coded(5000);
    CHECK(sizes.scale(1).context > 10);
    sizes.begin(seed);
    CHECK(sizes.far() == 3);
    CHECK(sizes.scale(0).context > 40);
    for (int i = 0; i < 60; ++i) follow(seed, std::numeric_limits<std::int64_t>::min());
    sizes.begin(seed);
    CHECK(sizes.scale(2).context < kScales);
    CHECK(sizes.scale(2).kind == 0);  // too large for a kind
}
