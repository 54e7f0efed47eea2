// Generalises the paper's nodal processing [DiazGopi2005, 3.1], whose rings are fans meeting each
// strip once. A ring takes edges from strips, which fall into segments, and joins their ends by its
// other edges; whether one strip comes out depends on the order and direction in which the strips
// run through the ring. Ropes know both. This is the k-opt move of travelling salesmen
// [LinKernighan1973] with the number of tours in place of their length. Rings are searched depth
// first from the edges of strips that are not the majority of their part, short ones first.
// Cost: some hundreds of steps per edge of a small strip; the majority is touched once per pass and
// now and then by a rope.
#include "graph/rings.h"

#include <algorithm>
#include <array>
#include <utility>

#include "graph/cycles.h"
#include "graph/rope.h"
#include "graph/union_find.h"

namespace ravel {
namespace {

constexpr GraphId kSpareNodes = 4096;  // small graphs may be searched to the end

// Runs tail -> head along each edge `in` of the set, then along `out` to the next tail.
struct Ring {
    struct Link {
        GraphId in = 0, out = 0;
        GraphId tail = 0, head = 0;
    };
    std::array<Link, kMaxRingEdges> links{};
    int size = 0;
};

// Where a ring cuts a strip: between two neighbours in its rope's order.
struct Cut {
    GraphId strip = 0;
    GraphId rank = 0;      // of the node before the cut
    int link = 0;          // of the ring
    bool forward = false;  // the tail is before the cut
};

class Merger {
  public:
    Merger(const Graph& graph, EdgeSet& set, const RingLimits& limits)
        : graph_(graph),
          set_(set),
          limits_(limits),
          strips_(list_strips(graph, set)),
          parts_(graph.parts),
          part_size_(parts_.count, 0),
          sets_(strips_.count()),
          open_(strips_.count(), 0),
          ropes_(strips_.count()),
          place_(graph.node_count(), 0) {
        for (GraphId node = 0; node < graph.node_count(); ++node) ++part_size_[parts_.of[node]];
        for (GraphId s = 0; s < strips_.count(); ++s) {
            open_[s] = strips_.shape[s] == StripShape::path;
            sets_.weigh(s, strips_.size(s));
            if (part_size_[parts_.of[strips_.node[strips_.first[s]]]] == strips_.size(s)) continue;
            ropes_[s] = Rope({strips_.node.data() + strips_.first[s], strips_.size(s)});
            for (GraphId i = 0; i < strips_.size(s); ++i)
                place_[strips_.node[strips_.first[s] + i]] = i;
        }
    }

    std::uint64_t run() {
        std::uint64_t total = 0;
        steps_left_ = limits_.steps_per_node * (graph_.node_count() + std::uint64_t{kSpareNodes});
        const int most = std::min(limits_.edges_in, kMaxRingEdges);
        for (int pass = 0; pass < limits_.passes; ++pass) {
            std::uint64_t merges = 0;
            for (int edges = 2; edges <= most; ++edges)
                for (GraphId s = 0; s < strips_.count(); ++s)
                    merges += static_cast<std::uint64_t>(merge_strip(s, edges));
            total += merges;
            if (merges == 0) break;
        }
        return total;
    }

  private:
    bool in_majority(GraphId strip) {
        const GraphId part = parts_.of[strips_.node[strips_.first[strip]]];
        return 2 * std::uint64_t{sets_.size(strip)} > part_size_[part];
    }

    // Tries rings of `edges` strip edges at every edge that the strip had at first and still has.
    int merge_strip(GraphId strip, int edges) {
        if (strips_.shape[strip] == StripShape::singleton || in_majority(strip)) return 0;
        for (GraphId i = strips_.first[strip]; i < strips_.first[strip + 1]; ++i) {
            const GraphId e = strips_.edge[i];
            if (e == kNoGraphId || set_[e] == 0) continue;
            if (find_ring(e, edges)) return 1;
        }
        return 0;
    }

    // Depth first over rings through `first`; level 2k chooses the edge out of head k, level 2k + 1
    // the strip edge from tail k + 1.
    bool find_ring(GraphId first, int edges) {
        std::array<GraphId, 2 * kMaxRingEdges> next{};
        ring_.size = edges;
        ring_.links[0] = {first, kNoGraphId, graph_.ends[first][0], graph_.ends[first][1]};
        const int last = 2 * (edges - 1);
        int level = 0;
        next[0] = graph_.first[ring_.links[0].head];
        while (level >= 0 && steps_left_ > 0) {
            --steps_left_;
            const auto k = static_cast<std::size_t>(level / 2);
            Ring::Link& link = ring_.links[k];
            const bool out = level % 2 == 0;
            const GraphId node = out ? link.head : ring_.links[k + 1].tail;
            GraphId& i = next[static_cast<std::size_t>(level)];
            if (i == graph_.first[node + 1]) {
                --level;
                continue;
            }
            const Arc arc = graph_.arcs[i++];
            if ((set_[arc.edge] == 0) != out || used(arc.edge, k, out)) continue;
            if (!out) {
                ring_.links[k + 1].in = arc.edge;
                ring_.links[k + 1].head = arc.to;
            } else if (level == last) {
                if (arc.to != ring_.links[0].tail) continue;
                link.out = arc.edge;
                if (toggle()) return true;
                continue;
            } else {
                link.out = arc.edge;
                ring_.links[k + 1].tail = arc.to;
            }
            ++level;
            next[static_cast<std::size_t>(level)] =
                graph_.first[out ? ring_.links[k + 1].tail : ring_.links[k + 1].head];
        }
        return false;
    }

    bool used(GraphId edge, std::size_t k, bool out) const {
        for (std::size_t i = 0; i <= k; ++i)
            if (out ? i < k && ring_.links[i].out == edge : ring_.links[i].in == edge) return true;
        return false;
    }

    // Cuts by strip and rank; false where two strips are paths or all cuts are of one strip.
    bool place_cuts() {
        cuts_.clear();
        int paths = 0;
        bool many = false;
        for (int i = 0; i < ring_.size; ++i) {
            const Ring::Link& link = ring_.links[static_cast<std::size_t>(i)];
            const GraphId strip = sets_.find(strips_.of[link.tail]);
            const Rope& rope = ropes_[strip];
            const GraphId tail = rope.rank(place_[link.tail]), head = rope.rank(place_[link.head]);
            const bool forward = (tail + 1) % rope.size() == head;
            const auto same = [&](const Cut& cut) { return cut.strip == strip; };
            if (std::none_of(cuts_.begin(), cuts_.end(), same)) paths += open_[strip];
            cuts_.push_back({strip, forward ? tail : head, i, forward});
            many = many || strip != cuts_[0].strip;
        }
        if (!many || paths > 1) return false;
        std::sort(cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) {
            return a.strip != b.strip ? a.strip < b.strip : a.rank < b.rank;
        });
        for (std::size_t i = 1; i < cuts_.size(); ++i)
            if (cuts_[i].strip == cuts_[i - 1].strip && cuts_[i].rank == cuts_[i - 1].rank)
                return false;
        return true;
    }

    // Segment i runs from behind cut i to the next cut of its strip, cyclically.
    std::size_t next_cut(std::size_t i) const {
        if (i + 1 < cuts_.size() && cuts_[i + 1].strip == cuts_[i].strip) return i + 1;
        while (i > 0 && cuts_[i - 1].strip == cuts_[i].strip) --i;
        return i;
    }
    std::size_t previous_cut(std::size_t i) const {
        if (i > 0 && cuts_[i - 1].strip == cuts_[i].strip) return i - 1;
        while (i + 1 < cuts_.size() && cuts_[i + 1].strip == cuts_[i].strip) ++i;
        return i;
    }

    struct Walked {
        std::size_t segment;
        bool reversed;
    };

    // Follows segments and out edges from segment 0; true where that takes in all of them.
    bool follow_segments() {
        walked_.clear();
        std::size_t segment = 0;
        bool reversed = false;
        do {
            walked_.push_back({segment, reversed});
            // Leave the segment at a side of a cut: the node before it, or behind it when running
            // backwards.
            const Cut& cut = cuts_[reversed ? segment : next_cut(segment)];
            const bool at_tail = cut.forward != reversed;
            const int link = (cut.link + (at_tail ? ring_.size - 1 : 1)) % ring_.size;
            std::size_t other = 0;
            while (cuts_[other].link != link) ++other;
            // From a tail the out edge leads to the last head, from a head to the next tail.
            const bool behind = cuts_[other].forward == at_tail;
            segment = behind ? other : previous_cut(other);
            reversed = !behind;
        } while (segment != 0 && walked_.size() <= cuts_.size());
        return !reversed && walked_.size() == cuts_.size();
    }

    bool toggle() {
        if (!place_cuts() || !follow_segments()) return false;
        GraphId largest = cuts_[0].strip;
        for (const Cut& cut : cuts_)
            if (ropes_[cut.strip].size() > ropes_[largest].size()) largest = cut.strip;
        stretches_.clear();
        for (const Walked& walked : walked_) add_stretches(walked);
        ropes_[largest].join(stretches_, place_);
        bool open = false;
        for (const Cut& cut : cuts_) open = open || open_[cut.strip] != 0;
        for (const Cut& cut : cuts_) sets_.unite(largest, cut.strip);
        for (const Cut& cut : cuts_)
            if (cut.strip != largest) ropes_[cut.strip] = Rope();
        const GraphId root = sets_.find(largest);
        if (root != largest) std::swap(ropes_[root], ropes_[largest]);
        open_[root] = open;
        for (int i = 0; i < ring_.size; ++i) {
            set_[ring_.links[static_cast<std::size_t>(i)].in] = 0;
            set_[ring_.links[static_cast<std::size_t>(i)].out] = 1;
        }
        return true;
    }

    // Segments that run past the end of their rope's order are two stretches.
    void add_stretches(const Walked& walked) {
        const Cut& cut = cuts_[walked.segment];
        const Rope* rope = &ropes_[cut.strip];
        const GraphId begin = cut.rank + 1, end = cuts_[next_cut(walked.segment)].rank + 1;
        if (begin < end) {
            stretches_.push_back({rope, begin, end, walked.reversed});
            return;
        }
        const Rope::Stretch tail{rope, begin, rope->size(), walked.reversed};
        const Rope::Stretch start{rope, 0, end, walked.reversed};
        stretches_.push_back(walked.reversed ? start : tail);
        stretches_.push_back(walked.reversed ? tail : start);
    }

    const Graph& graph_;
    EdgeSet& set_;
    const RingLimits& limits_;
    const StripList strips_;
    const Components& parts_;
    std::uint64_t steps_left_ = 0;
    std::vector<GraphId> part_size_;
    UnionFind sets_;
    std::vector<std::uint8_t> open_;
    std::vector<Rope> ropes_;     // set of strips -> order
    std::vector<GraphId> place_;  // node -> place in its rope
    Ring ring_;
    std::vector<Cut> cuts_;
    std::vector<Walked> walked_;
    std::vector<Rope::Stretch> stretches_;
};

}  // namespace

RingMerge merge_rings(const Graph& graph, EdgeSet set, const RingLimits& limits) {
    RingMerge merged{std::move(set), 0};
    merged.merges = Merger(graph, merged.set, limits).run();
    return merged;
}

}  // namespace ravel
