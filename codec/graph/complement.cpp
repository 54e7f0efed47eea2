// Strips along unmatched edges [DiazGopi2005, 2.2.2]: a node with two edges in the set and degree
// four has two others, so that what is outside a 2-factor of a 4-regular graph is one, too. Nodes
// with fewer edges in the set have three or four others; the paper leaves the choice to "a suitable
// traversal". Here the graph of these edges takes the edges of its nodes of low degree first, and
// alternating walks mend the rest.
// Cost: that of `augment`.
#include "graph/complement.h"

#include <utility>

#include "graph/augment.h"

namespace ravel {

EdgeSet complement_matching(const Graph& graph, const EdgeSet& set) {
    std::vector<std::array<GraphId, 2>> ends;
    std::vector<GraphId> original;
    for (GraphId e = 0; e < graph.edge_count(); ++e) {
        if (set[e] != 0) continue;
        ends.push_back(graph.ends[e]);
        original.push_back(e);
    }
    const Graph rest = make_graph(graph.node_count(), std::move(ends));
    EdgeSet chosen(rest.edge_count(), 0);
    std::vector<std::uint8_t> degree(rest.node_count(), 0);
    // Edges between nodes of degree two or less are all taken; then the others as they come.
    for (const bool forced : {true, false}) {
        for (GraphId e = 0; e < rest.edge_count(); ++e) {
            const auto [a, b] = rest.ends[e];
            if (forced && (rest.degree(a) > 2 || rest.degree(b) > 2)) continue;
            if (chosen[e] != 0 || degree[a] == 2 || degree[b] == 2) continue;
            chosen[e] = 1;
            ++degree[a];
            ++degree[b];
        }
    }
    chosen = augment(rest, std::move(chosen));
    EdgeSet result(graph.edge_count(), 0);
    for (GraphId e = 0; e < rest.edge_count(); ++e) result[original[e]] = chosen[e];
    return result;
}

}  // namespace ravel
