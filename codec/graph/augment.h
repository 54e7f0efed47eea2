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

// Turns paths into cycles and singletons, the fewest singletons a walk within the limits allows, but
// leaves the last path of each connected part. (More paths stay where the limits stop a search.)
EdgeSet close_paths(const Graph& graph, EdgeSet set, const RepairLimits& limits = {});

// Lets paths take in singletons at their ends.
EdgeSet extend_paths(const Graph& graph, EdgeSet set, const RepairLimits& limits = {});

}  // namespace ravel
