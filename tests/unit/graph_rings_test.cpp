#include <catch2/catch.hpp>

#include <algorithm>

#include "graph/augment.h"
#include "graph/cycles.h"
#include "graph/rings.h"
#include "graph/rope.h"
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
            const RingMerge merged = merge_rings(graph, set, limits);
            CHECK(degrees_in(graph, merged.set) == degrees_in(graph, set));
            const GraphId before = list_strips(graph, set).count(),
                          after = list_strips(graph, merged.set).count();
            CHECK(after <= before);
            CHECK(before - after >= merged.merges);
        }
    }
}

TEST_CASE("cycles along a ladder become one, however many") {
    for (const GraphId cycles : {2u, 3u, 50u, 3000u}) {
        const Ladder l = ladder(cycles, 3);
        REQUIRE(list_strips(l.graph, l.set).count() == cycles);
        const RingMerge merged = merge_rings(l.graph, l.set);
        CHECK(list_strips(l.graph, merged.set).count() == 1);
    }
}

TEST_CASE("random 4-regular graphs end up with few cycles") {
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
        const Graph graph = test::random_graph(2000, 4, seed);
        const EdgeSet set = augment(graph, EdgeSet(graph.edge_count(), 0));
        const RingMerge merged = merge_rings(graph, set);
        CHECK(degrees_in(graph, merged.set) == degrees_in(graph, set));
        CHECK(list_strips(graph, merged.set).count() <= list_strips(graph, set).count());
    }
}

TEST_CASE("a rope keeps its order through cuts and joins") {
    // Against a plain list: cut at two ranks, turn the middle round, over and over, with a second
    // rope joined in.
    std::vector<GraphId> order(500), other{500, 501, 502};
    for (GraphId i = 0; i < order.size(); ++i) order[i] = i;
    Rope rope(order);
    const Rope second(other);
    std::vector<GraphId> place(503);
    for (GraphId i = 0; i < 500; ++i) place[i] = i;
    for (GraphId i = 0; i < 3; ++i) place[500 + i] = i;
    std::uint32_t state = 5;
    for (int round = 0; round < 2000; ++round) {
        const GraphId n = rope.size();
        state = state * 1664525u + 1013904223u;
        GraphId a = (state >> 8) % n;
        state = state * 1664525u + 1013904223u;
        GraphId b = (state >> 8) % n;
        if (a > b) std::swap(a, b);
        std::vector<Rope::Stretch> stretches{
            {&rope, 0, a, false}, {&rope, a, b, true}, {&rope, b, n, false}};
        std::reverse(order.begin() + a, order.begin() + b);
        if (round == 1000) {
            stretches.insert(stretches.begin() + 1, {&second, 1, 3, true});
            stretches.push_back({&second, 0, 1, false});
            order.insert(order.begin() + a, {502, 501});
            order.push_back(500);
        }
        rope.join(stretches, place);
        for (GraphId i = 0; i < order.size(); i += 7) REQUIRE(rope.rank(place[order[i]]) == i);
    }
}
