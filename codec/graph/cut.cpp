// Dynamic programme along each path x1 .. xk: a piece xi .. xj is a cycle where an edge outside the
// set joins xi and xj (a chord, or a parallel edge), and a singleton where i = j; fewest(j) = 1 +
// min fewest(i - 1).
// Cost: linear, for a node has few edges and each is looked at twice.
#include "graph/cut.h"

#include "graph/cycles.h"

namespace ravel {
namespace {

// The last piece of the best cut of x1 .. xj: it starts at `begin` and is closed by `chord`.
struct Piece {
    GraphId pieces = 0;
    GraphId begin = 0;
    GraphId chord = kNoGraphId;
};

}  // namespace

EdgeSet cut_paths(const Graph& graph, EdgeSet set) {
    const StripList strips = list_strips(graph, set);
    const Components& parts = graph.parts;
    std::vector<Piece> best(graph.node_count());
    std::vector<GraphId> place(graph.node_count(), 0);
    for (GraphId i = 0; i < strips.node.size(); ++i) place[strips.node[i]] = i;

    std::vector<GraphId> keep(parts.count, kNoGraphId);
    for (GraphId s = 0; s < strips.count(); ++s) {
        if (strips.shape[s] != StripShape::path) continue;
        const GraphId begin = strips.first[s], end = strips.first[s + 1];
        const auto before = [&](GraphId i) { return i == begin ? 0 : best[i - 1].pieces; };
        for (GraphId j = begin; j < end; ++j) {
            best[j] = {before(j) + 1, j, kNoGraphId};
            for (const Arc& arc : graph.at(strips.node[j])) {
                const GraphId i = place[arc.to];
                if (set[arc.edge] != 0 || i < begin || i >= j) continue;
                if (before(i) + 1 < best[j].pieces) best[j] = {before(i) + 1, i, arc.edge};
            }
        }
        GraphId& kept = keep[parts.of[strips.node[begin]]];
        if (kept == kNoGraphId || best[end - 1].pieces > best[strips.first[kept + 1] - 1].pieces)
            kept = s;
    }
    for (GraphId s = 0; s < strips.count(); ++s) {
        const GraphId begin = strips.first[s];
        if (strips.shape[s] != StripShape::path || keep[parts.of[strips.node[begin]]] == s)
            continue;
        for (GraphId j = strips.first[s + 1]; j > begin;) {
            const Piece& piece = best[j - 1];
            if (piece.chord != kNoGraphId) set[piece.chord] = 1;
            if (piece.begin > begin) set[strips.edge[piece.begin - 1]] = 0;
            j = piece.begin;
        }
    }
    return set;
}

}  // namespace ravel
