// A Graph as LEMON's algorithms want it (lemon/concepts/graph.h), without a copy: LEMON's own
// graphs take twice the memory, keep no rows together, and their maps don't compile as C++20. Only
// what lemon::MaxMatching uses is here; an edge is known by either of its arcs.
#pragma once

#include <vector>

#include <lemon/core.h>

#include "graph/graph.h"

namespace ravel {

class LemonGraph {
  public:
    using NodeNumTag = lemon::True;

    struct Node {
        GraphId id = kNoGraphId;
        Node() = default;
        Node(lemon::Invalid) {}
        explicit Node(GraphId node) : id(node) {}
        bool operator==(const Node&) const = default;
        auto operator<=>(const Node&) const = default;
    };
    // The place of an arc in the rows.
    struct Edge {
        GraphId place = kNoGraphId;
        Edge() = default;
        Edge(lemon::Invalid) {}
        explicit Edge(GraphId at) : place(at) {}
    };
    struct Arc : Edge {
        using Edge::Edge;
        Arc() = default;
        friend bool operator==(const Arc& a, const Arc& b) { return a.place == b.place; }
    };

    struct NodeIt : Node {
        explicit NodeIt(const LemonGraph& graph) : Node(GraphId{0}), count(graph.node_count()) {
            if (count == 0) id = kNoGraphId;
        }
        NodeIt& operator++() {
            if (++id == count) id = kNoGraphId;
            return *this;
        }
        GraphId count;
    };
    // Each edge by the first of its arcs.
    struct EdgeIt : Edge {
        explicit EdgeIt(const LemonGraph& graph) : Edge(GraphId{0}), of(&graph) { find(); }
        EdgeIt& operator++() {
            ++place;
            find();
            return *this;
        }
        bool operator==(lemon::Invalid) const { return place == kNoGraphId; }
        void find() {
            const auto count = static_cast<GraphId>(of->opposite_.size());
            while (place < count && of->opposite_[place] < place) ++place;
            if (place >= count) place = kNoGraphId;
        }
        const LemonGraph* of;
    };
    struct OutArcIt : Arc {
        OutArcIt(const LemonGraph& graph, const Node& node)
            : Arc(graph.graph_.first[node.id]), end(graph.graph_.first[node.id + 1]) {
            if (place == end) place = kNoGraphId;
        }
        OutArcIt& operator++() {
            if (++place == end) place = kNoGraphId;
            return *this;
        }
        GraphId end;
    };

    template <class T>
    class NodeMap {
      public:
        using Key = Node;
        using Value = T;
        explicit NodeMap(const LemonGraph& graph) : values_(graph.node_count()) {}
        T& operator[](const Node& node) { return values_[node.id]; }
        const T& operator[](const Node& node) const { return values_[node.id]; }
        void set(const Node& node, const T& value) { values_[node.id] = value; }

      private:
        std::vector<T> values_;
    };

    // Named by LEMON's typedefs, used by none of what is used here.
    using ArcIt = OutArcIt;
    using InArcIt = OutArcIt;
    using IncEdgeIt = OutArcIt;
    template <class T>
    using ArcMap = NodeMap<T>;
    template <class T>
    using EdgeMap = NodeMap<T>;

    explicit LemonGraph(const Graph& graph) : graph_(graph), opposite_(graph.arcs.size()) {
        std::vector<GraphId> seen(graph.edge_count(), kNoGraphId);
        for (GraphId i = 0; i < opposite_.size(); ++i) {
            GraphId& other = seen[graph.arcs[i].edge];
            if (other == kNoGraphId) {
                other = i;
            } else {
                opposite_[i] = other;
                opposite_[other] = i;
            }
        }
    }

    GraphId node_count() const { return graph_.node_count(); }
    GraphId edge_at(GraphId place) const { return graph_.arcs[place].edge; }
    int nodeNum() const { return static_cast<int>(graph_.node_count()); }
    Node target(const Arc& arc) const { return Node(graph_.arcs[arc.place].to); }
    Node source(const Arc& arc) const { return Node(graph_.arcs[opposite_[arc.place]].to); }
    Arc oppositeArc(const Arc& arc) const { return Arc(opposite_[arc.place]); }
    Node u(const Edge& edge) const { return source(Arc(edge.place)); }
    Node v(const Edge& edge) const { return target(Arc(edge.place)); }
    Arc direct(const Edge& edge, bool forwards) const {
        return Arc(forwards ? edge.place : opposite_[edge.place]);
    }

  private:
    const Graph& graph_;
    std::vector<GraphId> opposite_;  // place of an arc -> place of its reverse
};

}  // namespace ravel
