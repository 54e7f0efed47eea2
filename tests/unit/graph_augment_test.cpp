#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>

#include "graph/augment.h"
#include "graph/close.h"
#include "graph/cut.h"
#include "graph/cycles.h"
#include "graph/euler.h"
#include "support/small_graphs.h"

using namespace ravel;

namespace {

std::size_t edges_of(const EdgeSet& set) {
    return static_cast<std::size_t>(std::count(set.begin(), set.end(), 1));
}

// Edges as they come, as long as both ends have less than `most`.
EdgeSet greedy(const Graph& graph, int most) {
    EdgeSet set(graph.edge_count(), 0);
    std::vector<int> degree(graph.node_count(), 0);
    for (GraphId e = 0; e < graph.edge_count(); ++e) {
        const auto [a, b] = graph.ends[e];
        if (degree[a] == most || degree[b] == most) continue;
        set[e] = 1;
        ++degree[a];
        ++degree[b];
    }
    return set;
}

// The most edges a 2-matching can have, by trying all sets.
std::size_t best_by_force(const Graph& graph) {
    std::size_t best = 0;
    for (std::uint32_t bits = 0; bits < (1u << graph.edge_count()); ++bits) {
        EdgeSet set(graph.edge_count());
        for (GraphId e = 0; e < graph.edge_count(); ++e) set[e] = bits >> e & 1;
        const auto degree = degrees_in(graph, set);
        if (std::all_of(degree.begin(), degree.end(), [](int d) { return d <= 2; }))
            best = std::max<std::size_t>(best, static_cast<std::size_t>(std::popcount(bits)));
    }
    return best;
}

GraphId paths_in(const Graph& graph, const EdgeSet& set) {
    const StripList strips = list_strips(graph, set);
    return static_cast<GraphId>(
        std::count(strips.shape.begin(), strips.shape.end(), StripShape::path));
}

}  // namespace

TEST_CASE("augmenting keeps a 2-matching and never loses an edge") {
    for (const auto& [name, graph] : test::small_graphs()) {
        INFO(name);
        for (const EdgeSet& start : {EdgeSet(graph.edge_count(), 0), euler_matching(graph)}) {
            const EdgeSet set = augment(graph, start);
            for (const auto degree : degrees_in(graph, set)) CHECK(degree <= 2);
            CHECK(edges_of(set) >= edges_of(start));
        }
    }
}

TEST_CASE("joining ends keeps a matching or 2-matching and never loses an edge") {
    std::vector<Graph> graphs;
    for (const auto& [name, graph] : test::small_graphs()) graphs.push_back(graph);
    // Large nodes beside small ones leave many singletons, which walks start from and pass.
    for (std::uint32_t seed = 0; seed < 40; ++seed)
        graphs.push_back(test::hubs(400, 10 + 5 * seed, seed));
    for (const Graph& graph : graphs) {
        for (const int most : {1, 2}) {
            for (const EdgeSet& start : {EdgeSet(graph.edge_count(), 0), greedy(graph, most)}) {
                const EdgeSet set = join_ends(graph, start, most);
                for (const auto degree : degrees_in(graph, set)) CHECK(degree <= most);
                CHECK(edges_of(set) >= edges_of(start));
            }
        }
    }
}

TEST_CASE("no walk passes the singleton that it starts from") {
    // Triangles of the set and, between them, four singletons 0 .. 3. The tree of 0 keeps that of 2
    // from 11 and 13 at first, so it comes to 2 again by 7, 8, 10, 11 before it sees 13.
    test::Ends ends;
    for (GraphId a = 4; a < 22; a += 3)
        for (const auto& edge : {std::array{a, a + 1}, {a + 1, a + 2}, {a + 2, a}})
            ends.push_back(edge);
    EdgeSet set(ends.size(), 1);
    for (const auto& edge : test::Ends{{0, 4},
                                       {0, 11},
                                       {0, 13},
                                       {5, 1},
                                       {2, 7},
                                       {8, 10},
                                       {11, 2},
                                       {2, 13},
                                       {14, 16},
                                       {17, 19},
                                       {20, 3}}) {
        ends.push_back(edge);
        set.push_back(0);
    }
    const Graph graph = make_graph(22, ends);
    for (const auto degree : degrees_in(graph, join_ends(graph, set))) CHECK(degree <= 2);
}

TEST_CASE("augmenting from nothing finds a maximum in small graphs") {
    for (const auto& [name, graph] : test::small_graphs()) {
        if (graph.edge_count() > 14) continue;
        INFO(name);
        CHECK(edges_of(augment(graph, EdgeSet(graph.edge_count(), 0))) == best_by_force(graph));
    }
}

TEST_CASE("the paper's graphs without a perfect matching get their 2-factors") {
    for (const Graph& graph : {test::complete_five(), test::double_triangle()})
        for (const auto degree : degrees_in(graph, augment(graph, EdgeSet(graph.edge_count(), 0))))
            CHECK(degree == 2);
}

TEST_CASE("closing and cutting leave at most one path per connected part") {
    for (const auto& [name, graph] : test::small_graphs()) {
        INFO(name);
        const EdgeSet raised = augment(graph, EdgeSet(graph.edge_count(), 0));
        for (const EdgeSet& start : {raised, euler_matching(graph)}) {
            const EdgeSet closed = close_paths(graph, start);
            for (const auto degree : degrees_in(graph, closed)) CHECK(degree <= 2);
            CHECK(paths_in(graph, closed) <= paths_in(graph, start));
            const EdgeSet set = cut_paths(graph, extend_paths(graph, closed));
            const StripList strips = list_strips(graph, set);
            const Components& parts = graph.parts;
            std::vector<int> paths(parts.count, 0);
            for (GraphId s = 0; s < strips.count(); ++s)
                if (strips.shape[s] == StripShape::path)
                    ++paths[parts.of[strips.node[strips.first[s]]]];
            for (const int p : paths) CHECK(p <= 1);
        }
    }
}

TEST_CASE("a path that is its part's last stays open") {
    const Graph graph = test::path_graph(9);
    const EdgeSet all(graph.edge_count(), 1);
    CHECK(cut_paths(graph, close_paths(graph, all)) == all);
}

TEST_CASE("cutting a path with chords makes the fewest pieces") {
    // Two paths of a ladder, kept apart by nothing but their own chords: 0-1-2-3 with chord 0-3 is
    // one cycle.
    const Graph graph =
        make_graph(9, {{0, 1}, {1, 2}, {2, 3}, {0, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 8}});
    EdgeSet set(graph.edge_count(), 1);
    set[3] = 0;
    set[4] = 0;
    const StripList strips = list_strips(graph, cut_paths(graph, set));
    CHECK(strips.count() == 2);
    CHECK(strips.shape[strips.of[0]] == StripShape::cycle);
    CHECK(strips.shape[strips.of[8]] == StripShape::path);
}
