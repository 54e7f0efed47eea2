// Pairs of levels, against a look at all of them.
#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <random>

#include "predict/level_pairs.h"

using namespace ravel;

TEST_CASE("the nearest level beside a coordinate is found within half an interval") {
    std::mt19937 random(4);
    for (const int bits : {1, 4, 7}) {
        LevelPairs pairs(bits, 1 << 20);  // so many lists that hardly two share one
        std::map<std::pair<std::size_t, double>, std::map<double, Id>> all;
        const double half = std::ldexp(0.5, bits);
        std::size_t wrong = 0;
        for (Id v = 0; v < 1500; ++v) {
            const std::size_t axis = 1 + random() % 2;
            const double other = static_cast<double>(random() % 7) / 4 - 1;
            // Few to an interval, so that none is let go.
            const double x = std::ldexp(static_cast<double>(random() % 30), bits) -
                             std::ldexp(12, bits) + static_cast<double>(random() % 2);
            auto& known = all[{axis, other}];
            pairs.insert(axis, other, x, v);
            known.try_emplace(x, v);
            const double want = x + static_cast<double>(random() % 5) - 2;
            const LevelPairs::Near near = pairs.nearest(axis, other, want);
            double least = half;
            for (const auto& [level, _] : known) least = std::min(least, std::abs(level - want));
            if ((near.vertex != kNone) != (least < half) ||
                (near.vertex != kNone && near.distance != least)) {
                ++wrong;
                continue;
            }
            if (near.vertex == kNone) continue;
            const auto is = [&](auto found) {
                return found != known.end() && found->second == near.vertex;
            };
            wrong += !is(known.find(want - least)) && !is(known.find(want + least));
        }
        CHECK(wrong < 10);
    }
}

TEST_CASE("a list keeps the five levels that were had last, the last one first") {
    LevelPairs pairs(6, 100);
    for (Id v = 0; v < 5; ++v) pairs.insert(1, 3, 4 * v, v);
    CHECK(pairs.nearest(1, 3, 1).vertex == 0);
    CHECK(pairs.nearest(1, 3, 1).place == 4);
    pairs.insert(1, 3, 0, 7);  // had again: it is the first, and still that of vertex 0
    CHECK(pairs.nearest(1, 3, 1).vertex == 0);
    CHECK(pairs.nearest(1, 3, 1).place == 0);
    pairs.insert(1, 3, 40, 8);  // 4 was had before all others, and goes
    CHECK(pairs.nearest(1, 3, 40).place == 0);
    CHECK(pairs.nearest(1, 3, 4).distance == 4);
    CHECK(pairs.nearest(1, 3, 8).vertex == 2);
}

TEST_CASE("pairs are of one axis and of one coordinate before, zeros of either sign being one") {
    LevelPairs pairs(3, 1 << 20);
    pairs.insert(1, -0.0, 5, 11);
    CHECK(pairs.nearest(1, 0.0, 5).vertex == 11);
    CHECK(pairs.nearest(2, 0.0, 5).vertex == kNone);
    CHECK(pairs.nearest(1, 0.25, 5).vertex == kNone);
    CHECK(pairs.nearest(1, 0.0, 9).vertex == kNone);  // half an interval away
    CHECK(pairs.nearest(1, 0.0, 8.5).vertex == 11);
}
