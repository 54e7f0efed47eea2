// One edge per pair of glued facets; cells that share several facets get parallel edges.
// Cost: linear in facets.
#include "strip/dual.h"

#include <array>
#include <utility>

namespace ravel {

Dual make_dual(const Complex& complex) {
    Dual dual;
    const auto facets = static_cast<Id>(complex.twin.size());
    dual.edge_of.assign(facets, kNone);
    std::vector<std::array<GraphId, 2>> ends;
    ends.reserve(facets / 2);
    dual.facet_of.reserve(facets / 2);
    for (Id f = 0; f < facets; ++f) {
        const Id g = complex.twin[f];
        if (g == kNone || g < f) continue;
        const auto edge = static_cast<Id>(ends.size());
        dual.edge_of[f] = edge;
        dual.edge_of[g] = edge;
        dual.facet_of.push_back(f);
        ends.push_back({complex.cell_of[f], complex.cell_of[g]});
    }
    dual.graph = make_graph(complex.cell_count(), std::move(ends));
    return dual;
}

}  // namespace ravel
