// Known levels, against a look at all values.
#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <random>

#include "predict/known_levels.h"

using namespace ravel;

TEST_CASE(
    "the nearest level is found within half an interval, with its first vertex and its count") {
    std::mt19937 random(3);
    for (const int bits : {1, 4, 7}) {
        KnownLevels known(bits, 4000);
        struct Level {
            Id vertex;
            std::uint32_t count;
        };
        std::array<std::map<double, Level>, 3> all;
        const double half = std::ldexp(0.5, bits);
        for (Id v = 0; v < 1200; ++v)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                // Few to an interval, so that none is hidden behind others.
                const double x = std::ldexp(static_cast<double>(random() % 60), bits) -
                                 std::ldexp(20, bits) + static_cast<double>(random() % 2);
                known.insert(axis, x, v);
                ++all[axis].try_emplace(x, Level{v, 0}).first->second.count;
                const double want = x + static_cast<double>(random() % 5) - 2;
                const KnownLevels::Near near = known.nearest(axis, want);
                double least = half;
                for (const auto& [level, _] : all[axis])
                    least = std::min(least, std::abs(level - want));
                REQUIRE((near.vertex != kNone) == (least < half));
                if (near.vertex == kNone) continue;
                REQUIRE(near.distance == least);
                const auto below = all[axis].find(want - least),
                           above = all[axis].find(want + least);
                const auto is = [&](auto found) {
                    return found != all[axis].end() && found->second.vertex == near.vertex &&
                           found->second.count == near.count;
                };
                REQUIRE((is(below) || is(above)));
            }
    }
}

TEST_CASE("there are no more levels than vertices, and lists are looked at to a bound") {
    KnownLevels few(4, 2);
    few.insert(0, 100, 0);
    few.insert(1, 100, 0);
    few.insert(2, 100, 0);  // a third is not taken
    CHECK(few.nearest(0, 101).vertex == 0);
    CHECK(few.nearest(1, 99).vertex == 0);
    CHECK(few.nearest(2, 100).vertex == kNone);
    few.insert(0, 100, 1);
    CHECK(few.nearest(0, 100).count == 2);

    KnownLevels crowd(5, 100);
    for (Id v = 0; v < 13; ++v) crowd.insert(0, v, v);
    CHECK(crowd.nearest(0, 0).vertex == 1);  // the first is behind twelve others
}
