// Rows of a multigraph by counting sort, components by breadth-first search.
// Cost: linear in nodes and edges.
#include "graph/graph.h"

#include <utility>

namespace ravel {

Components find_components(const Graph& graph) {
    Components parts;
    parts.of.assign(graph.node_count(), kNoGraphId);
    std::vector<GraphId> queue;
    for (GraphId seed = 0; seed < graph.node_count(); ++seed) {
        if (parts.of[seed] != kNoGraphId) continue;
        parts.of[seed] = parts.count;
        queue.assign(1, seed);
        for (std::size_t i = 0; i < queue.size(); ++i) {
            for (const Arc& arc : graph.at(queue[i])) {
                if (parts.of[arc.to] != kNoGraphId) continue;
                parts.of[arc.to] = parts.count;
                queue.push_back(arc.to);
            }
        }
        ++parts.count;
    }
    return parts;
}

Graph make_graph(GraphId nodes, std::vector<std::array<GraphId, 2>> ends) {
    Graph graph;
    graph.first.assign(std::size_t{nodes} + 1, 0);
    graph.ends = std::move(ends);
    for (const auto& [a, b] : graph.ends) {
        ++graph.first[a + 1];
        ++graph.first[b + 1];
    }
    for (GraphId n = 0; n < nodes; ++n) graph.first[n + 1] += graph.first[n];
    graph.arcs.resize(2 * graph.ends.size());
    std::vector<GraphId> fill(graph.first.begin(), graph.first.end());
    for (GraphId e = 0; e < graph.edge_count(); ++e) {
        const auto [a, b] = graph.ends[e];
        graph.arcs[fill[a]++] = {b, e};
        graph.arcs[fill[b]++] = {a, e};
    }
    graph.parts = find_components(graph);
    return graph;
}

std::vector<std::uint8_t> degrees_in(const Graph& graph, const EdgeSet& set) {
    std::vector<std::uint8_t> degree(graph.node_count(), 0);
    for (GraphId e = 0; e < graph.edge_count(); ++e) {
        if (set[e] == 0) continue;
        ++degree[graph.ends[e][0]];
        ++degree[graph.ends[e][1]];
    }
    return degree;
}

}  // namespace ravel
