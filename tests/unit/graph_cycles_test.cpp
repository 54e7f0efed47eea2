#include <catch2/catch.hpp>

#include "graph/augment.h"
#include "graph/cycles.h"
#include "graph/union_find.h"
#include "support/small_graphs.h"

using namespace ravel;

TEST_CASE("strips visit every node once along edges of the set") {
    for (const auto& [name, graph] : test::small_graphs()) {
        INFO(name);
        const EdgeSet set = augment(graph, EdgeSet(graph.edge_count(), 0));
        const StripList strips = list_strips(graph, set);
        REQUIRE(strips.node.size() == graph.node_count());
        std::vector<int> seen(graph.node_count(), 0);
        std::size_t edges = 0;
        for (GraphId s = 0; s < strips.count(); ++s) {
            for (GraphId i = strips.first[s]; i < strips.first[s + 1]; ++i) {
                ++seen[strips.node[i]];
                CHECK(strips.of[strips.node[i]] == s);
                const bool last = i + 1 == strips.first[s + 1];
                if (strips.edge[i] == kNoGraphId) {
                    CHECK(last);
                    CHECK(strips.shape[s] != StripShape::cycle);
                    continue;
                }
                ++edges;
                CHECK(set[strips.edge[i]] == 1);
                CHECK(graph.other(strips.edge[i], strips.node[i]) ==
                      strips.node[last ? strips.first[s] : i + 1]);
            }
        }
        for (const int n : seen) CHECK(n == 1);
        std::size_t in = 0;
        for (const auto e : set) in += e;
        CHECK(edges == in);
    }
}

TEST_CASE("two parallel edges make a cycle of two") {
    const Graph graph = make_graph(2, {{0, 1}, {0, 1}});
    const StripList strips = list_strips(graph, {1, 1});
    REQUIRE(strips.count() == 1);
    CHECK(strips.shape[0] == StripShape::cycle);
}

TEST_CASE("sets unite once and know their sizes") {
    UnionFind sets(5);
    CHECK(sets.unite(0, 1));
    CHECK(sets.unite(3, 4));
    CHECK_FALSE(sets.unite(1, 0));
    CHECK(sets.unite(1, 4));
    CHECK(sets.find(0) == sets.find(3));
    CHECK(sets.find(2) == 2);
    CHECK(sets.size(4) == 4);
}
