// Decoding with the walk laid open, for tools that want the strip itself.
#pragma once

#include "ravel/ravel.h"
#include "walk/walk.h"

namespace ravel {

struct DecodedWalk {
    Mesh mesh;                          // as `decode` returns it
    Walked walked;                      // cells in strip order, with twins, gates and links
    std::vector<Id> point;              // vertex of the walk -> point in strip order
    std::vector<std::uint8_t> flipped;  // cell of the walk; empty where none is
    std::vector<Index> cell;            // cell of the walk -> cell of `mesh`
    std::vector<std::uint32_t>
        turn;  // cell of the walk -> see Reorder; empty unless the order is kept
};

Result<DecodedWalk> decode_walk(std::span<const std::byte> bytes, const DecodeOptions& options);

}  // namespace ravel
