// The dual graph of a complex: a node per cell, an edge per glued pair of facets.
#pragma once

#include <span>
#include <vector>

#include "graph/graph.h"
#include "mesh/complex.h"

namespace ravel {

// Nodes are the cells in another order, so that neighbours in the mesh are neighbours in memory:
// files often list cells at random, and everything after the first walk is several times faster
// this way.
struct Dual {
    Graph graph;
    std::vector<Id> cell_of;   // node -> cell
    std::vector<Id> node_of;   // cell -> node
    std::vector<Id> edge_of;   // facet -> edge, or kNone at a border
    std::vector<Id> facet_of;  // edge -> one of its two facets, that of the lower node
};

// `order` holds every cell once. Edges are numbered by their lower nodes. Linear.
Dual make_dual(const Complex& complex, std::span<const Id> order);

// With nodes numbered like cells.
Dual make_dual(const Complex& complex);

}  // namespace ravel
