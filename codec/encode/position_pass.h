// One pass over all that the section `positions` tells: vertices in the order of the walk, then
// unused points. A Coder writes it, or only counts.
#pragma once

#include "encode/positions.h"

namespace ravel {

// The first `size`. `coded(i)`: is the i-th to be coded, or only to be known to those that are?
template <class Coder, class Coded>
void code_positions(Coder& coder, const CodedPositions& all, const PositionFormat& format,
                    const std::vector<std::uint8_t>& leads, std::size_t size, const Coded& coded) {
    PositionCodes<Coder> codes(coder, format, all.size(), &leads);
    codes.reserve(size);
    for (std::size_t i = 0; i < size; ++i) {
        const bool used = i < all.vertices();
        if (used && all.record.copy_of[i] != kNone) {
            codes.copy(all.record.copy_of[i]);
            continue;
        }
        const Stencil stencil =
            used ? all.record.stencils[i]
                 : stencil_of_unused(all.edges, i - all.vertices(), all.vertices());
        if (coded(i))
            codes.next(stencil, all.values[i]);
        else
            codes.skip(stencil, all.values[i]);
    }
}

}  // namespace ravel
