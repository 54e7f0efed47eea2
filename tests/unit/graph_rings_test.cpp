#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>

#include "graph/augment.h"
#include "graph/cycles.h"
#include "graph/rings.h"
#include "graph/ropes.h"
#include "support/small_graphs.h"

using namespace ravel;

namespace {

// A long ladder whose rails are cut into cycles of `length` rungs each.
struct Ladder {
    Graph graph;
    EdgeSet set;
};

Ladder ladder(GraphId cycles, GraphId length) {
    const GraphId n = cycles * length;
    test::Ends ends;
    EdgeSet set;
    for (GraphId i = 0; i < n; ++i) {
        const bool first = i % length == 0, last = i % length == length - 1;
        ends.push_back({2 * i, 2 * i + 1});
        set.push_back(first || last);
        if (i + 1 == n) continue;
        for (const GraphId side : {0u, 1u}) {
            ends.push_back({2 * i + side, 2 * i + 2 + side});
            set.push_back(!last);
        }
    }
    return {make_graph(2 * n, ends), set};
}

}  // namespace

TEST_CASE("merging rings keeps every degree and counts the strips it saves") {
    for (const auto& [name, graph] : test::small_graphs()) {
        INFO(name);
        const EdgeSet set = augment(graph, EdgeSet(graph.edge_count(), 0));
        for (int edges = 0; edges <= kMaxRingEdges; ++edges) {
            RingLimits limits;
            limits.edges_in = edges;
            EdgeSet merged = set;
            StripJoiner joiner(graph, merged);
            const std::uint64_t saved = merge_rings(joiner, limits);
            CHECK(degrees_in(graph, merged) == degrees_in(graph, set));
            CHECK(list_strips(graph, merged).count() + saved == list_strips(graph, set).count());
            CHECK(joiner.strips_left() == list_strips(graph, merged).count());
        }
    }
}

TEST_CASE("cycles along a ladder become one, however many") {
    for (const GraphId cycles : {2u, 3u, 50u, 3000u}) {
        const Ladder l = ladder(cycles, 3);
        REQUIRE(list_strips(l.graph, l.set).count() == cycles);
        EdgeSet set = l.set;
        StripJoiner joiner(l.graph, set);
        CHECK(merge_rings(joiner) == cycles - 1);
        CHECK(list_strips(l.graph, set).count() == 1);
    }
}

TEST_CASE("in random 4-regular graphs each merge saves a cycle") {
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
        const Graph graph = test::random_graph(2000, 4, seed);
        const EdgeSet set = augment(graph, EdgeSet(graph.edge_count(), 0));
        EdgeSet merged = set;
        StripJoiner joiner(graph, merged);
        const std::uint64_t saved = merge_rings(joiner);
        CHECK(degrees_in(graph, merged) == degrees_in(graph, set));
        CHECK(list_strips(graph, merged).count() + saved == list_strips(graph, set).count());
    }
}

TEST_CASE("a path takes in a neighbouring cycle or singleton at its end") {
    // A path 0 - 1 - 2 beside a cycle 3 - 4 - 5 - 6 and a singleton 7.
    const Graph graph = make_graph(
        8, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 3}, {4, 7}, {6, 7}, {7, 0}});
    EdgeSet set{1, 1, 0, 1, 1, 1, 1, 0, 0, 0};
    StripJoiner joiner(graph, set);
    const GraphId end = joiner.absorb(2, 2, 3);
    CHECK((end == 4 || end == 6));
    CHECK(joiner.absorb(end, end == 4 ? 7 : 8, 7) == 7);
    CHECK(joiner.strips_left() == 1);
    CHECK(joiner.is_open(0));
    const StripList strips = list_strips(graph, set);
    REQUIRE(strips.count() == 1);
    CHECK(strips.shape[0] == StripShape::path);
    CHECK(strips.node.back() == 7);
}

TEST_CASE("ropes keep their order through cuts and joins") {
    // Against plain lists: cut at two ranks, turn the middle round, over and over, with a second
    // rope joined in.
    const GraphId nodes = 503;
    test::Ends ends;
    for (GraphId n = 0; n + 1 < nodes; ++n) ends.push_back({n, n + 1});
    const Graph graph = make_graph(nodes, ends);
    EdgeSet set(graph.edge_count(), 1);
    set[499] = 0;
    Ropes ropes(list_strips(graph, set), 1);
    REQUIRE(ropes.size(0) == 500);
    REQUIRE(ropes.size(1) == 3);
    REQUIRE(ropes.size(2) == 1);
    std::vector<GraphId> order(500);
    std::iota(order.begin(), order.end(), GraphId{0});
    std::uint32_t state = 5;
    for (int round = 0; round < 3000; ++round) {
        const GraphId n = ropes.size(0);
        state = state * 1664525u + 1013904223u;
        GraphId a = (state >> 8) % n;
        state = state * 1664525u + 1013904223u;
        GraphId b = (state >> 8) % n;
        if (a > b) std::swap(a, b);
        std::vector<Ropes::Stretch> stretches{{0, 0, a, false}, {0, a, b, true}, {0, b, n, false}};
        std::reverse(order.begin() + a, order.begin() + b);
        if (round == 1000) {
            stretches.insert(stretches.begin() + 1, {1, 1, 3, true});
            stretches.push_back({1, 0, 1, false});
            order.insert(order.begin() + a, {502, 501});
            order.push_back(500);
        }
        if (round == 2000) {
            stretches.push_back({2, 0, 1, false});
            order.push_back(503);
        }
        ropes.join(0, stretches);
        REQUIRE(ropes.size(0) == order.size());
        for (GraphId i = 0; i < order.size(); i += 7) {
            REQUIRE(ropes.rank(order[i]) == i);
            REQUIRE(ropes.node_at(0, i) == order[i]);
        }
    }
    CHECK(ropes.size(1) == 0);
}
