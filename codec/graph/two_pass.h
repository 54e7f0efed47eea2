// A 2-matching from two matchings, one after the other.
#pragma once

#include "graph/graph.h"

namespace ravel {

struct TwoPass {
    EdgeSet set;
    GraphId unmatched_first = 0;   // nodes without an edge of the first matching; fewest possible
    GraphId unmatched_second = 0;  // of the second; fewest possible after the first
    // Every node has two edges. False says nothing about other methods: a component with an odd
    // number of nodes has no perfect matching, but may have a 2-factor.
    bool two_factor() const { return unmatched_first == 0 && unmatched_second == 0; }
};

// Near-linear on the graphs of meshes.
TwoPass two_pass(const Graph& graph);

}  // namespace ravel
