// Follows the edges of the set from every path end, then round what is left.
// A node is left by an edge of the set other than the one it was entered by, so that two parallel
// edges make a cycle of two nodes.
// Cost: linear in nodes and edges.
#include "graph/cycles.h"

namespace ravel {
namespace {

Arc leave(const Graph& graph, const EdgeSet& set, GraphId node, GraphId entry) {
    for (const Arc& arc : graph.at(node))
        if (set[arc.edge] != 0 && arc.edge != entry) return arc;
    return {kNoGraphId, kNoGraphId};
}

void follow(const Graph& graph, const EdgeSet& set, GraphId start, StripList& list) {
    const GraphId strip = list.count();
    GraphId node = start, entry = kNoGraphId;
    StripShape shape = StripShape::path;
    for (;;) {
        list.of[node] = strip;
        list.node.push_back(node);
        const Arc arc = leave(graph, set, node, entry);
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
    const std::vector<std::uint8_t> degree = degrees_in(graph, set);
    for (GraphId n = 0; n < nodes; ++n)
        if (degree[n] == 1 && list.of[n] == kNoGraphId) follow(graph, set, n, list);
    for (GraphId n = 0; n < nodes; ++n)
        if (list.of[n] == kNoGraphId) follow(graph, set, n, list);
    return list;
}

}  // namespace ravel
