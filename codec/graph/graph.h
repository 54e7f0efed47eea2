// An undirected multigraph in compressed rows. Parallel edges are common and have ids of their own;
// there are no self loops.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ravel {

using GraphId = std::uint32_t;  // nodes and edges
inline constexpr GraphId kNoGraphId = ~GraphId{0};

struct Arc {
    GraphId to = 0;
    GraphId edge = 0;
};

// Connected parts, numbered by their lowest node.
struct Components {
    GraphId count = 0;
    std::vector<GraphId> of;  // node -> component
};

struct Graph {
    Components parts;
    std::vector<GraphId> first;                // nodes + 1
    std::vector<Arc> arcs;                     // two per edge, ascending by edge at each node
    std::vector<std::array<GraphId, 2>> ends;  // edge -> its nodes

    GraphId node_count() const {
        return first.empty() ? 0 : static_cast<GraphId>(first.size() - 1);
    }
    GraphId edge_count() const { return static_cast<GraphId>(ends.size()); }
    GraphId degree(GraphId node) const { return first[node + 1] - first[node]; }
    std::span<const Arc> at(GraphId node) const {
        return {arcs.data() + first[node], arcs.data() + first[node + 1]};
    }
    GraphId other(GraphId edge, GraphId node) const {
        return ends[edge][0] == node ? ends[edge][1] : ends[edge][0];
    }
};

// Linear, by breadth-first search.
Components find_components(const Graph& graph);

// Linear. Edges are numbered as given.
Graph make_graph(GraphId nodes, std::vector<std::array<GraphId, 2>> ends);

// A 2-matching: an edge set in which no node has degree above two, so that it falls apart into
// cycles, paths and singletons. One byte per edge, 1 for the edges in the set.
using EdgeSet = std::vector<std::uint8_t>;

// How many edges of the set each node has.
std::vector<std::uint8_t> degrees_in(const Graph& graph, const EdgeSet& set);

}  // namespace ravel
