// Kruskal's tree over strips [DiazGopi2005, 3]: facets between different strips, cheapest first. A
// split costs n - 1 cells per n-gon and three per tet, so small polygons go first, and two-gons
// (whose split has no room for more) last; a cell that carries a link already is taken only when
// nothing else is left. The root of a component is the lower end of its path, or else the lowest
// cell of its largest strip.
// Cost: near-linear.
#include "strip/links.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "graph/cycles.h"
#include "graph/union_find.h"

namespace ravel {
namespace {

constexpr std::size_t kPrices = 16;  // sums of two degrees beyond this are all alike

std::size_t price_of(const Complex& complex, Id facet) {
    std::size_t price = 0;
    for (const Id f : {facet, complex.twin[facet]}) {
        const Id degree = complex.degree(complex.cell_of[f]);
        if (degree < 3) return kPrices - 1;
        price += std::min<std::size_t>(degree, kPrices);
    }
    return std::min(price - 6, kPrices - 2);
}

// The lower end of a path, the lowest cell of another strip.
Id root_of(const Dual& dual, const StripList& strips, GraphId strip) {
    const GraphId begin = strips.first[strip], end = strips.first[strip + 1];
    Id root = dual.cell_of[strips.node[begin]];
    if (strips.shape[strip] == StripShape::path)
        return std::min(root, dual.cell_of[strips.node[end - 1]]);
    for (GraphId i = begin; i < end; ++i) root = std::min(root, dual.cell_of[strips.node[i]]);
    return root;
}

}  // namespace

Strip link_strips(const Complex& complex, const Dual& dual, const EdgeSet& set) {
    Strip strip;
    strip.role.assign(complex.twin.size(), FacetRole::none);
    const auto assign = [&](GraphId edge, FacetRole role) {
        const Id f = dual.facet_of[edge];
        strip.role[f] = role;
        strip.role[complex.twin[f]] = role;
    };
    const StripList strips = list_strips(dual.graph, set);
    std::array<std::vector<GraphId>, kPrices> between;
    for (GraphId e = 0; e < dual.graph.edge_count(); ++e) {
        const auto [a, b] = dual.graph.ends[e];
        if (set[e] != 0) assign(e, FacetRole::strip);
        if (strips.of[a] != strips.of[b]) between[price_of(complex, dual.facet_of[e])].push_back(e);
    }
    UnionFind joined(strips.count());
    std::vector<std::uint8_t> carries(complex.cell_count(), 0);
    for (const bool fresh : {true, false}) {
        for (const std::vector<GraphId>& edges : between) {
            for (const GraphId e : edges) {
                const auto [a, b] = dual.graph.ends[e];
                if (fresh && (carries[a] != 0 || carries[b] != 0)) continue;
                if (!joined.unite(strips.of[a], strips.of[b])) continue;
                assign(e, FacetRole::link);
                carries[a] = 1;
                carries[b] = 1;
                ++strip.counts.links;
            }
        }
    }
    const Components& parts = dual.graph.parts;
    std::vector<GraphId> first_strip(parts.count, kNoGraphId);
    for (GraphId s = 0; s < strips.count(); ++s) {
        GraphId& best = first_strip[parts.of[strips.node[strips.first[s]]]];
        const auto open = [&](GraphId t) { return strips.shape[t] == StripShape::path; };
        if (best == kNoGraphId || (open(s) && !open(best)) ||
            (open(s) == open(best) && strips.size(s) > strips.size(best)))
            best = s;
    }
    strip.counts.components = parts.count;
    strip.counts.strips = parts.count;
    // Components are told apart by their lowest cells.
    std::vector<Id> lowest(parts.count, kNone), roots;
    for (GraphId n = 0; n < dual.graph.node_count(); ++n) {
        Id& cell = lowest[parts.of[n]];
        cell = std::min(cell, dual.cell_of[n]);
    }
    for (const GraphId s : first_strip) {
        roots.push_back(root_of(dual, strips, s));
        strip.counts.open_strips += strips.shape[s] == StripShape::path;
    }
    std::vector<GraphId> order(parts.count);
    std::iota(order.begin(), order.end(), GraphId{0});
    std::sort(order.begin(), order.end(),
              [&](GraphId a, GraphId b) { return lowest[a] < lowest[b]; });
    for (const GraphId part : order) strip.roots.push_back(roots[part]);
    return strip;
}

}  // namespace ravel
