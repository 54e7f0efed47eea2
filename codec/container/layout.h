// The container's constants, named as in spec/format.md.
//
//     magic, version, which sections there are u8, sections, checksum u32: crc32c of all before it
//     section: (size << 1 | packed) varint, [raw size varint if packed], bytes
//
// Everything is read forward only; the size in front of each section lets a reader pass over it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace ravel {

inline constexpr std::array<std::byte, 4> kMagic{std::byte{'R'}, std::byte{'a'}, std::byte{'v'},
                                                 std::byte{'1'}};
inline constexpr std::uint8_t kVersion = 19;

// In the order in which they are stored. Every file has those up to `positions`.
enum class SectionId : std::uint8_t {
    head,          // what the file holds, positions' arithmetic
    block,         // counts of one block
    connectivity,  // the walk's codes
    positions,
    companions,
    attributes,
    names,  // tag names and notes
    order,  // how to undo the strip's order
    count,
};
inline constexpr std::size_t kSections = static_cast<std::size_t>(SectionId::count);

// A bit for each of the other sections, from `companions` on.
using SectionMask = std::uint8_t;
inline constexpr SectionMask kAllSections = 15;
constexpr SectionMask bit_of(SectionId id) {
    return id < SectionId::companions
               ? SectionMask{0}
               : static_cast<SectionMask>(1u << (static_cast<unsigned>(id) -
                                                 static_cast<unsigned>(SectionId::companions)));
}
constexpr bool has_section(SectionMask mask, SectionId id) {
    return id < SectionId::companions || (mask & bit_of(id)) != 0;
}

// Three edge slots per facet of a tet are counted in 32 bits.
inline constexpr std::uint32_t kMostTets = 357913941;
inline constexpr std::uint32_t kMostArity = 65535;  // of an attribute

const char* name_of(SectionId id);

}  // namespace ravel
