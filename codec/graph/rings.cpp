// Generalises the paper's nodal processing [DiazGopi2005, 3.1], whose rings are fans meeting each
// strip once. This is the k-opt move of travelling salesmen [LinKernighan1973] with the number of
// tours in place of their length. Rings are searched depth first from the edges of strips that are
// not the majority of their part, short ones first.
// Cost: some hundreds of steps per edge of a small strip.
#include "graph/rings.h"

#include <algorithm>
#include <array>

namespace ravel {
namespace {

constexpr GraphId kSpareNodes = 4096;  // small graphs may be searched to the end

class Search {
  public:
    Search(StripJoiner& joiner, const RingLimits& limits)
        : joiner_(joiner), graph_(joiner.graph()), strips_(joiner.strips()), limits_(limits) {}

    std::uint64_t run() {
        const std::uint64_t before = joiner_.strips_left();
        steps_left_ = limits_.steps_per_node * (graph_.node_count() + std::uint64_t{kSpareNodes});
        const int most = std::min(limits_.edges_in, kMaxRingEdges);
        for (int pass = 0; pass < limits_.passes; ++pass) {
            const std::uint64_t left = joiner_.strips_left();
            for (int edges = 2; edges <= most; ++edges)
                for (GraphId s = 0; s < strips_.count(); ++s) merge_strip(s, edges);
            if (joiner_.strips_left() == left) break;
        }
        return before - joiner_.strips_left();
    }

  private:
    // Tries rings of `edges` strip edges at every edge that the strip had at first and still has.
    void merge_strip(GraphId strip, int edges) {
        if (strips_.shape[strip] == StripShape::singleton || joiner_.in_majority(strip)) return;
        for (GraphId i = strips_.first[strip]; i < strips_.first[strip + 1]; ++i) {
            const GraphId e = strips_.edge[i];
            if (e == kNoGraphId || !joiner_.in_set(e)) continue;
            if (find_ring(e, static_cast<std::size_t>(edges))) return;
        }
    }

    // Depth first over rings through `first`; level 2k chooses the edge out of head k, level 2k + 1
    // the strip edge from tail k + 1.
    bool find_ring(GraphId first, std::size_t edges) {
        std::array<GraphId, 2 * kMaxRingEdges> next{};
        ring_[0] = {first, kNoGraphId, graph_.ends[first][0], graph_.ends[first][1]};
        const std::size_t last = 2 * (edges - 1);
        std::size_t level = 0;
        next[0] = graph_.first[ring_[0].head];
        while (steps_left_ > 0) {
            --steps_left_;
            const std::size_t k = level / 2;
            RingLink& link = ring_[k];
            const bool out = level % 2 == 0;
            const GraphId node = out ? link.head : ring_[k + 1].tail;
            GraphId& i = next[level];
            if (i == graph_.first[node + 1]) {
                if (level == 0) return false;
                --level;
                continue;
            }
            const Arc arc = graph_.arcs[i++];
            if (joiner_.in_set(arc.edge) == out || used(arc.edge, k, out)) continue;
            if (!out) {
                ring_[k + 1].in = arc.edge;
                ring_[k + 1].head = arc.to;
            } else if (level == last) {
                if (arc.to != ring_[0].tail) continue;
                link.out = arc.edge;
                if (joiner_.toggle({ring_.data(), edges})) return true;
                continue;
            } else {
                link.out = arc.edge;
                ring_[k + 1].tail = arc.to;
            }
            ++level;
            next[level] = graph_.first[out ? ring_[k + 1].tail : ring_[k + 1].head];
        }
        return false;
    }

    bool used(GraphId edge, std::size_t k, bool out) const {
        for (std::size_t i = 0; i <= k; ++i)
            if (out ? i < k && ring_[i].out == edge : ring_[i].in == edge) return true;
        return false;
    }

    StripJoiner& joiner_;
    const Graph& graph_;
    const StripList& strips_;
    const RingLimits limits_;
    std::uint64_t steps_left_ = 0;
    std::array<RingLink, kMaxRingEdges> ring_{};
};

}  // namespace

std::uint64_t merge_rings(StripJoiner& joiner, const RingLimits& limits) {
    return Search(joiner, limits).run();
}

}  // namespace ravel
