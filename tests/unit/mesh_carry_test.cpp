// What is carried from one tet to another.
#include <catch2/catch.hpp>

#include <cmath>
#include <random>

#include "mesh/carry.h"

using namespace ravel;

namespace {

struct Affine {
    std::array<Point3, 3> row;
    Point3 shift;

    Point3 operator()(const Point3& p) const {
        return {dot(row[0], p) + shift[0], dot(row[1], p) + shift[1], dot(row[2], p) + shift[2]};
    }
};

const Frame kTet{{{0, 0, 0}, {9, 0, 1}, {1, 8, 0}, {3, 2, -7}}};
const Point3 kApex{4, 3, 8};

Frame image(const Affine& map, const Frame& frame) {
    return {map(frame[0]), map(frame[1]), map(frame[2]), map(frame[3])};
}

double distance(const Point3& a, const Point3& b) {
    const Point3 way = minus(a, b);
    return std::sqrt(dot(way, way));
}

}  // namespace

TEST_CASE("an apex goes with the map that takes one tet to the other") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> some(-0.3, 0.3), far(-1000, 1000);
    for (int i = 0; i < 200; ++i) {
        Affine map;
        for (std::size_t k = 0; k < 3; ++k) {
            for (double& x : map.row[k]) x = some(random);
            map.row[k][k] += 1;
            map.shift[k] = far(random);
        }
        CHECK(distance(carried(kApex, kTet, image(map, kTet), true), map(kApex)) < 1e-9);
    }
}

TEST_CASE("a tet that is turned takes its apex along") {
    const Affine quarter{{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}, {5, 5, 5}};
    CHECK(distance(carried(kApex, kTet, image(quarter, kTet), true), quarter(kApex)) < 1e-9);
}

TEST_CASE("a move is exact, whatever the numbers") {
    const Affine move{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {4096, -0.125, 1e6}};
    for (const bool maps : {false, true}) {
        CHECK(carried(kApex, kTet, image(move, kTet), maps) == move(kApex));
        CHECK(carried({0.1, 0.7, 1e-9}, kTet, kTet, maps) == Point3{0.1, 0.7, 1e-9});
    }
}

TEST_CASE("where the map makes no sense the apex is moved") {
    const Frame to{{{100, 0, 0}, {109, 1, 0}, {101, 8, 0}, {103, 2, -7}}};
    const Point3 moved{104, 3, 8};
    Frame flat = kTet;
    flat[3] = {10, 8, 1};  // in the plane of the other three
    CHECK(carried(kApex, flat, to, true) == moved);
    Frame sliver = flat;
    sliver[3][2] += 1e-6;
    CHECK(carried(kApex, sliver, to, true) == moved);
    CHECK(carried(kApex, {}, to, true) == moved);
}

TEST_CASE("an apex that is not mapped goes with the middle of the gate") {
    Frame to = kTet;
    to[0][0] += 3;  // the middle moves by 1
    to[3] = {0, 0, -20};
    CHECK(carried(kApex, kTet, to, false) == Point3{5, 3, 8});
    CHECK(carried(kApex, {}, {}, false) == kApex);
}

TEST_CASE("mismatch is how far an edge ends from its like, squared") {
    Frame other = kTet;
    for (Point3& p : other) p[0] += 50;
    CHECK(mismatch(kTet, other) == 0);
    other[2][1] += 3;
    CHECK(mismatch(kTet, other) == 9);
    CHECK(mismatch(other, kTet) == 9);
    other[0][2] += 4;  // moves all three edges
    CHECK(mismatch(kTet, other) == 25);
}
