// Dual graph -> 2-matching (steered walk, Euler tour, two matchings, or one in the inflated graph)
// -> maximum by alternating walks -> surplus paths closed -> strips merged around fans, then by
// longer rings, then by rotations -> tree of links. Cost: near-linear; about 1 s per million cells,
// and that of the matchings.
#include "strip/build.h"

#include <algorithm>
#include <utility>

#include "graph/augment.h"
#include "graph/close.h"
#include "graph/complement.h"
#include "graph/cut.h"
#include "graph/cycles.h"
#include "graph/euler.h"
#include "graph/leftover.h"
#include "graph/rings.h"
#include "graph/rotate.h"
#include "graph/template_factor.h"
#include "graph/two_pass.h"
#include "strip/dual.h"
#include "strip/links.h"
#include "strip/merge.h"
#include "strip/steered.h"

namespace ravel {

namespace {

// Measured: in tets a look at all ways on leaves half as many path ends to mend as one at two; on
// surfaces it makes no difference, so the walk keeps to the rule, but for cells that nothing else
// leads to.
constexpr Id kPolygonLookAhead = 1;
constexpr Id kTetLookAhead = 3;

constexpr GraphId kVisitsPerNode = 8;

// Near-maximum, by walks from all ends at once, and one after the other where few ends are left:
// all searches together visit few states per node.
EdgeSet raise(const Graph& graph, EdgeSet set) {
    set = join_ends(graph, std::move(set));
    const std::vector<std::uint8_t> degree = degrees_in(graph, set);
    const auto ends = static_cast<GraphId>(
        std::count_if(degree.begin(), degree.end(), [](std::uint8_t d) { return d < 2; }));
    if (ends == 0) return set;
    RepairLimits limits;
    limits.visits = std::max(limits.visits, kVisitsPerNode * (graph.node_count() / ends));
    return augment(graph, std::move(set), limits);
}

// The 2-matching as the method finds it, before anything is mended that is not the method's own.
EdgeSet find_factor(const Dual& dual, const Steered& walk, FactorMethod method, Reading reading) {
    const Graph& graph = dual.graph;
    EdgeSet set;
    switch (method) {
        case FactorMethod::steered:
            return raise(graph, paths_of(walk, dual));
        case FactorMethod::euler:
            return raise(graph, euler_matching(graph));
        case FactorMethod::two_pass:
            set = two_pass(graph).set;
            break;
        case FactorMethod::template_substitution:
            set = template_factor(graph).set;
            break;
    }
    return reading == Reading::unmatched ? complement_matching(graph, set) : set;
}

void count_shapes(const StripList& strips, StripCounts& counts) {
    for (const StripShape shape : strips.shape) {
        counts.cycles += shape == StripShape::cycle;
        counts.paths += shape == StripShape::path;
        counts.singletons += shape == StripShape::singleton;
    }
}

// Nothing is to be closed or cut: a part has one path at most, and no singletons.
bool is_settled(const Graph& graph, const StripList& strips) {
    std::vector<std::uint8_t> has_path(graph.parts.count, 0);
    for (GraphId s = 0; s < strips.count(); ++s) {
        const GraphId node = strips.node[strips.first[s]];
        if (strips.shape[s] == StripShape::singleton && graph.degree(node) > 0) return false;
        if (strips.shape[s] != StripShape::path) continue;
        if (has_path[graph.parts.of[node]] != 0) return false;
        has_path[graph.parts.of[node]] = 1;
    }
    return true;
}

}  // namespace

Strip build_strip(const Complex& complex, FactorMethod method, const StripOptions& options) {
    SteerOptions steering;
    steering.look_ahead = complex.kind == CellKind::tet ? kTetLookAhead : kPolygonLookAhead;
    steering.weights = options.weights;
    const Steered walk = steer(complex, steering);
    const Dual dual = make_dual(complex, walk.order);
    const Graph& graph = dual.graph;
    EdgeSet set = find_factor(dual, walk, method, options.reading);
    StripCounts factor;
    StripList strips = list_strips(graph, set);
    count_shapes(strips, factor);
    // A maximum has been reached already, but for these.
    const bool raised = method != FactorMethod::two_pass && options.reading != Reading::unmatched;
    if (!raised || !is_settled(graph, strips)) {
        if (!raised) set = raise(graph, std::move(set));
        set = cut_paths(graph, extend_paths(graph, close_paths(graph, std::move(set))));
        strips = list_strips(graph, set);
    }
    StripJoiner joiner(graph, set, std::move(strips));
    std::uint64_t merges = merge_fans(complex, dual, joiner);
    RingLimits rings;
    rings.edges_in = options.ring_edges;
    if (joiner.strips_left() > graph.parts.count) merges += merge_rings(joiner, rings);
    Strip strip;
    if (joiner.strips_left() > graph.parts.count && rings.edges_in > 0) {
        set = merge_leftover(graph, merge_by_rotations(graph, std::move(set)).set);
        StripJoiner rotated(graph, set);
        strip = link_strips(complex, dual, rotated);
    } else {
        strip = link_strips(complex, dual, joiner);
    }
    strip.counts.cycles = factor.cycles;
    strip.counts.paths = factor.paths;
    strip.counts.singletons = factor.singletons;
    strip.counts.fan_merges = merges;
    return strip;
}

}  // namespace ravel
