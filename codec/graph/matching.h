// Maximum cardinality matching, with its proof.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/graph.h"

namespace ravel {

struct Matching {
    EdgeSet edges;                      // at most one at each node
    GraphId unmatched = 0;              // nodes without one
    std::vector<std::uint8_t> barrier;  // node -> 1 in the set that proves the matching maximum
};

// Asks for fewer than 2^31 nodes. Near-linear on the graphs of meshes.
Matching max_matching(const Graph& graph);

// The same from a matching, quick where that is near-maximum.
Matching max_matching(const Graph& graph, const EdgeSet& start);

// Does the barrier prove that no matching leaves fewer nodes unmatched? Each odd component that is
// left when the barrier's nodes are taken away has to match one of its nodes into the barrier, or
// leaves one unmatched [Berge1958]. Linear.
bool proves_maximum(const Graph& graph, const Matching& matching);

}  // namespace ravel
