// Closes the paths of a 2-matching that cannot be made longer.
#pragma once

#include "graph/graph.h"

namespace ravel {

// Turns paths into cycles and singletons, with few singletons, but leaves the last path of a
// connected part where closing it would take one. Paths that no walk reaches stay (`cut_paths` ends
// them).
EdgeSet close_paths(const Graph& graph, EdgeSet set);

}  // namespace ravel
