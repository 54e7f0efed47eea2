// The maximum 2-matching, by one matching in an inflated graph.
#pragma once

#include "graph/graph.h"
#include "graph/matching.h"

namespace ravel {

// Every node of degree n is replaced by n copies, one per edge, and n - 2 dopes (none where n < 2);
// edges keep their numbers and join copies, the edges between dopes and copies come after them.
Graph inflate(const Graph& graph);

struct TemplateFactor {
    EdgeSet set;              // as many edges as any 2-matching has
    bool two_factor = false;  // every node has two edges; false where there is no 2-factor at all
    GraphId unmatched = 0;    // nodes of the inflated graph, the fewest possible
};

// Near-linear on the graphs of meshes, with several times the nodes.
TemplateFactor template_factor(const Graph& graph);

// A maximum matching of the inflated graph, and the 2-matching of any such one.
Matching inflated_matching(const Graph& graph, const Graph& inflated);
TemplateFactor template_factor(const Graph& graph, const Matching& inflated);

}  // namespace ravel
