// Edmonds's blossoms [Edmonds1965], by LEMON's MaxMatching. From a matching that alternating walks
// from all unmatched nodes at once have raised, it grows one tree of alternating walks per node
// that is still unmatched, first edges first. A tree that finds no unmatched node stays; its nodes
// at odd distance are in the barrier of Gallai and Edmonds. Cost: O(m n alpha) at worst,
// near-linear on the graphs of meshes; about 70 bytes per node.
#include "graph/matching.h"

#include <utility>

#include <lemon/matching.h>

#include "graph/close.h"
#include "graph/lemon_graph.h"
#include "graph/union_find.h"

namespace ravel {

namespace {

// Nodes in order take their first free neighbour, and walks between those left raise that.
EdgeSet near_maximum(const Graph& graph) {
    EdgeSet set(graph.edge_count(), 0);
    std::vector<std::uint8_t> matched(graph.node_count(), 0);
    for (GraphId n = 0; n < graph.node_count(); ++n) {
        for (const Arc& arc : graph.at(n)) {
            if (matched[n] != 0) break;
            if (matched[arc.to] != 0) continue;
            matched[n] = matched[arc.to] = 1;
            set[arc.edge] = 1;
        }
    }
    return join_ends(graph, std::move(set), 1);
}

// An edge set as LEMON reads it.
struct InSet {
    using Key = LemonGraph::Edge;
    using Value = bool;
    const LemonGraph& graph;
    const EdgeSet& set;
    bool operator[](const Key& edge) const { return set[graph.edge_at(edge.place)] != 0; }
};

}  // namespace

Matching max_matching(const Graph& graph) {
    return max_matching(graph, near_maximum(graph));
}

Matching max_matching(const Graph& graph, const EdgeSet& start) {
    const LemonGraph view(graph);
    lemon::MaxMatching<LemonGraph> solver(view);
    solver.matchingInit(InSet{view, start});
    solver.startSparse();
    Matching result;
    result.edges.assign(graph.edge_count(), 0);
    result.barrier.assign(graph.node_count(), 0);
    for (GraphId n = 0; n < graph.node_count(); ++n) {
        const LemonGraph::Node node(n);
        const LemonGraph::Arc arc = solver.matching(node);
        if (arc.place == kNoGraphId)
            ++result.unmatched;
        else
            result.edges[graph.arcs[arc.place].edge] = 1;
        result.barrier[n] = solver.barrier(node);
    }
    return result;
}

bool proves_maximum(const Graph& graph, const Matching& matching) {
    std::uint64_t unmatched = 0, barrier = 0, odd = 0;
    for (const std::uint8_t degree : degrees_in(graph, matching.edges)) {
        if (degree > 1) return false;
        unmatched += degree == 0;
    }
    UnionFind parts(graph.node_count());
    for (const auto& [a, b] : graph.ends)
        if (matching.barrier[a] == 0 && matching.barrier[b] == 0) parts.unite(a, b);
    for (GraphId n = 0; n < graph.node_count(); ++n) {
        if (matching.barrier[n] != 0)
            ++barrier;
        else
            odd += parts.find(n) == n && parts.size(n) % 2 == 1;
    }
    return unmatched == matching.unmatched && unmatched + barrier == odd;
}

}  // namespace ravel
