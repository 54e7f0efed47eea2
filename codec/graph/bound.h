// How many links no choice of strips can do without.
#pragma once

#include <cstdint>

#include "graph/graph.h"

namespace ravel {

// Links that join the strips of any 2-matching with at most one path per connected part are at
// least so many. `set` tells where to look: nothing that it says makes the number wrong.
// Near-linear.
std::uint64_t forced_links(const Graph& graph, const EdgeSet& set);

}  // namespace ravel
