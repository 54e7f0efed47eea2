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

// Vertices of `tets` tets whose facets opposite the last corner (0, b, c) all want one place of a
// table of 2^14.
std::vector<Id> colliding_tets(std::size_t tets) {
    std::vector<Id> vertex;
    for (Id b = 1; vertex.size() < 4 * tets; ++b)
        for (Id c = b + 1; c < b + 4000 && vertex.size() < 4 * tets; ++c)
            if ((hash_of(0, b, c) & 0x3FFF) == 77)
                for (const Id v : {Id{0}, b, c, Id{4'000'000'000u}}) vertex.push_back(v);
    return vertex;
}

}  // namespace

TEST_CASE("facets whose vertices are chosen to collide are found, and crowd the tree alone") {
    constexpr std::size_t kTets = 6000;
    const std::vector<Id> vertex = colliding_tets(kTets);
    TetFront front(vertex);
    const auto facet = [](std::size_t tet) { return static_cast<Id>(4 * tet + 3); };
    for (std::size_t t = 0; t < kTets; ++t) {
        REQUIRE(front.find(facet(t)) == kNone);
        front.insert(facet(t));
    }
    // Were it not for the tree, the last of them would be looked for among thousands.
    CHECK(front.crowd() > kTets / 2);
    for (std::size_t t = 0; t < kTets; ++t) REQUIRE(front.find(facet(t)) == facet(t));
    for (std::size_t t = 0; t < kTets; t += 2) front.erase(facet(t));
    for (std::size_t t = 0; t < kTets; ++t)
        REQUIRE(front.find(facet(t)) == (t % 2 == 0 ? kNone : facet(t)));
    for (std::size_t t = 0; t < kTets; t += 2) front.insert(facet(t));
    for (std::size_t t = 0; t < kTets; ++t) REQUIRE(front.find(facet(t)) == facet(t));
}

TEST_CASE("facets of an ordinary front hardly crowd") {
    std::vector<Id> vertex;
    for (Id i = 0; i < 40000; ++i)
        for (const Id v : {i, i + 1, i + 2, i + 3}) vertex.push_back(v);
    TetFront front(vertex);
    for (Id t = 0; t < vertex.size() / 4; ++t) front.insert(4 * t + 3);
    for (Id t = 0; t < vertex.size() / 4; ++t) REQUIRE(front.find(4 * t + 3) == 4 * t + 3);
    CHECK(front.crowd() < 100);
}
