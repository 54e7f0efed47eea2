// The grid that finds front vertices, against a look at all of them.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "walk/apex_list.h"
#include "walk/vertex_grid.h"

using namespace ravel;

namespace {

struct Case {
    double side;
    std::array<std::uint32_t, 3> count;
};

// The cube that a coordinate is in.
double cube_of(const Case& c, double x, std::size_t axis) {
    return std::clamp(std::floor(x * (1 / c.side)), 0.0, static_cast<double>(c.count[axis] - 1));
}

}  // namespace

TEST_CASE("the grid finds the vertices in the cubes of a box, each once, whatever came and went") {
    std::mt19937 random(7);
    const auto below = [&](double most) {
        return std::floor(std::uniform_real_distribution<double>(0, most)(random));
    };
    for (const Case& c : {Case{1, {1, 1, 1}}, Case{3, {9, 6, 7}}, Case{10, {1, 40, 2}},
                          Case{2, {33, 5, 4}}, Case{1000, {4, 4, 4}}}) {
        VertexGrid grid(c.side, c.count);
        std::vector<Point3> place;
        std::vector<bool> in;
        const double size = c.side * *std::max_element(c.count.begin(), c.count.end());
        for (int step = 0; step < 3000; ++step) {
            const auto v = static_cast<Id>(place.size());
            if (step % 3 < 2) {
                // Also outside, where the nearest cube has them.
                place.push_back({below(1.2 * size), below(1.2 * size), below(1.2 * size) - c.side});
                in.push_back(true);
                grid.insert(v, place.back());
            } else {
                const auto gone = static_cast<Id>(below(static_cast<double>(v)));
                if (in[gone]) grid.erase(gone);
                in[gone] = false;
            }
            if (step % 10 != 0) continue;
            const Point3 centre{below(size), below(size), below(size)};
            const double radius = below(size / 3);
            std::vector<Id> found, want;
            grid.around(centre, radius, [&](Id u, const Point3& p) {
                CHECK(p == place[u]);
                found.push_back(u);
                return true;
            });
            for (Id u = 0; u < place.size(); ++u) {
                bool near = in[u];
                for (std::size_t k = 0; k < 3; ++k) {
                    const double cube = cube_of(c, place[u][k], k);
                    near = near && cube >= cube_of(c, centre[k] - radius, k) &&
                           cube <= cube_of(c, centre[k] + radius, k);
                }
                if (near) want.push_back(u);
            }
            std::sort(found.begin(), found.end());
            REQUIRE(found == want);
        }
    }
}

TEST_CASE("a box of very many blocks is not looked at, and a visitor can end a look") {
    VertexGrid grid(1, {40, 40, 40});
    for (Id v = 0; v < 20; ++v) grid.insert(v, {2.0 * v, 2.0 * v, 2.0 * v});
    std::size_t seen = 0;
    const auto count = [&](Id, const Point3&) { return ++seen < 3; };
    grid.around({20, 20, 20}, 100, count);
    CHECK(seen == 0);
    grid.around({20, 20, 20}, 10, count);
    CHECK(seen == 3);
}

TEST_CASE("apexes come by height, folds a little lower, what is not above last") {
    ApexList list;
    list.clear(32);
    const auto add = [&](Id vertex, double height, bool above, std::uint8_t times) {
        ApexCandidate candidate;
        candidate.vertex = vertex;
        candidate.height = height;
        candidate.above = above;
        candidate.times = times;
        list.add(candidate);
    };
    add(0, 9, true, 0);
    add(1, 0, false, 1);
    add(2, 5, true, 0);
    add(3, 7, true, 3);  // each fold counts as one lower
    add(4, 5, true, 0);  // as high as 2, which came before
    add(5, 0, false, 2);
    list.lift_two();
    CHECK(list[0].vertex == 3);
    CHECK(list[1].vertex == 2);
    list.sort();
    std::vector<Id> order;
    for (std::size_t i = 0; i < list.size(); ++i) order.push_back(list[i].vertex);
    CHECK(order == std::vector<Id>{3, 2, 4, 0, 5, 1});
    for (Id v = 6; v < 30; ++v) add(v, 1.0 + v, true, 0);
    list.sort();
    CHECK(list.size() == ApexList::kMost);
    CHECK(list[0].vertex == 3);
}
