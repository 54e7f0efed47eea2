// Decoding with the walk laid open, for tools that want the strip itself.
#pragma once

#include "ravel/ravel.h"
#include "walk/walk.h"

namespace ravel {

struct DecodedWalk {
    Mesh mesh;                          // as `decode` returns it
    Walked walked;                      // cells in the order of the walk, with twins and gates
    std::vector<Id> point;              // vertex of the walk -> point in the order of the walk
    std::vector<std::uint8_t> flipped;  // cell of the walk; empty where none is
    // Per cell of the walk, empty unless the order is kept: the cell of `mesh`, and how it is
    // turned (see Reorder).
    std::vector<Index> cell;
    std::vector<std::uint32_t> turn;
    bool wants_mending = false;
    Index links = 0;  // as announced
};

Result<DecodedWalk> decode_walk(std::span<const std::byte> bytes, const DecodeOptions& options);

// One per cell, in the order of the walk. Fails where the links are not as many as announced.
Result<std::vector<StripStep>> steps_of(const DecodedWalk& walk);

}  // namespace ravel
