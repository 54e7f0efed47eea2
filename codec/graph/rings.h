// Merges the strips of a 2-matching by toggling short alternating rings.
#pragma once

#include <cstdint>

#include "graph/joiner.h"

namespace ravel {

struct RingLimits {
    int edges_in = 6;  // edges of the set on a ring, 2 .. kMaxRingEdges; less than 2 merges nothing
    int passes = 3;
    std::uint64_t steps_per_node = 64;  // bounds the search in all
};
inline constexpr int kMaxRingEdges = 6;

// A ring of edges by turns in and out of the set is toggled where all strips it meets become one;
// it may meet a strip several times. Degrees stay as they are. Gives the number of strips saved.
// Linear, with a large constant where many small strips can't be merged.
std::uint64_t merge_rings(StripJoiner& joiner, const RingLimits& limits = {});

}  // namespace ravel
