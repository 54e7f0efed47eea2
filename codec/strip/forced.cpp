#include "strip/forced.h"

#include "graph/bound.h"
#include "strip/dual.h"

namespace ravel {

std::uint64_t forced_links(const Complex& complex, const Strip& strip) {
    if (strip.counts.links == 0) return 0;
    const Dual dual = make_dual(complex);
    EdgeSet set(dual.graph.edge_count(), 0);
    for (GraphId e = 0; e < set.size(); ++e)
        set[e] = strip.role[dual.facet_of[e]] == FacetRole::strip;
    return forced_links(dual.graph, set);
}

}  // namespace ravel
