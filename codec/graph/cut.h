// Cuts surplus paths of a 2-matching into cycles and singletons.
#pragma once

#include "graph/graph.h"

namespace ravel {

// Afterwards no connected part has more than one path: the one that would fall into most pieces
// stays. Each other path is cut into the fewest cycles and singletons that its own edges and one
// chord per cycle allow. Linear.
EdgeSet cut_paths(const Graph& graph, EdgeSet set);

}  // namespace ravel
