// The orders of many strips, which can be cut at a few places and put together anew.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "graph/cycles.h"

namespace ravel {

// Rope s starts as strip s. A rope is a balanced tree of runs through the nodes as the strips list
// them, some backwards: finding a node's rank takes time logarithmic in the number of runs, and so
// does cutting and joining, per stretch.
class Ropes {
  public:
    // A stretch of a rope: ranks [begin, end), backwards where `reversed`.
    struct Stretch {
        GraphId rope = 0;
        GraphId begin = 0, end = 0;
        bool reversed = false;
    };

    // Behind those of the strips come `extra` ropes of one node each, numbered behind the strips'.
    explicit Ropes(const StripList& strips, GraphId extra = 0);

    GraphId size(GraphId rope) const { return root_[rope] == kNone ? 0 : runs_[root_[rope]].size; }

    // The rank of a node in the order of its rope.
    GraphId rank(GraphId node) const;
    GraphId node_at(GraphId rope, GraphId rank) const;

    // Rope `into` becomes the stretches one after the other: all that the ropes they are of hold.
    // The other ropes are empty then.
    void join(GraphId into, std::span<const Stretch> stretches);

  private:
    static constexpr GraphId kNone = kNoGraphId;

    // A run and, as a tree's root, all below it. Where the tree is `reversed`, it is seen from the
    // other end; a run that is `backwards` is so by itself.
    struct Run {
        GraphId begin = 0, end = 0;  // places in the strips' list
        GraphId left = kNone, right = kNone, up = kNone;
        GraphId size = 0;      // nodes of the tree
        GraphId priority = 0;  // no smaller than those below
        bool reversed = false, backwards = false;

        GraphId length() const { return end - begin; }
    };

    // Runs by their places, in short lists that are in order, too.
    class Index {
      public:
        void append(GraphId begin, GraphId run);
        void insert(GraphId begin, GraphId run);
        GraphId run_at(GraphId place) const;

      private:
        struct Entry {
            GraphId begin, run;
        };
        std::size_t list_of(GraphId place) const;

        std::vector<std::vector<Entry>> lists_;
        std::vector<GraphId> first_;  // where the first run of each list begins
    };

    struct Piece {
        GraphId stretch, root;
    };

    GraphId add_run(GraphId begin, GraphId end);
    GraphId size_of(GraphId run) const { return run == kNone ? 0 : runs_[run].size; }
    void update(GraphId run);
    void push_down(GraphId run);
    // The first `count` nodes of the tree, and the rest.
    std::pair<GraphId, GraphId> split(GraphId root, GraphId count);
    GraphId merge(GraphId a, GraphId b);

    std::vector<GraphId> node_;   // place -> node
    std::vector<GraphId> place_;  // node -> place
    std::vector<Run> runs_;
    std::vector<GraphId> root_;  // rope -> run
    Index index_;
    std::vector<Piece> pieces_;  // of the join at hand
};

}  // namespace ravel
