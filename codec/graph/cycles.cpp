// Follows the edges of the set from every path end, then round what is left.
// A node is left by an edge of the set other than the one it was entered by, so that two parallel
// edges make a cycle of two nodes. Each node's two edges are laid side by side first: the following
// then waits for memory once per node.
// Cost: linear in nodes and edges.
#include "graph/cycles.h"

#include <utility>

namespace ravel {
namespace {

constexpr Arc kNoArc{kNoGraphId, kNoGraphId};

// Node -> its arcs in the set.
using Mates = std::vector<std::array<Arc, 2>>;

Mates mates_in(const Graph& graph, const EdgeSet& set) {
    Mates mates(graph.node_count(), {kNoArc, kNoArc});
    for (GraphId e = 0; e < graph.edge_count(); ++e) {
        if (set[e] == 0) continue;
        const auto [a, b] = graph.ends[e];
        mates[a][mates[a][0].edge != kNoGraphId] = {b, e};
        mates[b][mates[b][0].edge != kNoGraphId] = {a, e};
    }
    return mates;
}

void follow(const Mates& mates, GraphId start, StripList& list) {
    const GraphId strip = list.count();
    GraphId node = start, entry = kNoGraphId;
    StripShape shape = StripShape::path;
    for (;;) {
        list.of[node] = strip;
        list.node.push_back(node);
        const auto& [first, second] = mates[node];
        const Arc arc = first.edge != entry ? first : second;
        list.edge.push_back(arc.edge);
        if (arc.edge == kNoGraphId) break;
        if (arc.to == start) {
            shape = StripShape::cycle;
            break;
        }
        node = arc.to;
        entry = arc.edge;
    }
    if (list.node.size() - list.first.back() == 1) shape = StripShape::singleton;
    list.shape.push_back(shape);
    list.first.push_back(static_cast<GraphId>(list.node.size()));
}

}  // namespace

StripList list_strips(const Graph& graph, const EdgeSet& set) {
    StripList list;
    const GraphId nodes = graph.node_count();
    list.first.push_back(0);
    list.of.assign(nodes, kNoGraphId);
    list.node.reserve(nodes);
    list.edge.reserve(nodes);
    const Mates mates = mates_in(graph, set);
    for (GraphId n = 0; n < nodes; ++n) {
        const bool end = mates[n][0].edge != kNoGraphId && mates[n][1].edge == kNoGraphId;
        if (end && list.of[n] == kNoGraphId) follow(mates, n, list);
    }
    for (GraphId n = 0; n < nodes; ++n)
        if (list.of[n] == kNoGraphId) follow(mates, n, list);
    return list;
}

}  // namespace ravel
