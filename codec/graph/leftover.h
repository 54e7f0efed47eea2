// Joins strips that neither rings nor rotations join.
#pragma once

#include "graph/graph.h"

namespace ravel {

// Asks for a 2-matching with at most one path per connected part, and keeps that. In small regions
// round each strip but the main one of its part the edges are chosen anew, exhaustively. Linear,
// with a large constant while few strips are left.
EdgeSet merge_leftover(const Graph& graph, EdgeSet set);

}  // namespace ravel
