// The container's constants, named as in spec/format.md.
//
//     magic, version, sections, byte 0, checksum u32: crc32c of all before it
//     section: id u8, (size << 1 | packed) varint, [raw size varint if packed], bytes
//
// Everything is read forward only; the size in front of each section lets a reader pass over it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace ravel {

inline constexpr std::array<std::byte, 4> kMagic{std::byte{'R'}, std::byte{'a'}, std::byte{'v'},
                                                 std::byte{'1'}};
inline constexpr std::uint8_t kVersion = 14;

enum class SectionId : std::uint8_t {
    end = 0,
    head = 1,          // what the file holds, positions' arithmetic
    block = 2,         // counts of one block
    connectivity = 3,  // the walk's codes
    positions = 4,
    companions = 5,
    attributes = 6,
    names = 7,  // tag names and notes
    order = 8,  // how to undo the strip's order
};
inline constexpr std::uint8_t kLastSection = 8;

// Three edge slots per facet of a tet are counted in 32 bits.
inline constexpr std::uint32_t kMostTets = 357913941;
inline constexpr std::uint32_t kMostArity = 65535;  // of an attribute

const char* name_of(SectionId id);

}  // namespace ravel
