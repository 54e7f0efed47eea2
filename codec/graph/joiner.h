// The strips of a 2-matching while they are joined to fewer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/ropes.h"
#include "graph/union_find.h"

namespace ravel {

// One edge of a ring that is in the set, from `tail` to `head`, and the next edge, that is not,
// from `head` to the next link's tail.
struct RingLink {
    GraphId in = 0, out = 0;
    GraphId tail = 0, head = 0;
};

// Knows which strip a node is on, and the order of every strip. A strip is named by one of those
// that the set fell into at first; a path counts as a cycle that is closed by no edge.
class StripJoiner {
  public:
    // `strips` are those of the set, which is changed in place. Linear.
    StripJoiner(const Graph& graph, EdgeSet& set, StripList strips);
    StripJoiner(const Graph& graph, EdgeSet& set)
        : StripJoiner(graph, set, list_strips(graph, set)) {}

    const Graph& graph() const { return graph_; }
    const StripList& strips() const { return strips_; }  // as they were at first
    bool in_set(GraphId edge) const { return set_[edge] != 0; }

    int degree(GraphId node) const {
        int degree = 0;
        for (const Arc& arc : graph_.at(node)) degree += set_[arc.edge];
        return degree;
    }

    GraphId strip_of(GraphId node) { return sets_.find(strips_.of[node]); }
    GraphId size(GraphId strip) { return sets_.size(strip); }
    GraphId rank(GraphId node) const { return ropes_.rank(node); }
    bool is_open(GraphId strip) { return open_[sets_.find(strip)] != 0; }
    // Does the strip hold more than half of its part?
    bool in_majority(GraphId strip) {
        return 2 * std::uint64_t{sets_.size(strip)} > part_size_[part_of(strip)];
    }
    GraphId part_of(GraphId strip) const {
        return graph_.parts.of[strips_.node[strips_.first[strip]]];
    }
    std::uint64_t strips_left() const { return strips_left_; }

    // Takes the ring's edges that are in the set out and the others in, where the strips it meets,
    // at least two and at most one of them open, become one by that. Logarithmic in the joins so
    // far for each edge.
    bool toggle(std::span<const RingLink> ring);

    // Joins the path that ends in `end` to the closed strip of `next`, its neighbour over `edge`;
    // gives the path's new end.
    GraphId absorb(GraphId end, GraphId edge, GraphId next);

  private:
    // Where a ring cuts a strip: between two neighbours in its order.
    struct Cut {
        GraphId strip = 0;
        GraphId rank = 0;      // of the node before the cut
        std::size_t link = 0;  // of the ring
        bool forward = false;  // the tail is before the cut
    };
    // From behind cut i to the next cut of its strip, cyclically.
    struct Segment {
        std::size_t cut;
        bool reversed;
    };

    bool place_cuts(std::span<const RingLink> ring);
    std::size_t next_cut(std::size_t cut) const;
    std::size_t previous_cut(std::size_t cut) const;
    bool follow_segments(std::size_t links);
    void add_stretches(const Segment& segment);
    void add_round(GraphId strip, GraphId cut, bool reversed);

    const Graph& graph_;
    EdgeSet& set_;
    const StripList strips_;
    std::vector<GraphId> part_size_;
    UnionFind sets_;
    std::vector<std::uint8_t> open_;  // set of strips -> 1 where it is a path
    Ropes ropes_;                     // by the name of the strip
    std::uint64_t strips_left_;
    std::vector<Cut> cuts_;
    std::vector<Segment> segments_;
    std::vector<Ropes::Stretch> stretches_;
};

}  // namespace ravel
