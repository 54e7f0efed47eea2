// The two-pass graph matching algorithm [DiazGopi2005, 2.2.1]: a maximum matching, its edges taken
// away, another maximum matching; both together.
// Cost: two matchings.
#include "graph/two_pass.h"

#include <utility>

#include "graph/matching.h"

namespace ravel {

TwoPass two_pass(const Graph& graph) {
    TwoPass result;
    Matching first = max_matching(graph);
    result.set = std::move(first.edges);
    result.unmatched_first = first.unmatched;
    std::vector<std::array<GraphId, 2>> ends;
    std::vector<GraphId> original;
    ends.reserve(graph.edge_count());
    original.reserve(graph.edge_count());
    for (GraphId e = 0; e < graph.edge_count(); ++e) {
        if (result.set[e] != 0) continue;
        ends.push_back(graph.ends[e]);
        original.push_back(e);
    }
    const Graph rest = make_graph(graph.node_count(), std::move(ends));
    const Matching second = max_matching(rest);
    result.unmatched_second = second.unmatched;
    for (GraphId e = 0; e < rest.edge_count(); ++e)
        if (second.edges[e] != 0) result.set[original[e]] = 1;
    return result;
}

}  // namespace ravel
