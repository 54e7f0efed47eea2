// Petersen's theorem made linear [Petersen1891]: colour the edges of an Euler tour [Hierholzer1873]
// A B A B; a node the tour passes d/2 times gets d/2 edges of each colour. Nodes of degree above
// four first keep four edges, evenly spread over their rows. Odd nodes are joined to one dummy
// node, where the tours of their parts start, so that only the dummy meets a tour's odd seam. Parts
// without odd nodes start at a node of degree two if there is one: with an odd number of edges its
// two get the same colour, which does no harm; without one the number of edges is even.
// Cost: linear in nodes and edges.
#include "graph/euler.h"

namespace ravel {
namespace {

// Both ends must want an edge to keep it.
std::vector<std::uint8_t> thin(const Graph& graph) {
    std::vector<std::uint8_t> wanted(graph.edge_count(), 0);
    for (GraphId n = 0; n < graph.node_count(); ++n) {
        const auto row = graph.at(n);
        if (row.size() <= 4) {
            for (const Arc& arc : row) ++wanted[arc.edge];
        } else {
            for (std::size_t i = 0; i < 4; ++i) ++wanted[row[i * row.size() / 4].edge];
        }
    }
    for (std::uint8_t& w : wanted) w = w == 2;
    return wanted;
}

struct Tours {
    const Graph& graph;
    std::vector<GraphId> next;       // node -> first arc not yet looked at
    std::vector<std::uint8_t> used;  // edge
    std::vector<Arc> stack;          // node and the edge it was reached by

    // Calls visit(edge) along the tour that starts and ends at `start`, last edge first.
    template <class Visit>
    void run(GraphId start, Visit visit) {
        stack.assign(1, {start, kNoGraphId});
        while (!stack.empty()) {
            const Arc top = stack.back();
            GraphId& i = next[top.to];
            while (i < graph.first[top.to + 1] && used[graph.arcs[i].edge] != 0) ++i;
            if (i < graph.first[top.to + 1]) {
                used[graph.arcs[i].edge] = 1;
                stack.push_back(graph.arcs[i]);
            } else {
                stack.pop_back();
                if (top.edge != kNoGraphId) visit(top.edge);
            }
        }
    }
};

}  // namespace

EdgeSet euler_matching(const Graph& graph) {
    const GraphId nodes = graph.node_count();
    const std::vector<std::uint8_t> kept = thin(graph);
    std::vector<std::array<GraphId, 2>> ends;
    std::vector<GraphId> original;
    for (GraphId e = 0; e < graph.edge_count(); ++e) {
        if (kept[e] == 0) continue;
        ends.push_back(graph.ends[e]);
        original.push_back(e);
    }
    std::vector<std::uint8_t> degree = degrees_in(graph, kept);
    for (GraphId n = 0; n < nodes; ++n)
        if (degree[n] % 2 == 1) ends.push_back({n, nodes});
    const Graph even = make_graph(nodes + 1, std::move(ends));

    EdgeSet set(graph.edge_count(), 0);
    Tours tours{even,
                {even.first.begin(), even.first.end() - 1},
                std::vector<std::uint8_t>(even.edge_count(), 0),
                {}};
    const auto tour_from = [&](GraphId start) {
        bool in = true;
        tours.run(start, [&](GraphId e) {
            if (in && e < original.size()) set[original[e]] = 1;
            in = !in;
        });
    };
    tour_from(nodes);
    for (GraphId n = 0; n < nodes; ++n)
        if (degree[n] == 2) tour_from(n);
    for (GraphId n = 0; n < nodes; ++n)
        if (degree[n] == 4) tour_from(n);
    return set;
}

}  // namespace ravel
