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

}  // namespace

Strip link_strips(const Complex& complex, const Dual& dual, StripJoiner& joiner) {
    const Graph& graph = dual.graph;
    const Components& parts = graph.parts;
    Strip strip;
    strip.counts.components = parts.count;
    strip.counts.strips = parts.count;
    strip.role.assign(complex.twin.size(), FacetRole::none);
    for (Id f = 0; f < strip.role.size(); ++f)
        if (dual.edge_of[f] != kNone && joiner.in_set(dual.edge_of[f]))
            strip.role[f] = FacetRole::strip;

    if (joiner.strips_left() > parts.count) {
        std::array<std::vector<GraphId>, kPrices> between;
        for (GraphId e = 0; e < graph.edge_count(); ++e) {
            const auto [a, b] = graph.ends[e];
            if (joiner.strip_of(a) != joiner.strip_of(b))
                between[price_of(complex, dual.facet_of[e])].push_back(e);
        }
        UnionFind joined(joiner.strips().count());
        std::vector<std::uint8_t> carries(complex.cell_count(), 0);
        for (const bool fresh : {true, false}) {
            for (const std::vector<GraphId>& edges : between) {
                for (const GraphId e : edges) {
                    const auto [a, b] = graph.ends[e];
                    if (fresh && (carries[a] != 0 || carries[b] != 0)) continue;
                    if (!joined.unite(joiner.strip_of(a), joiner.strip_of(b))) continue;
                    const Id f = dual.facet_of[e];
                    strip.role[f] = strip.role[complex.twin[f]] = FacetRole::link;
                    carries[a] = 1;
                    carries[b] = 1;
                    ++strip.counts.links;
                }
            }
        }
    }

    // The strip that each part starts with: an open one, else the largest, the first of these.
    std::vector<GraphId> start(parts.count, kNoGraphId);
    for (GraphId s = 0; s < joiner.strips().count(); ++s) {
        if (joiner.strip_of(joiner.strips().node[joiner.strips().first[s]]) != s) continue;
        GraphId& best = start[joiner.part_of(s)];
        if (best == kNoGraphId || (joiner.is_open(s) && !joiner.is_open(best)) ||
            (joiner.is_open(s) == joiner.is_open(best) && joiner.size(s) > joiner.size(best)))
            best = s;
    }
    // Its lowest cell, of a path its lower end. Components are told apart by their lowest cells.
    std::vector<Id> root(parts.count, kNone), lowest(parts.count, kNone);
    for (GraphId n = 0; n < graph.node_count(); ++n) {
        const GraphId part = parts.of[n], s = start[part];
        const Id cell = dual.cell_of[n];
        lowest[part] = std::min(lowest[part], cell);
        if (joiner.strip_of(n) != s || (joiner.is_open(s) && joiner.degree(n) != 1)) continue;
        root[part] = std::min(root[part], cell);
    }
    for (const GraphId s : start) strip.counts.open_strips += joiner.is_open(s);
    std::vector<GraphId> order(parts.count);
    std::iota(order.begin(), order.end(), GraphId{0});
    std::sort(order.begin(), order.end(),
              [&](GraphId a, GraphId b) { return lowest[a] < lowest[b]; });
    for (const GraphId part : order) strip.roots.push_back(root[part]);
    return strip;
}

}  // namespace ravel
