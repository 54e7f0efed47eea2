// Petersen's theorem made linear [Petersen1891]: colour the edges of an Euler tour [Hierholzer1873]
// A B A B; a node the tour passes d/2 times gets d/2 edges of each colour. Nodes of degree above
// four first keep four edges, evenly spread over their rows. Odd nodes are joined in pairs by dummy
// edges, neighbours where that goes: if the dummy takes the colour that counts, both lack an edge,
// and a short walk mends that. A part with an odd number of edges has a seam where its tour starts;
// that is at a node where it does no harm, if there is one: an odd one, or one of degree two. Rows
// are read from either end, as a hash of the node says: else regular meshes fall into parallel
// staircases, which no short ring merges.
// Cost: linear in nodes and edges.
#include "graph/euler.h"

#include "graph/bits.h"

namespace ravel {
namespace {

// Both ends must want an edge to keep it.
std::vector<std::uint8_t> thin(const Graph& graph) {
    std::vector<std::uint8_t> wanted(graph.edge_count(), 2);
    for (GraphId n = 0; n < graph.node_count(); ++n) {
        const auto row = graph.at(n);
        if (row.size() <= 4) continue;
        for (const Arc& arc : row) --wanted[arc.edge];
        for (std::size_t i = 0; i < 4; ++i) ++wanted[row[i * row.size() / 4].edge];
    }
    for (std::uint8_t& w : wanted) w = w == 2;
    return wanted;
}

class Tours {
  public:
    Tours(const Graph& graph, EdgeSet& set)
        : graph_(graph),
          set_(set),
          degree_(graph.node_count(), 0),
          nodes_(graph.node_count()),
          used_(graph.edge_count()) {
        const std::vector<std::uint8_t> kept = thin(graph);
        for (GraphId e = 0; e < graph.edge_count(); ++e)
            if (kept[e] == 0) used_.set(e);
        for (GraphId n = 0; n < graph.node_count(); ++n) {
            nodes_[n] = {graph.first[n], graph.first[n + 1], kNoGraphId};
            for (const Arc& arc : graph.at(n)) degree_[n] += kept[arc.edge];
        }
        // Neighbours, those two steps apart, then any two of a part.
        for (GraphId n = 0; n < graph.node_count(); ++n)
            for (const Arc& arc : graph.at(n)) join_odd(n, arc.to);
        for (GraphId n = 0; n < graph.node_count(); ++n) {
            if (degree_[n] % 2 == 0 || nodes_[n].mate != kNoGraphId) continue;
            for (const Arc& arc : graph.at(n))
                for (const Arc& next : graph.at(arc.to)) join_odd(n, next.to);
        }
        std::vector<GraphId> left(graph.parts.count, kNoGraphId);  // part -> odd node without mate
        for (GraphId n = 0; n < graph.node_count(); ++n) {
            if (degree_[n] % 2 == 0 || nodes_[n].mate != kNoGraphId) continue;
            GraphId& other = left[graph.parts.of[n]];
            if (other == kNoGraphId) {
                other = n;
            } else {
                join_odd(n, other);
                other = kNoGraphId;
            }
        }
    }

    void run() {
        for (const int degree : {1, 3, 2, 4})
            for (GraphId n = 0; n < graph_.node_count(); ++n)
                if (degree_[n] == degree) tour_from(n);
    }

  private:
    static constexpr std::ptrdiff_t kAhead = 8;  // nodes, on the way back
    static constexpr GraphId kDummy = kNoGraphId - 1;

    struct Node {
        GraphId next = 0, end = 0;  // arcs not yet looked at
        GraphId mate = kNoGraphId;  // across the dummy edge, if that is not used yet
    };

    void join_odd(GraphId a, GraphId b) {
        if (a == b || degree_[a] % 2 == 0 || degree_[b] % 2 == 0) return;
        if (nodes_[a].mate != kNoGraphId || nodes_[b].mate != kNoGraphId) return;
        nodes_[a].mate = b;
        nodes_[b].mate = a;
    }

    // An edge not yet used, the dummy first; its edge is kNoGraphId where there is none.
    Arc next_arc(GraphId at) {
        Node& node = nodes_[at];
        if (node.mate != kNoGraphId) {
            const GraphId mate = node.mate;
            node.mate = nodes_[mate].mate = kNoGraphId;
            return {mate, kDummy};
        }
        while (node.next < node.end) {
            const bool first = (at * 2654435761U >> 31) == 0;
            const Arc arc = graph_.arcs[first ? node.next++ : --node.end];
            if (used_[arc.edge]) continue;
            used_.set(arc.edge);
            return arc;
        }
        return {at, kNoGraphId};
    }

    // Colours the edges of the tour that starts and ends at `start`, last edge first.
    void tour_from(GraphId start) {
        bool in = true;
        stack_.assign(1, {start, kNoGraphId});
        while (!stack_.empty()) {
            const Arc top = stack_.back();
            const Arc arc = next_arc(top.to);
            if (arc.edge != kNoGraphId) {
                stack_.push_back(arc);
                continue;
            }
            stack_.pop_back();
            if (stack_.size() >= kAhead) __builtin_prefetch(&nodes_[stack_.end()[-kAhead].to]);
            if (top.edge == kNoGraphId) return;
            if (in && top.edge != kDummy) set_[top.edge] = 1;
            in = !in;
        }
    }

    const Graph& graph_;
    EdgeSet& set_;
    std::vector<std::uint8_t> degree_;  // of the edges that are kept
    std::vector<Node> nodes_;
    Bits used_;               // edges, and those that are not kept
    std::vector<Arc> stack_;  // node and the edge it was reached by
};

}  // namespace

EdgeSet euler_matching(const Graph& graph) {
    EdgeSet set(graph.edge_count(), 0);
    if (graph.node_count() > 0) Tours(graph, set).run();
    return set;
}

}  // namespace ravel
