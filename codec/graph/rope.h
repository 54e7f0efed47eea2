// A cyclic order of nodes that can be cut at a few places and put together anew.
#pragma once

#include <span>
#include <vector>

#include "graph/graph.h"

namespace ravel {

// The order is a list of runs through `nodes`, some backwards. Cutting and joining costs the number
// of runs, which `tidy` keeps low.
class Rope {
  public:
    // A stretch of the order: ranks [begin, end), backwards where `reversed`.
    struct Stretch {
        const Rope* rope = nullptr;
        GraphId begin = 0, end = 0;
        bool reversed = false;
    };

    Rope() = default;
    explicit Rope(std::span<const GraphId> nodes) : nodes_(nodes.begin(), nodes.end()) {
        start_anew();
    }

    GraphId size() const { return static_cast<GraphId>(nodes_.size()); }
    const std::vector<GraphId>& nodes() const { return nodes_; }

    // The rank in the order of the node at `place` in nodes().
    GraphId rank(GraphId place) const;

    // Becomes the stretches one after the other: all of its own ranks and those of other ropes,
    // whose nodes are appended. `place` (node -> place in its rope) follows.
    void join(std::span<const Stretch> stretches, std::vector<GraphId>& place);

  private:
    struct Run {
        GraphId begin = 0, end = 0;  // places
        GraphId rank = 0;            // of the first in the order
        bool reversed = false;
    };

    void start_anew();
    void index_runs();
    void tidy(std::vector<GraphId>& place);

    std::vector<GraphId> nodes_;
    std::vector<Run> runs_;          // in order
    std::vector<GraphId> by_place_;  // runs by their places
};

}  // namespace ravel
