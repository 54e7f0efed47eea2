#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

#include "graph/augment.h"
#include "graph/close.h"
#include "graph/cut.h"
#include "graph/cycles.h"
#include "graph/rotate.h"
#include "support/small_graphs.h"

using namespace ravel;

namespace {

// A 2-matching with at most one path per part, as strips are made from.
EdgeSet strips_of(const Graph& graph) {
    EdgeSet set = augment(graph, EdgeSet(graph.edge_count(), 0));
    return cut_paths(graph, extend_paths(graph, close_paths(graph, std::move(set))));
}

std::vector<int> paths_per_part(const Graph& graph, const StripList& strips) {
    std::vector<int> paths(graph.parts.count, 0);
    for (GraphId s = 0; s < strips.count(); ++s)
        if (strips.shape[s] == StripShape::path)
            ++paths[graph.parts.of[strips.node[strips.first[s]]]];
    return paths;
}

void check_merge(const Graph& graph, const EdgeSet& set) {
    const RotationMerge merged = merge_by_rotations(graph, set);
    for (const auto degree : degrees_in(graph, merged.set)) CHECK(degree <= 2);
    const StripList before = list_strips(graph, set), after = list_strips(graph, merged.set);
    CHECK(before.count() - after.count() == merged.merges);
    for (const int paths : paths_per_part(graph, after)) CHECK(paths <= 1);
}

}  // namespace

TEST_CASE("merging by rotations keeps one path per part and counts the strips it saves") {
    for (const auto& [name, graph] : test::small_graphs()) {
        INFO(name);
        check_merge(graph, strips_of(graph));
        check_merge(graph, EdgeSet(graph.edge_count(), 0));
    }
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        INFO(seed);
        const Graph graph = test::random_graph(30, 3, seed);
        check_merge(graph, strips_of(graph));
        check_merge(graph, EdgeSet(graph.edge_count(), 0));
    }
}

TEST_CASE("random 4-regular graphs end up with one closed strip") {
    GraphId apart = 0;
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
        INFO(seed);
        const Graph graph = test::random_graph(2000, 4, seed);
        const EdgeSet set = strips_of(graph);
        apart += list_strips(graph, set).count() - graph.parts.count;
        const StripList strips = list_strips(graph, merge_by_rotations(graph, set).set);
        CHECK(strips.count() == graph.parts.count);
        CHECK(paths_per_part(graph, strips)[0] == 0);
    }
    REQUIRE(apart > 0);
}

TEST_CASE("a bridge between two cycles leaves one open strip") {
    const Graph graph = make_graph(6, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}});
    const EdgeSet cycles{1, 1, 1, 1, 1, 1, 0};
    const RotationMerge merged = merge_by_rotations(graph, cycles);
    CHECK(merged.merges == 1);
    const StripList strips = list_strips(graph, merged.set);
    REQUIRE(strips.count() == 1);
    CHECK(strips.shape[0] == StripShape::path);
}

TEST_CASE("strips that hang together by one cell each stay apart") {
    // A star of triangles: its centre has room for two of them in one path.
    test::Ends ends;
    EdgeSet set;
    for (GraphId k = 0; k < 4; ++k) {
        const GraphId a = 1 + 3 * k;
        for (const auto& [from, to] : {std::array{a, a + 1}, {a + 1, a + 2}, {a + 2, a}}) {
            ends.push_back({from, to});
            set.push_back(1);
        }
        ends.push_back({0, a});
        set.push_back(0);
    }
    const Graph graph = make_graph(13, ends);
    const RotationMerge merged = merge_by_rotations(graph, set);
    CHECK(list_strips(graph, merged.set).count() == 3);
}
