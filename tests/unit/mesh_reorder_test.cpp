#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>

#include "mesh/reorder.h"

using namespace ravel;

TEST_CASE("the turns of a tet are the 24 permutations in lexicographic order") {
    std::array<std::uint8_t, 4> p{0, 1, 2, 3};
    for (std::uint32_t n = 0; n < 24; ++n) {
        CHECK(tet_turn(n) == p);
        CHECK(number_of_tet_turn(p) == n);
        std::next_permutation(p.begin(), p.end());
    }
}

TEST_CASE("numbers that name no turn are no harm") {
    CHECK(tet_turn(24) == tet_turn(0));
}

TEST_CASE("turned corners run through the whole cell once") {
    for (std::uint32_t degree = 1; degree < 9; ++degree)
        for (std::uint32_t turn = 0; turn < degree; ++turn) {
            std::vector<bool> hit(degree, false);
            for (std::uint32_t i = 0; i < degree; ++i)
                hit.at(old_corner(CellKind::polygon, turn, degree, i)) = true;
            CHECK(std::count(hit.begin(), hit.end(), true) == degree);
            CHECK(old_corner(CellKind::polygon, turn, degree, 0) == turn);
        }
}

TEST_CASE("corners of the largest polygon are counted without overflow") {
    CHECK(old_corner(CellKind::polygon, 0xFFFFFFF0u, 0xFFFFFFF5u, 0xFFFFFFF4u) == 0xFFFFFFEFu);
}

TEST_CASE("an inverse turned round is the permutation") {
    CHECK(inverse_of({}, 0).empty());
    const std::vector<Index> from{3, 0, 2, 1};
    CHECK(inverse_of(inverse_of(from, 4), 4) == from);
    CHECK(inverse_of({2}, 4) == std::vector<Index>{kNoIndex, kNoIndex, 0, kNoIndex});
}

TEST_CASE("gathering takes whole tuples, and nothing from nothing") {
    Array array = make_array(Scalar::u16, 2, 3);
    std::iota(array.as<std::uint16_t>().begin(), array.as<std::uint16_t>().end(),
              std::uint16_t{10});
    const Array out = gather(array, {2, 0});
    REQUIRE(out.count() == 2);
    const auto values = out.as<std::uint16_t>();
    CHECK(std::vector<int>(values.begin(), values.end()) == std::vector<int>{14, 15, 10, 11});
    CHECK(gather(make_array(Scalar::f64, 3, 0), {}).bytes.empty());
}

TEST_CASE("references follow their elements; other numbers and components stay") {
    const std::vector<Index> point{2, 0, 1}, cell{1, 0};
    for (const Scalar scalar : {Scalar::i32, Scalar::i64}) {
        Attribute a;
        a.values = make_array(scalar, 2, 4);
        a.references = {{0, Place::point, 1}};
        const std::vector<int> before{1, 1, 3, 3, 0, 0, -1, 4}, after{3, 1, 2, 3, 0, 0, -1, 4};
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (scalar == Scalar::i32)
                a.values.as<std::int32_t>()[i] = before[i];
            else
                a.values.as<std::int64_t>()[i] = before[i];
        }
        renumber(a, point, cell);
        for (std::size_t i = 0; i < after.size(); ++i) {
            if (scalar == Scalar::i32)
                CHECK(a.values.as<std::int32_t>()[i] == after[i]);
            else
                CHECK(a.values.as<std::int64_t>()[i] == after[i]);
        }
    }
}

TEST_CASE("references there and back are the same numbers") {
    const std::vector<Index> point{2, 0, 3, 1}, cell{1, 0};
    Attribute a;
    a.values = make_array(Scalar::u64, 2, 3);
    a.references = {{0, Place::point, 0}, {1, Place::cell, -1}};
    const std::vector<std::uint64_t> before{0, ~std::uint64_t{0}, 3, 0, 9, 5};
    std::copy(before.begin(), before.end(), a.values.as<std::uint64_t>().begin());
    renumber(a, point, cell);
    CHECK(a.values.as<std::uint64_t>()[0] == 2);
    CHECK(a.values.as<std::uint64_t>()[1] == 0);
    renumber(a, inverse_of(point, 4), inverse_of(cell, 2));
    const auto after = a.values.as<std::uint64_t>();
    CHECK(std::vector<std::uint64_t>(after.begin(), after.end()) == before);
}
