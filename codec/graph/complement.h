// The other reading of a 2-matching: strips along the edges that are not in it.
#pragma once

#include "graph/graph.h"

namespace ravel {

// A 2-matching among the edges outside the set, near-maximum. Near-linear.
EdgeSet complement_matching(const Graph& graph, const EdgeSet& set);

}  // namespace ravel
