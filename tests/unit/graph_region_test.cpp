#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>

#include "graph/augment.h"
#include "graph/bound.h"
#include "graph/close.h"
#include "graph/cut.h"
#include "graph/leftover.h"
#include "graph/region.h"
#include "support/small_graphs.h"

using namespace ravel;

namespace {

EdgeSet strips_of(const Graph& graph) {
    EdgeSet set = augment(graph, EdgeSet(graph.edge_count(), 0));
    return cut_paths(graph, extend_paths(graph, close_paths(graph, std::move(set))));
}

// Links that join the strips, or a large number where a part has two paths.
std::size_t links_of(const Graph& graph, const EdgeSet& set) {
    const StripList strips = list_strips(graph, set);
    std::vector<int> paths(graph.parts.count, 0);
    for (GraphId s = 0; s < strips.count(); ++s)
        if (strips.shape[s] == StripShape::path &&
            ++paths[graph.parts.of[strips.node[strips.first[s]]]] > 1)
            return graph.node_count();
    return strips.count() - graph.parts.count;
}

// The fewest links, by trying all sets.
std::size_t fewest_by_force(const Graph& graph) {
    std::size_t fewest = graph.node_count();
    for (std::uint32_t bits = 0; bits < (1u << graph.edge_count()); ++bits) {
        EdgeSet set(graph.edge_count());
        for (GraphId e = 0; e < graph.edge_count(); ++e) set[e] = bits >> e & 1;
        const auto degree = degrees_in(graph, set);
        if (std::all_of(degree.begin(), degree.end(), [](int d) { return d <= 2; }))
            fewest = std::min(fewest, links_of(graph, set));
    }
    return fewest;
}

// Random graphs of few edges, and trees, which need links.
std::vector<Graph> tiny_graphs() {
    std::vector<Graph> all;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        all.push_back(test::random_graph(6 + seed % 5, 2 + seed % 3, seed));
        all.push_back(test::hubs(10, 1 + seed % 3, seed));
    }
    std::erase_if(all, [](const Graph& graph) { return graph.edge_count() > 15; });
    return all;
}

// Four triangles that hang at one node.
Graph star_of_triangles() {
    test::Ends ends;
    for (GraphId a = 1; a < 13; a += 3)
        for (const auto& edge : {std::array{a, a + 1}, {a + 1, a + 2}, {a + 2, a}, {GraphId{0}, a}})
            ends.push_back(edge);
    return make_graph(13, ends);
}

}  // namespace

TEST_CASE("no strips have fewer links than the bound says") {
    std::size_t exact = 0, forced = 0;
    for (const Graph& graph : tiny_graphs()) {
        const std::size_t fewest = fewest_by_force(graph);
        for (const EdgeSet& set : {strips_of(graph), EdgeSet(graph.edge_count(), 0)}) {
            const std::uint64_t bound = forced_links(graph, set);
            CHECK(bound <= fewest);
            exact += bound == fewest;
            forced += fewest > 0;
        }
    }
    REQUIRE(forced > 20);
    CHECK(exact > 100);
}

TEST_CASE("the bound finds what bridges force") {
    const Graph graph = star_of_triangles();
    const EdgeSet set = merge_leftover(graph, strips_of(graph));
    CHECK(links_of(graph, set) == 2);
    CHECK(forced_links(graph, set) == 2);
}

TEST_CASE("in tiny graphs the fewest links are reached") {
    for (const Graph& graph : tiny_graphs()) {
        const EdgeSet set = merge_leftover(graph, strips_of(graph));
        for (const auto degree : degrees_in(graph, set)) CHECK(degree <= 2);
        CHECK(links_of(graph, set) == fewest_by_force(graph));
    }
}

TEST_CASE("merging what is left never makes more strips or a second path") {
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        for (const Graph& graph :
             {test::random_graph(60, 3, seed), test::hubs(100, 5 + 5 * seed, seed)}) {
            const EdgeSet start = strips_of(graph);
            const EdgeSet set = merge_leftover(graph, start);
            for (const auto degree : degrees_in(graph, set)) CHECK(degree <= 2);
            CHECK(links_of(graph, set) <= links_of(graph, start));
            CHECK(forced_links(graph, set) <= links_of(graph, set));
        }
    }
}

TEST_CASE("a region is chosen anew without a change outside") {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const Graph graph = test::random_graph(80, 4, seed);
        const EdgeSet start = strips_of(graph);
        const std::vector<std::uint8_t> barred(graph.node_count(), 0);
        for (GraphId n = 0; n < graph.node_count(); n += 7) {
            EdgeSet set = start;
            StripJoiner joiner(graph, set);
            RegionSearch options;
            options.sideways = true;
            options.seed = seed + 1;
            const std::vector<GraphId> region = grow_region(graph, {&n, 1}, 12, barred);
            CHECK(std::find(region.begin(), region.end(), n) != region.end());
            merge_in_region(joiner, region, options, set);
            for (GraphId e = 0; e < graph.edge_count(); ++e)
                for (const GraphId end : graph.ends[e])
                    if (std::find(region.begin(), region.end(), end) == region.end())
                        CHECK(set[e] == start[e]);
            for (const auto degree : degrees_in(graph, set)) CHECK(degree <= 2);
            CHECK(links_of(graph, set) <= links_of(graph, start));
        }
    }
}
