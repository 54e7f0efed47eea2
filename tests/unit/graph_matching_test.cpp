#include <catch2/catch.hpp>

#include <algorithm>

#include "graph/complement.h"
#include "graph/euler.h"
#include "graph/matching.h"
#include "graph/template_factor.h"
#include "graph/two_pass.h"
#include "support/small_graphs.h"

using namespace ravel;

namespace {

std::size_t edges_of(const EdgeSet& set) {
    return static_cast<std::size_t>(std::count(set.begin(), set.end(), 1));
}

bool is_two_factor(const Graph& graph, const EdgeSet& set) {
    const auto degree = degrees_in(graph, set);
    return std::all_of(degree.begin(), degree.end(), [](int d) { return d == 2; });
}

// The most edges a 2-matching can have, by trying all sets.
std::size_t best_by_force(const Graph& graph) {
    std::size_t best = 0;
    for (std::uint32_t bits = 0; bits < (1u << graph.edge_count()); ++bits) {
        EdgeSet set(graph.edge_count());
        for (GraphId e = 0; e < graph.edge_count(); ++e) set[e] = bits >> e & 1;
        const auto degree = degrees_in(graph, set);
        if (std::all_of(degree.begin(), degree.end(), [](int d) { return d <= 2; }))
            best = std::max(best, edges_of(set));
    }
    return best;
}

Graph cube_dual() {
    return make_graph(6, {{0, 1},
                          {1, 2},
                          {2, 3},
                          {3, 0},
                          {4, 0},
                          {4, 1},
                          {4, 2},
                          {4, 3},
                          {5, 0},
                          {5, 1},
                          {5, 2},
                          {5, 3}});
}

}  // namespace

TEST_CASE("a matching proves that it is maximum") {
    for (const auto& [name, graph] : test::small_graphs()) {
        INFO(name);
        CHECK(proves_maximum(graph, max_matching(graph)));
    }
}

TEST_CASE("a proof fails for fewer edges, two edges at a node or another barrier") {
    const Graph path = test::path_graph(4);
    Matching matching = max_matching(path);
    REQUIRE(matching.unmatched == 0);
    Matching fewer = matching;
    fewer.edges[0] = 0;
    CHECK_FALSE(proves_maximum(path, fewer));
    fewer.unmatched = 2;
    CHECK_FALSE(proves_maximum(path, fewer));
    Matching more = matching;
    more.edges[1] = 1;
    CHECK_FALSE(proves_maximum(path, more));
    Matching barred = matching;
    barred.barrier[0] = 1;
    barred.barrier[1] = 1;
    barred.barrier[2] = 1;
    CHECK_FALSE(proves_maximum(path, barred));
}

TEST_CASE("two-pass gives a 2-matching and tells whether it is a 2-factor") {
    for (const auto& [name, graph] : test::small_graphs()) {
        INFO(name);
        const TwoPass result = two_pass(graph);
        for (const auto degree : degrees_in(graph, result.set)) CHECK(degree <= 2);
        CHECK(result.two_factor() == is_two_factor(graph, result.set));
        CHECK(2 * edges_of(result.set) + result.unmatched_first + result.unmatched_second ==
              2 * std::size_t{graph.node_count()});
    }
}

TEST_CASE("template substitution finds a maximum 2-matching and a 2-factor where there is one") {
    for (const auto& [name, graph] : test::small_graphs()) {
        INFO(name);
        const Graph inflated = inflate(graph);
        const Matching matching = max_matching(inflated);
        REQUIRE(proves_maximum(inflated, matching));
        const TemplateFactor result = template_factor(graph, matching);
        for (const auto degree : degrees_in(graph, result.set)) CHECK(degree <= 2);
        CHECK(result.two_factor == is_two_factor(graph, result.set));
        bool all_two = true;
        std::size_t dopes = 0;
        for (GraphId n = 0; n < graph.node_count(); ++n) {
            all_two = all_two && graph.degree(n) >= 2;
            if (graph.degree(n) > 2) dopes += graph.degree(n) - 2;
        }
        // Theorem 2 of the paper, and what freeing dopes keeps of it where there is no 2-factor.
        CHECK(result.two_factor == (all_two && matching.unmatched == 0));
        CHECK(edges_of(result.set) + dopes >= edges_of(matching.edges));
        CHECK(edges_of(result.set) >= edges_of(two_pass(graph).set));
        if (graph.edge_count() <= 14) CHECK(edges_of(result.set) == best_by_force(graph));
    }
}

TEST_CASE("any two copies of a node can be matched outside its template") {
    // A node with n leaves of degree two: a cycle through it uses any two of its edges.
    for (const GraphId n : {3u, 4u, 5u, 6u, 9u}) {
        for (GraphId a = 0; a < n; ++a) {
            for (GraphId b = a + 1; b < n; ++b) {
                test::Ends ends;
                for (GraphId i = 0; i < n; ++i) ends.push_back({0, i + 1});
                ends.push_back({a + 1, b + 1});
                // The other neighbours find cycles of their own.
                GraphId next = n + 1;
                for (GraphId i = 0; i < n; ++i) {
                    if (i == a || i == b) continue;
                    for (const GraphId k : {i + 1, next}) ends.push_back({k, next + 1});
                    ends.push_back({i + 1, next});
                    next += 2;
                }
                const Graph graph = make_graph(next, ends);
                const TemplateFactor result = template_factor(graph);
                CHECK(result.two_factor);
                CHECK(result.set[a] == 1);
                CHECK(result.set[b] == 1);
            }
        }
    }
}

TEST_CASE("the paper's five-node graph has no perfect matching but a 2-factor") {
    const Graph graph = test::complete_five();
    CHECK(max_matching(graph).unmatched == 1);
    CHECK_FALSE(two_pass(graph).two_factor());
    CHECK(template_factor(graph).two_factor);
    CHECK(is_two_factor(graph, euler_matching(graph)));
}

TEST_CASE("the paper's three-node graph gets its cycle from template substitution alone") {
    const Graph graph = test::double_triangle();
    const TwoPass passes = two_pass(graph);
    CHECK_FALSE(passes.two_factor());
    CHECK(passes.unmatched_first == 1);
    CHECK(template_factor(graph).two_factor);
}

TEST_CASE("the cube's dual gets a 2-factor from either method, and what is left is one, too") {
    const Graph graph = cube_dual();
    const TwoPass passes = two_pass(graph);
    CHECK(passes.two_factor());
    CHECK(is_two_factor(graph, complement_matching(graph, passes.set)));
    const TemplateFactor factor = template_factor(graph);
    CHECK(factor.two_factor);
    CHECK(is_two_factor(graph, complement_matching(graph, factor.set)));
}

TEST_CASE("strips along unmatched edges are a 2-matching outside the set") {
    for (const auto& [name, graph] : test::small_graphs()) {
        INFO(name);
        const EdgeSet set = template_factor(graph).set;
        const EdgeSet other = complement_matching(graph, set);
        for (const auto degree : degrees_in(graph, other)) CHECK(degree <= 2);
        for (GraphId e = 0; e < graph.edge_count(); ++e) CHECK(set[e] + other[e] <= 1);
    }
}

TEST_CASE("random 4-regular graphs with odd and even node counts get 2-factors") {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const Graph graph = test::random_graph(401 + seed, 4, seed);
        bool regular = true;
        for (GraphId n = 0; n < graph.node_count(); ++n) regular = regular && graph.degree(n) == 4;
        const TemplateFactor factor = template_factor(graph);
        if (regular) CHECK(factor.two_factor);
        if (graph.node_count() % 2 == 1) CHECK_FALSE(two_pass(graph).two_factor());
    }
}
