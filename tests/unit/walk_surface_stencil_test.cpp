#include <catch2/catch.hpp>

#include "walk/surface_stencil.h"

using namespace ravel;

namespace {

// Triangles 0 1 2 and 0 3 1, and a third that is entered through the side from 1 to 2: its gate
// runs from 2 to 1, before it the front comes from 0, and behind it it goes on to 3.
struct Strip {
    Walked walked;
    Id base = 6, before = 2, after = 4;

    Strip() {
        walked.first = {0, 3, 6, 9};
        walked.of = {0, 0, 0, 1, 1, 1, 2, 2, 2};
        walked.vertex = {0, 1, 2, 0, 3, 1, 2, 1, kNone};
        walked.twin = {5, 6, kNone, kNone, kNone, 0, 1, kNone, kNone};
    }
};

std::vector<Id> first_eight(const Stencil& stencil) {
    return {stencil.at.begin(), stencil.at.begin() + 8};
}

}  // namespace

TEST_CASE("a triangle's stencil has the front beside its gate, and what is beyond it") {
    const Strip s;
    const Stencil stencil = triangle_stencil(s.walked, s.base, s.before, s.after, 3, 4);
    CHECK(stencil.configuration == Configuration::triangle);
    // a b, beyond them 0 twice; y behind b, x before a; beyond the sides there 0 and 1.
    CHECK(first_eight(stencil) == std::vector<Id>{2, 1, 0, 0, 3, 0, 0, 1});
    CHECK(stencil.at[8] == kNone);
}

TEST_CASE("the end of a triangle's gate with more cells around it comes as b, in a mirror image") {
    const Strip s;
    const Stencil stencil = triangle_stencil(s.walked, s.base, s.before, s.after, 4, 3);
    CHECK(first_eight(stencil) == std::vector<Id>{1, 2, 0, 0, 0, 3, 1, 0});
    std::array<std::array<std::uint8_t, 7>, 7> variant{};
    for (std::uint32_t a = 1; a <= 7; ++a)
        for (std::uint32_t b = 1; b <= 7; ++b)
            variant[a - 1][b - 1] =
                triangle_stencil(s.walked, s.base, s.before, s.after, a, b).variant;
    CHECK(variant[0] == std::array<std::uint8_t, 7>{0, 0, 1, 3, 6, 6, 6});
    CHECK(variant[6] == std::array<std::uint8_t, 7>{6, 6, 7, 8, 9, 9, 9});
    for (std::size_t a = 0; a < 7; ++a)
        for (std::size_t b = 0; b < 7; ++b) CHECK(variant[a][b] == variant[b][a]);
}
