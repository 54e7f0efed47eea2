// Joins strips that no short ring merges, by rotations of an opened strip.
#pragma once

#include <cstdint>

#include "graph/graph.h"

namespace ravel {

struct RotationMerge {
    EdgeSet set;
    std::uint64_t merges = 0;
};

struct RotationLimits {
    int depth = 11;                    // rotations in a row
    std::uint64_t steps_per_node = 8;  // bounds the search in all
};

// Asks for a 2-matching with at most one path per connected part, and keeps that. Parts that have
// one strip stay as they are; in others the largest strip takes in the others where it can. What is
// still left of a part that has no path may leave it with one: that saves a link, often more.
// Linear.
RotationMerge merge_by_rotations(const Graph& graph, EdgeSet set,
                                 const RotationLimits& limits = {});

}  // namespace ravel
