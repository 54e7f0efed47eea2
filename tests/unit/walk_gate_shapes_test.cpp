// Gates of one shape.
#include <catch2/catch.hpp>

#include <vector>

#include "walk/gate_shapes.h"

using namespace ravel;

namespace {

const std::vector<Point3> kPlaces{{0, 0, 0},   {8, 0, 0},    {0, 8, 0},   {0, 0, -8},  {3, 3, 8},
                                  {80, 40, 8}, {88, 40, 8},  {80, 48, 8}, {80, 40, 0}, {83, 43, 16},
                                  {200, 0, 0}, {208, 1, -1}, {200, 8, 0}, {200, 0, -8}};

const Point3& place(Id v) {
    return kPlaces[v];
}

std::uint64_t shape(const std::array<Id, 3>& gate, Id behind, double step = 4) {
    return shape_of(gate, behind, 1 / step, place).shape;
}

}  // namespace

TEST_CASE("shapes are the same wherever a gate lies, and whichever corner is named first") {
    CHECK(shape({0, 1, 2}, 3) == shape({5, 6, 7}, 8));
    CHECK(shape({0, 1, 2}, 3) == shape({1, 2, 0}, 3));
    CHECK(shape({0, 1, 2}, 3) == shape({7, 5, 6}, 8));
    CHECK(shape({0, 1, 2}, 3) != shape({0, 2, 1}, 3));  // seen from the other side
    CHECK(shape({0, 1, 2}, 3) != shape({0, 1, 2}, 4));  // another apex behind
    CHECK(shape_of({1, 2, 0}, 3, 1.0, place).corner == 0);
}

TEST_CASE("shapes are told apart by the step") {
    CHECK(shape({0, 1, 2}, 3, 4) == shape({10, 11, 12}, 13, 4));
    CHECK(shape({0, 1, 2}, 3, 1) != shape({10, 11, 12}, 13, 1));
}

TEST_CASE("a leader tells where the apex is, until another shape takes its place") {
    GateShapes shapes(4, 1);
    shapes.enter({0, 1, 2}, 3, place);
    CHECK(shapes.leader().apex == kNone);
    shapes.learn(4);
    shapes.enter({6, 7, 5}, 8, place);
    REQUIRE(shapes.leader().apex == 4);
    CHECK(shapes.leader().corner == 0);
    CHECK(shapes.corner() == 5);
    CHECK(shapes.expected(place) == place(9));
    shapes.learn(9);
    shapes.enter({0, 1, 2}, 4, place);
    CHECK(shapes.leader().apex == kNone);
    shapes.enter({0, 1, 2}, 3, place);
    CHECK(shapes.leader().apex == 9);
}

TEST_CASE("the nearest vertex of the front is none of the gate's, and of equals the oldest") {
    VertexGrid grid(4, {30, 30, 30});
    for (const Id v : {0, 1, 2}) grid.insert(v, place(v));
    CHECK(nearest_on_front(grid, {0, 1, 2}, {1, 0, 0}, 4) == kNone);
    CHECK(nearest_on_front(grid, {5, 1, 2}, {1, 0, 0}, 4) == 0);
    CHECK(nearest_on_front(grid, {5, 6, 7}, {4, 0, 0}, 5) == 0);
    CHECK(nearest_on_front(grid, {5, 6, 7}, {4, 0, 0}, 4) == kNone);  // no nearer than that
    CHECK(nearest_on_front(grid, {5, 6, 7}, {7, 0, 0}, 4) == 1);
}
