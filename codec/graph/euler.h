// A 2-matching from an Euler tour: half of every node's edges.
#pragma once

#include "graph/graph.h"

namespace ravel {

// In a 4-regular graph the result is a 2-factor. Elsewhere nodes of degree four have two edges in
// it, of three one or two, of two one or two, and the rest is for `augment`. Linear.
EdgeSet euler_matching(const Graph& graph);

}  // namespace ravel
