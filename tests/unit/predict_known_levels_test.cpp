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

TEST_CASE("a list keeps the eight levels that were had last") {
    KnownLevels known(5, 100);
    for (Id v = 0; v < 8; ++v) known.insert(0, 2 * v, v);
    known.insert(0, 0, 8);   // had again: the level of vertex 1 is the oldest now
    known.insert(0, 20, 9);  // and goes
    CHECK(known.nearest(0, 1).vertex == 0);
    CHECK(known.nearest(0, 1).count == 2);
    CHECK(known.nearest(0, 2).distance == 2);
    CHECK(known.nearest(0, 20).vertex == 9);
    CHECK(known.nearest(0, 4).vertex == 2);
    CHECK(known.nearest(1, 4).vertex == kNone);

    const KnownLevels::Near near = known.nearest(0, 5);
    known.count(near.list, near.place);
    CHECK(known.nearest(0, 4).count == near.count + 1);
}
