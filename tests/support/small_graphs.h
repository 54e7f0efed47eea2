// Small multigraphs for tests.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "graph/graph.h"

namespace ravel::test {

using Ends = std::vector<std::array<GraphId, 2>>;

// The paper's figure 4, left: five nodes, all joined; 4-regular without a perfect matching.
inline Graph complete_five() {
    Ends ends;
    for (GraphId a = 0; a < 5; ++a)
        for (GraphId b = a + 1; b < 5; ++b) ends.push_back({a, b});
    return make_graph(5, ends);
}

// Right: three nodes, every two joined twice.
inline Graph double_triangle() {
    return make_graph(3, {{0, 1}, {0, 1}, {1, 2}, {1, 2}, {2, 0}, {2, 0}});
}

inline Graph path_graph(GraphId nodes) {
    Ends ends;
    for (GraphId n = 0; n + 1 < nodes; ++n) ends.push_back({n, n + 1});
    return make_graph(nodes, ends);
}

// Pairs of stubs drawn by a seeded generator; self loops are dropped, parallel edges stay.
inline Graph random_graph(GraphId nodes, GraphId degree, std::uint32_t seed) {
    std::vector<GraphId> stubs;
    for (GraphId n = 0; n < nodes; ++n) stubs.insert(stubs.end(), degree, n);
    std::uint32_t state = seed * 2654435761u + 3;
    for (std::size_t i = stubs.size(); i > 1; --i) {
        state = state * 1664525u + 1013904223u;
        std::swap(stubs[i - 1], stubs[(std::uint64_t{state} * i) >> 32]);
    }
    Ends ends;
    for (std::size_t i = 0; i + 1 < stubs.size(); i += 2)
        if (stubs[i] != stubs[i + 1]) ends.push_back({stubs[i], stubs[i + 1]});
    return make_graph(nodes, ends);
}

// Rings of small nodes, each also joined to one of few hubs and now and then to another ring.
inline Graph hubs(GraphId nodes, GraphId hubs, std::uint32_t seed) {
    std::uint32_t state = seed * 2654435761u + 3;
    const auto draw = [&](GraphId below) {
        state = state * 1664525u + 1013904223u;
        return static_cast<GraphId>((std::uint64_t{state} * below) >> 32);
    };
    Ends ends;
    for (GraphId n = hubs; n < nodes; ++n) {
        ends.push_back({draw(hubs), n});
        if (draw(3) > 0 && n + 1 < nodes) ends.push_back({n, n + 1});
        if (draw(4) == 0 && n > hubs) ends.push_back({hubs + draw(n - hubs), n});
    }
    return make_graph(nodes, ends);
}

struct NamedGraph {
    std::string name;
    Graph graph;
};

inline std::vector<NamedGraph> small_graphs() {
    std::vector<NamedGraph> all{
        {"no node", make_graph(0, {})},
        {"one node", make_graph(1, {})},
        {"two nodes apart", make_graph(2, {})},
        {"one edge", make_graph(2, {{0, 1}})},
        {"two parallel edges", make_graph(2, {{0, 1}, {1, 0}})},
        {"four parallel edges", make_graph(2, {{0, 1}, {1, 0}, {0, 1}, {0, 1}})},
        {"star", make_graph(6, {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}})},
        {"path", path_graph(7)},
        {"complete five", complete_five()},
        {"double triangle", double_triangle()}};
    for (std::uint32_t seed = 0; seed < 20; ++seed)
        for (const GraphId degree : {2u, 3u, 4u, 6u})
            all.push_back(
                {"random, degree " + std::to_string(degree) + ", seed " + std::to_string(seed),
                 random_graph(5 + 7 * seed, degree, seed)});
    return all;
}

}  // namespace ravel::test
