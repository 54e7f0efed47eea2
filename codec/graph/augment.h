// Repairs the ends of a 2-matching's paths by alternating walks.
#pragma once

#include "graph/graph.h"

namespace ravel {

struct RepairLimits {
    GraphId visits = 4096;  // states one search may visit
};

// Raises the number of edges of a 2-matching until no alternating walk within the limits does.
// The walks found are shortest ones, so little of the matching changes.
EdgeSet augment(const Graph& graph, EdgeSet set, const RepairLimits& limits = {});

// Lets paths take in singletons at their ends.
EdgeSet extend_paths(const Graph& graph, EdgeSet set, const RepairLimits& limits = {});

}  // namespace ravel
