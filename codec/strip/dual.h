// The dual graph of a complex: a node per cell, an edge per glued pair of facets.
#pragma once

#include <vector>

#include "graph/graph.h"
#include "mesh/complex.h"

namespace ravel {

struct Dual {
    Graph graph;
    std::vector<Id> edge_of;   // facet -> edge, or kNone at a border
    std::vector<Id> facet_of;  // edge -> the lower of its two facets
};

// Edges are numbered by their lower facets. Linear.
Dual make_dual(const Complex& complex);

}  // namespace ravel
