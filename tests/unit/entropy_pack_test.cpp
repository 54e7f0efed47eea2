#include <catch2/catch.hpp>

#include <random>

#include "entropy/pack.h"

using namespace ravel;

namespace {

Bytes noise(std::size_t size) {
    std::mt19937 random(7);
    Bytes bytes(size);
    for (std::byte& b : bytes) b = static_cast<std::byte>(random());
    return bytes;
}

}  // namespace

TEST_CASE("what is packed comes back at every level") {
    for (const Bytes& raw :
         {Bytes{}, Bytes(1, std::byte{7}), Bytes(100000, std::byte{0}), noise(50000)})
        for (const int level : {1, 3, 19, 22}) {
            const Bytes packed = pack(raw, level);
            REQUIRE_FALSE(packed.empty());
            CHECK(raw.size() <= most_unpacked(packed.size()));
            const Result<Bytes> again = unpack(packed, raw.size(), 0);
            REQUIRE(again.ok());
            CHECK(*again == raw);
        }
}

TEST_CASE("a packed section of another size than announced is refused") {
    const Bytes packed = pack(Bytes(1000, std::byte{1}), 3);
    for (const std::uint64_t size : {0u, 1u, 999u, 1001u, 100000u})
        CHECK_FALSE(unpack(packed, size, 0).ok());
}

TEST_CASE("cut and damaged packs give an error or bytes, and never more than announced") {
    const Bytes raw = noise(2000);
    const Bytes packed = pack(raw, 3);
    for (std::size_t size = 0; size < packed.size(); size += 13) {
        const auto cut = unpack(std::span(packed).first(size), raw.size(), 77);
        REQUIRE_FALSE(cut.ok());
        CHECK(cut.error().code == Code::corrupt);
        CHECK(cut.error().at == 77);
    }
    for (std::size_t bit = 0; bit < 400; ++bit) {
        Bytes bad = packed;
        bad[bit / 8] ^= static_cast<std::byte>(1u << bit % 8);
        const auto again = unpack(bad, raw.size(), 0);
        if (again) CHECK(again->size() == raw.size());
    }
}

TEST_CASE("no pack is said to hold less than it does") {
    for (std::size_t size = 1; size < std::size_t{64} << 20; size *= 8)
        CHECK(most_unpacked(pack(Bytes(size, std::byte{0}), 19).size()) >= size);
    CHECK(most_unpacked(~std::uint64_t{0}) == ~std::uint64_t{0});
}

TEST_CASE("a packed section is one zstd frame, not two and no skippable one before it") {
    const Bytes one = pack(Bytes(500, std::byte{3}), 3);
    Bytes two = one;
    two.insert(two.end(), one.begin(), one.end());
    CHECK_FALSE(unpack(two, 1000, 0).ok());
    Bytes skipped{std::byte{0x50}, std::byte{0x2A}, std::byte{0x4D}, std::byte{0x18},
                  std::byte{0},    std::byte{0},    std::byte{0},    std::byte{0}};
    skipped.insert(skipped.end(), one.begin(), one.end());
    CHECK_FALSE(unpack(skipped, 500, 0).ok());
}
