// One edge per pair of glued facets; cells that share several facets get parallel edges. Edges come
// in the order of their lower nodes, so the rows of the graph fill in order as well. Where each
// node but the first of a part has a lower neighbour, as along a walk, edges also carry the numbers
// of parts from node to node; else the parts are searched for. Cost: linear in facets.
#include "strip/dual.h"

#include <array>
#include <numeric>
#include <utility>

namespace ravel {
namespace {

constexpr Id kAhead = 12;  // cells, whose neighbours are fetched early

}  // namespace

Dual make_dual(const Complex& complex, std::span<const Id> order) {
    Dual dual;
    const Id cells = complex.cell_count();
    const bool tets = complex.kind == CellKind::tet;
    const auto first = [&](Id cell) { return tets ? 4 * cell : complex.first[cell]; };
    const auto cell_of = [&](Id facet) { return tets ? facet / 4 : complex.cell_of[facet]; };
    dual.cell_of.assign(order.begin(), order.end());
    dual.node_of.resize(cells);
    dual.edge_of.assign(complex.twin.size(), kNone);
    Graph& graph = dual.graph;
    graph.first.assign(std::size_t{cells} + 1, 0);
    for (Id n = 0; n < cells; ++n) {
        if (n + kAhead < cells) __builtin_prefetch(&complex.twin[first(order[n + kAhead])]);
        dual.node_of[order[n]] = n;
        Id degree = 0;
        for (Id f = first(order[n]); f < first(order[n] + 1); ++f)
            degree += complex.twin[f] != kNone;
        graph.first[n + 1] = graph.first[n] + degree;
    }
    graph.arcs.resize(graph.first.back());
    graph.ends.reserve(graph.arcs.size() / 2);
    dual.facet_of.reserve(graph.arcs.size() / 2);
    std::vector<GraphId> fill(graph.first.begin(), graph.first.end() - 1);
    Components& parts = graph.parts;
    parts.of.assign(cells, kNoGraphId);
    bool carried = true;
    for (Id n = 0; n < cells; ++n) {
        if (n + 2 * kAhead < cells) {
            __builtin_prefetch(&complex.twin[first(order[n + 2 * kAhead])]);
            const Id next = order[n + kAhead];
            for (Id f = first(next); f < first(next + 1); ++f) {
                if (complex.twin[f] == kNone) continue;
                __builtin_prefetch(&dual.node_of[cell_of(complex.twin[f])]);
                __builtin_prefetch(&dual.edge_of[complex.twin[f]], 1);
            }
        }
        if (parts.of[n] == kNoGraphId) parts.of[n] = parts.count++;
        for (Id f = first(order[n]); f < first(order[n] + 1); ++f) {
            const Id g = complex.twin[f];
            if (g == kNone) continue;
            const Id m = dual.node_of[cell_of(g)];
            if (m < n) continue;
            const GraphId edge = graph.edge_count();
            dual.edge_of[f] = edge;
            dual.edge_of[g] = edge;
            dual.facet_of.push_back(f);
            graph.ends.push_back({n, m});
            graph.arcs[fill[n]++] = {m, edge};
            graph.arcs[fill[m]++] = {n, edge};
            carried = carried && (parts.of[m] == kNoGraphId || parts.of[m] == parts.of[n]);
            parts.of[m] = parts.of[n];
        }
    }
    if (!carried) parts = find_components(graph);
    return dual;
}

Dual make_dual(const Complex& complex) {
    std::vector<Id> order(complex.cell_count());
    std::iota(order.begin(), order.end(), Id{0});
    return make_dual(complex, order);
}

}  // namespace ravel
