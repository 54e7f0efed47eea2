#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "base/bytes.h"

using namespace ravel;

namespace {

Bytes bytes_of(std::initializer_list<int> values) {
    Bytes bytes;
    for (const int v : values) bytes.push_back(static_cast<std::byte>(v));
    return bytes;
}

constexpr std::uint64_t kAll = ~std::uint64_t{0};

std::vector<std::uint64_t> edge_numbers() {
    std::vector<std::uint64_t> numbers{0, kAll};
    for (int bit = 0; bit < 64; ++bit)
        for (const std::uint64_t d : {kAll, std::uint64_t{0}, std::uint64_t{1}})
            numbers.push_back((std::uint64_t{1} << bit) + d);
    return numbers;
}

}  // namespace

TEST_CASE("nothing written is nothing read") {
    ByteReader in({});
    CHECK(in.ok());
    CHECK(in.left() == 0);
    CHECK(in.u64() == 0);
    CHECK_FALSE(in.ok());
}

TEST_CASE("zigzag is one to one and small for small numbers") {
    CHECK(zigzag(0) == 0);
    CHECK(zigzag(-1) == 1);
    CHECK(zigzag(1) == 2);
    CHECK(zigzag(std::numeric_limits<std::int64_t>::min()) == kAll);
    for (const std::uint64_t u : edge_numbers()) {
        CHECK(zigzag(unzigzag(u)) == u);
        const auto s = static_cast<std::int64_t>(u);
        CHECK(unzigzag(zigzag(s)) == s);
    }
}

TEST_CASE("varints come back, in the fewest bytes") {
    for (const std::uint64_t u : edge_numbers()) {
        ByteWriter out;
        out.varint(u);
        std::size_t fewest = 1;
        while (fewest < 10 && u >> (7 * fewest) != 0) ++fewest;
        CHECK(out.size() == fewest);
        ByteReader in(out.bytes());
        CHECK(in.varint() == u);
        CHECK(in.ok());
        CHECK(in.left() == 0);
    }
}

TEST_CASE("a varint in more bytes than it needs is refused") {
    for (const Bytes& bytes : {bytes_of({0x80, 0x00}), bytes_of({0xFF, 0x80, 0x00})}) {
        ByteReader in(bytes);
        in.varint();
        CHECK_FALSE(in.ok());
    }
}

TEST_CASE("a varint of more than 64 bits is refused") {
    Bytes bytes(9, std::byte{0xFF});
    bytes.push_back(std::byte{2});
    ByteReader wide(bytes);
    wide.varint();
    CHECK_FALSE(wide.ok());
    const Bytes ones(20, std::byte{0xFF});
    ByteReader endless(ones);
    endless.varint();
    CHECK_FALSE(endless.ok());
}

TEST_CASE("fixed-size fields are little-endian and come back") {
    ByteWriter out;
    out.u8(0xAB);
    out.u32(0x01020304);
    out.u64(0x1122334455667788);
    out.f64(-0.0);
    out.text("strip");
    CHECK(out.bytes()[1] == std::byte{4});
    CHECK(out.bytes()[5] == std::byte{0x88});
    ByteReader in(out.bytes());
    CHECK(in.u8() == 0xAB);
    CHECK(in.u32() == 0x01020304);
    CHECK(in.u64() == 0x1122334455667788);
    CHECK(std::signbit(in.f64()));
    CHECK(in.text() == "strip");
    CHECK(in.ok());
    CHECK(in.left() == 0);
}

TEST_CASE("past the end there are zeros, and the reader says so for good") {
    const Bytes bytes = bytes_of({1, 2, 3});
    ByteReader in(bytes, 100);
    CHECK(in.u8() == 1);
    CHECK(in.at() == 101);
    in.u32();
    CHECK_FALSE(in.ok());
    CHECK(in.u8() == 0);
    CHECK(in.varint() == 0);
    CHECK(in.raw(0).empty());
    CHECK_FALSE(in.ok());
}

TEST_CASE("a text longer than the bytes left is empty and refused") {
    for (const std::uint64_t size : {std::uint64_t{4}, std::uint64_t{1} << 40, kAll}) {
        ByteWriter out;
        out.varint(size);
        out.raw(bytes_of({'a', 'b', 'c'}));
        ByteReader in(out.bytes());
        CHECK(in.text().empty());
        CHECK_FALSE(in.ok());
    }
}
