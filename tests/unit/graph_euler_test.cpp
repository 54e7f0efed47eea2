#include <catch2/catch.hpp>

#include "graph/euler.h"
#include "support/small_graphs.h"

using namespace ravel;

TEST_CASE("an Euler matching is a 2-matching") {
    for (const auto& [name, graph] : test::small_graphs()) {
        INFO(name);
        for (const auto degree : degrees_in(graph, euler_matching(graph))) CHECK(degree <= 2);
    }
}

TEST_CASE("an Euler matching of a 4-regular graph is a 2-factor") {
    for (const Graph& graph : {test::complete_five(), test::double_triangle()})
        for (const auto degree : degrees_in(graph, euler_matching(graph))) CHECK(degree == 2);
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        const Graph graph = test::random_graph(40 + seed, 4, seed);
        const EdgeSet set = euler_matching(graph);
        const auto degree = degrees_in(graph, set);
        for (GraphId n = 0; n < graph.node_count(); ++n)
            if (graph.degree(n) == 4) CHECK(degree[n] == 2);
    }
}

TEST_CASE("an Euler matching leaves no node of degree three or four alone") {
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        const Graph graph = test::random_graph(31 + seed, 3, seed);
        const auto degree = degrees_in(graph, euler_matching(graph));
        for (GraphId n = 0; n < graph.node_count(); ++n)
            if (graph.degree(n) == 3) CHECK(degree[n] >= 1);
    }
}
