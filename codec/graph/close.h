// Closes the paths of a 2-matching that cannot be made longer.
#pragma once

#include "graph/graph.h"

namespace ravel {

// Adds edges by walks between path ends and singletons that `augment` did not find: they may be as
// long as the graph is wide. No walk makes a singleton.
EdgeSet join_ends(const Graph& graph, EdgeSet set);

// Turns paths into cycles and singletons, with few singletons, but leaves the last path of a
// connected part where closing it would take one. Paths that no walk reaches stay (`cut_paths` ends
// them).
EdgeSet close_paths(const Graph& graph, EdgeSet set);

}  // namespace ravel
