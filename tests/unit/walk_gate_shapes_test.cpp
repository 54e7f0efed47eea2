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
    CHECK(shape_of({1, 2, 0}, 3, 1.0, place).first == 2);
}

TEST_CASE("shapes are told apart by the step") {
    CHECK(shape({0, 1, 2}, 3, 4) == shape({10, 11, 12}, 13, 4));
    CHECK(shape({0, 1, 2}, 3, 1) != shape({10, 11, 12}, 13, 1));
}

TEST_CASE("the last gate of a shape leads the next, until another shape takes its place") {
    GateShapes shapes(4, 1);
    Leader leader;
    shapes.enter({0, 1, 2}, 3, {30, {10, 11, 12}}, leader, place);
    CHECK(leader.facet == kNone);
    shapes.enter({6, 7, 5}, 8, {31, {16, 17, 15}}, leader, place);
    REQUIRE(leader.facet == 30);
    CHECK(leader.corner == std::array<Id, 3>{11, 12, 10});
    shapes.enter({0, 1, 2}, 4, {32, {}}, leader, place);
    CHECK(leader.facet == kNone);
    shapes.enter({2, 0, 1}, 3, {33, {}}, leader, place);
    REQUIRE(leader.facet == 31);
    CHECK(leader.corner == std::array<Id, 3>{17, 15, 16});
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
