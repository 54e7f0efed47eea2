// One edge per pair of glued facets; cells that share several facets get parallel edges.
// Cost: linear in facets.
#include "strip/dual.h"

#include <array>
#include <numeric>
#include <utility>

namespace ravel {

Dual make_dual(const Complex& complex, std::span<const Id> order) {
    Dual dual;
    const Id cells = complex.cell_count();
    const bool tets = complex.kind == CellKind::tet;
    dual.cell_of.assign(order.begin(), order.end());
    dual.node_of.resize(cells);
    for (Id n = 0; n < cells; ++n) dual.node_of[order[n]] = n;
    dual.edge_of.assign(complex.twin.size(), kNone);
    std::vector<std::array<GraphId, 2>> ends;
    ends.reserve(complex.twin.size() / 2);
    dual.facet_of.reserve(complex.twin.size() / 2);
    for (Id n = 0; n < cells; ++n) {
        for (Id f = complex.first[order[n]]; f < complex.first[order[n] + 1]; ++f) {
            const Id g = complex.twin[f];
            if (g == kNone) continue;
            const Id m = dual.node_of[tets ? g / 4 : complex.cell_of[g]];
            if (m < n) continue;
            const auto edge = static_cast<Id>(ends.size());
            dual.edge_of[f] = edge;
            dual.edge_of[g] = edge;
            dual.facet_of.push_back(f);
            ends.push_back({n, m});
        }
    }
    dual.graph = make_graph(cells, std::move(ends));
    return dual;
}

Dual make_dual(const Complex& complex) {
    std::vector<Id> order(complex.cell_count());
    std::iota(order.begin(), order.end(), Id{0});
    return make_dual(complex, order);
}

}  // namespace ravel
