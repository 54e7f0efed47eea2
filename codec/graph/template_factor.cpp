// The template substitution algorithm [DiazGopi2005, 2.2.2]: n - 2 of a node's n copies are matched
// with its dopes, the other two along edges. The paper joins every dope to every copy; here dope i
// is joined to the copies i, i + 1 and i + 2 only. That is enough (with copies a < b left out, the
// dopes before a take the copy i, those from a to b - 2 the copy i + 1, the others i + 2), and it
// keeps large polygons linear. Where k > 2 copies are matched along edges, k - 2 dopes or more are
// free, and k - 2 edges are given up for them: so no edge is lost to the maximum.
// Cost: a matching in a graph of 2 n - 2 nodes for every node of degree n.
#include "graph/template_factor.h"

#include <algorithm>
#include <array>
#include <utility>

#include "graph/close.h"

namespace ravel {
namespace {

GraphId dopes_of(GraphId degree) {
    return degree < 2 ? 0 : degree - 2;
}

// Edges as they come, as long as both ends have less than two, and walks between what is left.
EdgeSet near_maximum(const Graph& graph) {
    EdgeSet set(graph.edge_count(), 0);
    std::vector<std::uint8_t> degree(graph.node_count(), 0);
    for (GraphId e = 0; e < graph.edge_count(); ++e) {
        const auto [a, b] = graph.ends[e];
        if (degree[a] == 2 || degree[b] == 2) continue;
        set[e] = 1;
        ++degree[a];
        ++degree[b];
    }
    return join_ends(graph, std::move(set));
}

// The 2-matching as a matching of the inflated graph.
EdgeSet inflate(const Graph& graph, EdgeSet set) {
    for (GraphId n = 0; n < graph.node_count(); ++n) {
        const auto row = graph.at(n);
        const GraphId dopes = dopes_of(graph.degree(n));
        if (dopes == 0) continue;
        // Copies a < b have no dope: those with an edge of the set first, then any.
        std::array<GraphId, 2> out{};
        std::size_t count = 0;
        for (const bool taken : {true, false})
            for (GraphId i = 0; i < row.size() && count < 2; ++i)
                if ((set[row[i].edge] != 0) == taken) out[count++] = i;
        const auto [a, b] = std::minmax(out[0], out[1]);
        for (GraphId i = 0; i < dopes; ++i)
            for (GraphId k = 0; k < 3; ++k) set.push_back(k == (i < a ? 0U : i + 1 < b ? 1U : 2U));
    }
    return set;
}

}  // namespace

Graph inflate(const Graph& graph) {
    const GraphId nodes = graph.node_count();
    // A node's dopes come before its copies, so that a greedy matching serves them first.
    std::vector<GraphId> copies(nodes);
    GraphId size = 0, inner = 0;
    for (GraphId n = 0; n < nodes; ++n) {
        const GraphId dopes = dopes_of(graph.degree(n));
        copies[n] = size + dopes;
        size += dopes + graph.degree(n);
        inner += 3 * dopes;
    }
    std::vector<std::array<GraphId, 2>> ends(graph.edge_count(), {kNoGraphId, kNoGraphId});
    ends.reserve(std::size_t{graph.edge_count()} + inner);
    for (GraphId n = 0; n < nodes; ++n)
        for (GraphId i = 0; i < graph.degree(n); ++i) {
            auto& [a, b] = ends[graph.at(n)[i].edge];
            (a == kNoGraphId ? a : b) = copies[n] + i;
        }
    for (GraphId n = 0; n < nodes; ++n) {
        const GraphId dopes = dopes_of(graph.degree(n));
        for (GraphId i = 0; i < dopes; ++i)
            for (const GraphId k : {i, i + 1, i + 2})
                ends.push_back({copies[n] - dopes + i, copies[n] + k});
    }
    return make_graph(size, std::move(ends));
}

TemplateFactor template_factor(const Graph& graph, const Matching& inflated) {
    TemplateFactor result;
    result.unmatched = inflated.unmatched;
    result.set.assign(inflated.edges.begin(), inflated.edges.begin() + graph.edge_count());
    std::vector<GraphId> degree(graph.node_count(), 0);
    for (GraphId e = 0; e < graph.edge_count(); ++e)
        if (result.set[e] != 0)
            for (const GraphId n : graph.ends[e]) ++degree[n];
    for (GraphId n = 0; n < graph.node_count(); ++n) {
        for (const Arc& arc : graph.at(n)) {
            if (degree[n] <= 2) break;
            if (result.set[arc.edge] == 0) continue;
            result.set[arc.edge] = 0;
            --degree[n];
            --degree[arc.to];
        }
    }
    result.two_factor = std::all_of(degree.begin(), degree.end(), [](GraphId d) { return d == 2; });
    return result;
}

Matching inflated_matching(const Graph& graph, const Graph& inflated) {
    return max_matching(inflated, inflate(graph, near_maximum(graph)));
}

TemplateFactor template_factor(const Graph& graph) {
    return template_factor(graph, inflated_matching(graph, inflate(graph)));
}

}  // namespace ravel
