// Closes the paths of a 2-matching that cannot be made longer.
#pragma once

#include "graph/graph.h"

namespace ravel {

// Adds edges by walks between nodes of fewer than `most` edges, 1 in a matching, else 2: a walk may
// be as long as the graph is wide. None makes a singleton. Near-maximum, for no blossoms are
// shrunk.
EdgeSet join_ends(const Graph& graph, EdgeSet set, int most = 2);

// Turns paths into cycles and singletons, with few singletons, but leaves the last path of a
// connected part where closing it would take one. Paths that no walk reaches stay (`cut_paths` ends
// them).
EdgeSet close_paths(const Graph& graph, EdgeSet set);

}  // namespace ravel
