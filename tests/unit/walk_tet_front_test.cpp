#include "walk/tet_front.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace ravel;

namespace {

// The attacker knows the hash.
std::uint64_t hash_of(Id a, Id b, Id c) {
    std::uint64_t h = a * 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 29) ^ b) * 0xBF58476D1CE4E5B9u;
    h = (h ^ (h >> 32) ^ c) * 0x94D049BB133111EBu;
    return h ^ (h >> 31);
}

constexpr Id kNewest = 20000;
// Pairs a, b such that the triangles (a, b, kNewest) all want one place of a table of 2^14.
std::vector<std::array<Id, 2>> colliding_pairs(std::size_t count) {
    std::vector<std::array<Id, 2>> pairs;
    for (Id a = 0; pairs.size() < count; ++a)
        for (Id b = a + 1; b < a + 6000 && pairs.size() < count; ++b)
            if ((hash_of(a, b, kNewest) & 0x3FFF) == 77) pairs.push_back({a, b});
    return pairs;
}

// The front triangle of a seed tet's facet without the apex.
Id triangle_of(TetFront& front, Id a, Id b, Id c) {
    return front.add_seed({a, b, c, 4'000'000'000u}, 0)[3];
}

// Every edge has a mate that has it as mate, and the same two vertices at its ends.
void check_closed(const TetFront& front, const std::vector<Id>& triangles) {
    for (const Id t : triangles)
        for (Id e = 0; e < 3; ++e) {
            const auto& here = front[t];
            const Id mate = here.mate[e];
            const auto& there = front[mate >> 2];
            REQUIRE(there.mate[mate & 3] == (t << 2 | e));
            REQUIRE(there.fan[mate & 3] == here.fan[e]);
            // Outward triangles run along a common edge in opposite directions.
            CHECK(here.vertex[(e + 1) % 3] == there.vertex[((mate & 3) + 2) % 3]);
            CHECK(here.vertex[(e + 2) % 3] == there.vertex[((mate & 3) + 1) % 3]);
        }
}

}  // namespace

TEST_CASE("a front of tets is a closed surface while it grows and is glued") {
    TetFront front;
    const auto seed = front.add_seed({0, 1, 2, 3}, 0);
    check_closed(front, {seed.begin(), seed.end()});
    // Round the edge 0 1: a tet through the facet opposite corner 3 and on, until it closes.
    const auto second = front.add_tet(seed[3], 4, 4);
    check_closed(front, {seed[0], seed[1], seed[2], second[0], second[1], second[2]});
    CHECK(front.apex_across(front[second[1]], 2) == 3);
    CHECK(front[second[1]].fan[2] == 2);
    // Through the triangle (0 1 4), whose apex becomes 3: it meets the facet (1 0 3) of the first.
    Id gate = kNone;
    for (const Id t : second) {
        const auto& v = front[t].vertex;
        if (std::find(v.begin(), v.end(), 2u) == v.end()) gate = t;
    }
    REQUIRE(gate != kNone);
    const auto third = front.add_tet(gate, 3, 8);
    Id other = kNone, mine = kNone;
    for (const Id t : third)
        for (const Id old : {seed[0], seed[1], seed[2]}) {
            auto a = front[t].vertex, b = front[old].vertex;
            std::sort(a.begin(), a.end());
            std::sort(b.begin(), b.end());
            if (a == b) mine = t, other = old;
        }
    REQUIRE(other != kNone);
    // Across the gate's edge it is found without the hash, and nothing else is.
    for (const Id t : third) CHECK(front.find(t) == (t == mine ? other : kNone));
    front.glue(mine, other);
    std::vector<Id> left;
    for (const Id t : {seed[0], seed[1], seed[2]})
        if (t != other) left.push_back(t);
    for (const Id t : second)
        if (t != gate) left.push_back(t);
    for (const Id t : third)
        if (t != mine) left.push_back(t);
    check_closed(front, left);
}

TEST_CASE("triangles whose vertices are chosen to collide are found, by another hash") {
    constexpr std::size_t kTriangles = 6000;
    TetFront front;
    std::vector<Id> triangle;
    for (const auto& [a, b] : colliding_pairs(kTriangles))
        triangle.push_back(triangle_of(front, a, b, kNewest));
    for (const Id t : triangle) {
        REQUIRE(front.find(t) == kNone);
        front.insert(t);
    }
    // Were it not for another hash, the last of them would be looked for among thousands.
    CHECK(front.open().changes() > 0);
    CHECK(front.open().changes() < 4);
    CHECK(front.open().places() < 64 * kTriangles);
    for (const Id t : triangle) REQUIRE(front.find(t) == t);
    for (std::size_t i = 0; i < kTriangles; i += 2) front.erase(triangle[i]);
    for (std::size_t i = 0; i < kTriangles; ++i)
        REQUIRE(front.find(triangle[i]) == (i % 2 == 0 ? kNone : triangle[i]));
    for (std::size_t i = 0; i < kTriangles; i += 2) front.insert(triangle[i]);
    for (const Id t : triangle) REQUIRE(front.find(t) == t);
}

TEST_CASE("the triangles of a crowded vertex are found in the hash, those of others in lists") {
    TetFront front;
    std::vector<Id> triangle;
    for (Id i = 0; i < 500; ++i) {
        triangle.push_back(triangle_of(front, i, i + 1, kNewest));
        triangle.push_back(triangle_of(front, i, i + 1, kNewest + 1 + i));
    }
    for (const Id t : triangle) {
        REQUIRE(front.find(t) == kNone);
        front.insert(t);
    }
    CHECK(front.open().places() >= 500);
    CHECK(front.open().places() < 500 * 16);
    for (const Id t : triangle) REQUIRE(front.find(t) == t);
    for (std::size_t i = 0; i < triangle.size(); i += 3) front.erase(triangle[i]);
    for (std::size_t i = 0; i < triangle.size(); i += 3) front.erase(triangle[i]);  // is gone
    for (std::size_t i = 0; i < triangle.size(); ++i)
        REQUIRE(front.find(triangle[i]) == (i % 3 == 0 ? kNone : triangle[i]));
}

TEST_CASE("the hash of an ordinary front stays empty") {
    TetFront front;
    std::vector<Id> triangle;
    for (Id i = 0; i < 40000; ++i) triangle.push_back(triangle_of(front, i, i + 1, i + 2));
    for (const Id t : triangle) front.insert(t);
    for (const Id t : triangle) REQUIRE(front.find(t) == t);
    CHECK(front.open().changes() == 0);
    CHECK(front.open().places() == 0);
}
