// The file as sections, found and checked before anything is decoded.
#pragma once

#include <array>
#include <span>

#include "container/head.h"
#include "container/sections.h"
#include "ravel/ravel.h"

namespace ravel {

struct FileSections {
    Head head;
    BlockHead block;
    SectionMask mask = 0;
    std::array<Section, kSections> sections;
    std::uint64_t header_bytes = 0;  // all that is not a data section's bytes

    bool has(SectionId id) const { return has_section(mask, id); }
    const Section& operator[](SectionId id) const { return sections[static_cast<std::size_t>(id)]; }
};

// Reads and checks the container and both heads; data sections are found, not unpacked.
// `budget` is what may still be allocated; it shrinks.
Result<FileSections> open_file(std::span<const std::byte> bytes, std::uint64_t& budget);

// A section's bytes, checked and unpacked. What becomes of them takes at most `growth` times their
// size, themselves included.
Result<Bytes> unpack_section(const Section& section, std::uint64_t& budget,
                             std::uint64_t growth = 1);

}  // namespace ravel
