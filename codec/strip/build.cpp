// Dual graph -> 2-matching (steered walk or Euler tour) -> maximum by alternating walks -> surplus
// paths closed -> strips merged around fans, then by longer rings -> tree of links.
// Cost: near-linear; about 1 s per million cells.
#include "strip/build.h"

#include <utility>

#include "graph/augment.h"
#include "graph/close.h"
#include "graph/cut.h"
#include "graph/cycles.h"
#include "graph/euler.h"
#include "graph/rings.h"
#include "strip/dual.h"
#include "strip/links.h"
#include "strip/merge.h"
#include "strip/steered.h"

namespace ravel {

namespace {

// Measured over the corpus as links and as bits of the turns: on surfaces every step away from the
// rule costs more than the dead end it avoids, unless it is a cell that nothing else leads to.
constexpr Id kPolygonLookAhead = 1;
constexpr Id kTetLookAhead = 2;

}  // namespace

Strip build_strip(const Complex& complex, FactorMethod method, const StripEffort& effort) {
    SteerOptions options;
    options.look_ahead = complex.kind == CellKind::tet ? kTetLookAhead : kPolygonLookAhead;
    const Steered walk = steer(complex, options);
    const Dual dual = make_dual(complex, walk.order);
    const Graph& graph = dual.graph;
    EdgeSet set = augment(graph, method == FactorMethod::euler ? euler_matching(graph)
                                                               : paths_of(walk, dual));
    StripCounts factor;
    {
        const StripList strips = list_strips(graph, set);
        for (const StripShape shape : strips.shape) {
            factor.cycles += shape == StripShape::cycle;
            factor.paths += shape == StripShape::path;
            factor.singletons += shape == StripShape::singleton;
        }
    }
    set = cut_paths(graph, extend_paths(graph, close_paths(graph, std::move(set))));
    Merged merged = merge_fans(complex, dual, std::move(set));
    RingLimits rings;
    rings.edges_in = effort.ring_edges;
    RingMerge whole = merge_rings(graph, std::move(merged.set), rings);
    Strip strip = link_strips(complex, dual, whole.set);
    strip.counts.cycles = factor.cycles;
    strip.counts.paths = factor.paths;
    strip.counts.singletons = factor.singletons;
    strip.counts.fan_merges = merged.fan_merges + whole.merges;
    return strip;
}

}  // namespace ravel
