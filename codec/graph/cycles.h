// A 2-matching taken apart into its cycles, paths and singletons ("strips").
#pragma once

#include <cstdint>
#include <vector>

#include "graph/graph.h"

namespace ravel {

enum class StripShape : std::uint8_t { singleton, path, cycle };

// Strip s visits node[i] for i in [first[s], first[s + 1]), and goes from node[i] to the next
// through edge[i]; the last node of a cycle goes back to the first, that of a path has kNoGraphId.
struct StripList {
    std::vector<GraphId> first;
    std::vector<StripShape> shape;
    std::vector<GraphId> node;
    std::vector<GraphId> edge;
    std::vector<GraphId> of;  // node -> strip

    GraphId count() const { return static_cast<GraphId>(shape.size()); }
    GraphId size(GraphId strip) const { return first[strip + 1] - first[strip]; }
};

// Paths first (each from its lower end), then cycles and singletons (from their lowest node), each
// group ascending by first node. Linear. Asks that no node has more than two edges in the set.
StripList list_strips(const Graph& graph, const EdgeSet& set);

}  // namespace ravel
