#include <catch2/catch.hpp>

#include <string_view>

#include "base/bytes.h"
#include "base/checksum.h"

using namespace ravel;

namespace {

std::uint32_t sum_of(std::string_view text) {
    return crc32c(std::as_bytes(std::span(text.data(), text.size())));
}

// The definition, a bit at a time: reflected polynomial 0x82F63B78.
std::uint32_t slow(std::span<const std::byte> bytes) {
    std::uint32_t crc = ~0u;
    for (const std::byte b : bytes) {
        crc ^= static_cast<std::uint32_t>(b);
        for (int i = 0; i < 8; ++i) crc = crc >> 1 ^ (crc & 1 ? 0x82F63B78u : 0);
    }
    return ~crc;
}

}  // namespace

TEST_CASE("the checksum of nothing is zero") {
    CHECK(crc32c({}) == 0);
}

TEST_CASE("the checksum is the CRC-32C of its standard") {
    CHECK(sum_of("123456789") == 0xE3069283u);
    // RFC 3720, B.4
    CHECK(crc32c(Bytes(32, std::byte{0})) == 0x8A9136AAu);
    CHECK(crc32c(Bytes(32, std::byte{0xFF})) == 0x62A8AB43u);
}

TEST_CASE("the checksum agrees with its definition at every length and alignment") {
    Bytes bytes;
    for (unsigned i = 0; i < 100; ++i) bytes.push_back(static_cast<std::byte>(i * 37 + i / 7));
    for (std::size_t from = 0; from < 9; ++from)
        for (std::size_t size = 0; size + from <= bytes.size(); ++size) {
            const auto part = std::span<const std::byte>(bytes).subspan(from, size);
            REQUIRE(crc32c(part) == slow(part));
        }
}

TEST_CASE("every flipped bit changes the checksum") {
    Bytes bytes(40, std::byte{0x5A});
    const std::uint32_t before = crc32c(bytes);
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        bytes[bit / 8] ^= static_cast<std::byte>(1u << bit % 8);
        CHECK(crc32c(bytes) != before);
        bytes[bit / 8] ^= static_cast<std::byte>(1u << bit % 8);
    }
}
