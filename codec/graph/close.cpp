// Alternating walks between path ends, as in graph/augment [Petersen1891], grown from all ends at
// once: a breadth-first forest over states (node, hungry or full). Where the full state of a node
// is in one tree and the hungry state in another, the two walks to it make one walk between two
// ends; toggled, it closes a path or joins two. A node may also turn singleton: it gives away both
// its edges. Such steps wait until no others are left. Trees whose end is served grow no more, and
// what they hold is free. A round ends when only an eighth of its trees is left: the few grow
// round what the many held, and reach each other sooner from a new start.
// Cost: linear per round, and most rounds see a part of the graph only; the number of rounds grows
// with the logarithm of that of the ends, and is bounded.
#include "graph/close.h"

#include <algorithm>
#include <utility>

#include "graph/bits.h"

namespace ravel {
namespace {

using State = GraphId;  // 2 * node + (1 where full)

constexpr int kMaxRounds = 24;     // per price; real meshes take three to ten
constexpr std::size_t kFewer = 8;  // measured: 4 and 16 take a third longer
constexpr std::size_t kAhead = 8;  // states between two fetches
constexpr int kMaxPrice = 3;       // singletons a walk may make, about

class Forest {
  public:
    // Walks start at nodes of fewer than `most` edges, but not fewer than `least`. Where those of
    // no edge are among them, paths may be made.
    Forest(const Graph& graph, EdgeSet& set, int least, int most)
        : graph_(graph),
          set_(set),
          least_(static_cast<std::uint8_t>(least)),
          full_(static_cast<std::uint8_t>(most)),
          in_(graph.edge_count()),
          touched_(graph.edge_count()),
          degree_(degrees_in(graph, set)),
          parts_(graph.parts),
          ends_left_(parts_.count, 0),
          active_(parts_.count, 1),
          joined_(parts_.count, 0),
          reached_(2 * std::size_t{graph.node_count()}) {
        for (GraphId e = 0; e < graph.edge_count(); ++e)
            if (set[e] != 0) in_.set(e);
        for (GraphId n = 0; n < graph.node_count(); ++n)
            if (degree_[n] == 1) ++ends_left_[parts_.of[n]];
    }

    // A part where a round joins nothing is done with at that price.
    void run(int price) {
        std::fill(active_.begin(), active_.end(), std::uint8_t{1});
        for (int round = 0; round < kMaxRounds && grow(price); ++round) {
            // Only who has had the time to join and did not is done with.
            if (stopped_) continue;
            active_ = joined_;
            std::fill(joined_.begin(), joined_.end(), std::uint8_t{0});
        }
    }

  private:
    static constexpr GraphId kMostEdge = kNoGraphId / 2;

    // How a state was reached. Steps change from hungry to full or back, unless `dear`.
    struct Visit {
        GraphId edge : 31 = 0;
        GraphId dear : 1 = 0;
        GraphId tree = 0;
    };
    struct Item {
        State state;
        GraphId tree;
    };
    struct Step {
        Item from;
        State to;
        GraphId edge;
    };

    bool is_root(State state, GraphId tree) const { return root_[tree] == state; }
    State from(State state) const {
        const Visit& visit = visits_[state];
        return 2 * graph_.other(visit.edge, state / 2) + ((state ^ visit.dear ^ 1) & 1);
    }
    // What trees hold whose end is served is free.
    bool held(State state) const { return reached_[state] && alive_[visits_[state].tree] != 0; }

    // One forest over the active parts; true where it joined anything.
    bool grow(int most) {
        most_ = most;
        any_ = false;
        stopped_ = false;
        plant();
        for (price_ = 0; !queue_.empty(); ++price_) {
            dear_.clear();
            drain();
            if (price_ == most_) break;
            const std::vector<Step> steps = std::move(dear_);
            ++price_;
            for (const Step& step : steps)
                if (alive_[step.from.tree] != 0) take(step);
            --price_;
        }
        for (const GraphId e : toggled_) {
            touched_.clear(e);
            set_[e] = in_[e];
        }
        toggled_.clear();
        return any_;
    }

    void plant() {
        root_.clear();
        queue_.clear();
        for (GraphId n = 0; n < graph_.node_count(); ++n) {
            const GraphId part = parts_.of[n];
            if (degree_[n] == full_ || degree_[n] < least_ || active_[part] == 0) continue;
            if (most_ > 0 && ends_left_[part] <= 2) continue;
            root_.push_back(2 * n);
        }
        alive_.assign(root_.size(), 1);
        trees_left_ = root_.size();
        enough_ = std::max<std::size_t>(2, most_ == 0 ? trees_left_ / kFewer : 0);
        if (trees_left_ < 2) return;
        visits_.resize(2 * std::size_t{graph_.node_count()});
        reached_.clear_all();
        for (GraphId tree = 0; tree < root_.size(); ++tree) {
            reached_.set(root_[tree]);
            visits_[root_[tree]].tree = tree;
            queue_.push_back({root_[tree], tree});
        }
    }

    // Grows trees until none can, or so few are left that starting anew is cheaper: old trees have
    // grown round what served ones held. States are all over the graph: what the next ones are to
    // look at is fetched while this one is looked at; rows after where they start, the states they
    // lead to after rows.
    void drain() {
        for (std::size_t i = 0; i < queue_.size(); ++i) {
            if (trees_left_ < enough_) {
                stopped_ = true;
                break;
            }
            if (i + 3 * kAhead < queue_.size()) {
                __builtin_prefetch(&graph_.first[queue_[i + 3 * kAhead].state / 2]);
                const State row = queue_[i + 2 * kAhead].state, next = queue_[i + kAhead].state;
                __builtin_prefetch(graph_.arcs.data() + graph_.first[row / 2]);
                __builtin_prefetch(graph_.arcs.data() + graph_.first[row / 2 + 1] - 1);
                const bool full = next % 2 == 1;
                for (const Arc& arc : graph_.at(next / 2))
                    if (in_[arc.edge] == full) __builtin_prefetch(&visits_[2 * arc.to]);
            }
            expand(queue_[i]);
        }
        queue_.clear();
    }

    void expand(const Item item) {
        const GraphId node = item.state / 2;
        const bool full = item.state % 2 == 1;
        for (const Arc& arc : graph_.at(node)) {
            if (alive_[item.tree] == 0) return;
            if (touched_[arc.edge]) continue;
            if (in_[arc.edge]) {
                if (full) {
                    take({item, 2 * arc.to, arc.edge});
                } else if (price_ < most_ && (is_root(item.state, item.tree) ||
                                              arc.edge != visits_[item.state].edge)) {
                    // A hungry node gives away its other edge too.
                    dear_.push_back({item, 2 * arc.to, arc.edge});
                }
            } else if (!full ||
                       (degree_[node] + 2 <= full_ && !is_root(item.state ^ 1, item.tree))) {
                // A full singleton takes a second edge.
                take({item, 2 * arc.to + 1, arc.edge});
            }
        }
    }

    void take(const Step& step) {
        const GraphId tree = step.from.tree;
        if (held(step.to) || runs_back(step)) return;
        reached_.set(step.to);
        visits_[step.to] = {step.edge & kMostEdge, (step.from.state ^ step.to ^ 1) & 1, tree};
        const State other = step.to ^ 1;
        if (held(other) && visits_[other].tree != tree && join(step.to, other)) return;
        queue_.push_back({step.to, tree});
    }

    // A walk reaches no state twice, so it can use an edge twice only in both directions. Free
    // rounds let no tree do so at all: that is faster and, measured, leaves fewer cycles to merge.
    bool runs_back(const Step& step) const {
        const State back = (step.from.state & ~State{1}) | (step.to & 1);
        const GraphId tree = step.from.tree;
        if (!reached_[back] || visits_[back].tree != tree || is_root(back, tree) ||
            visits_[back].edge != step.edge)
            return false;
        if (most_ == 0) return true;
        for (State s = step.from.state; !is_root(s, tree); s = from(s))
            if (visits_[s].edge == step.edge) return true;
        return false;
    }

    // Toggles the walks to both states, unless what they rest on has changed: they must share no
    // edges with each other or with one toggled before.
    bool join(State a, State b) {
        GraphId& left = ends_left_[parts_.of[a / 2]];
        if (left <= 2 && price_ > 0) return false;
        const std::size_t before = toggled_.size();
        for (State s : {a, b}) {
            for (const GraphId tree = visits_[s].tree; !is_root(s, tree); s = from(s)) {
                const GraphId e = visits_[s].edge;
                // A singleton that takes two edges on the walk may have got one elsewhere.
                const bool two = visits_[s].dear == 1 && s % 2 == 1;
                if (touched_[e] || (two && degree_[from(s) / 2] + 2 > full_)) {
                    for (; toggled_.size() > before; toggled_.pop_back())
                        touched_.clear(toggled_.back());
                    return false;
                }
                touched_.set(e);
                toggled_.push_back(e);
            }
        }
        for (std::size_t i = before; i < toggled_.size(); ++i) {
            const GraphId e = toggled_[i];
            const int change = in_[e] ? -1 : 1;
            in_.flip(e);
            for (const GraphId node : graph_.ends[e])
                degree_[node] = static_cast<std::uint8_t>(degree_[node] + change);
        }
        for (const State s : {a, b}) {
            const GraphId tree = visits_[s].tree;
            alive_[tree] = 0;
            // A singleton is an end now.
            if (degree_[root_[tree] / 2] == 1)
                ++left;
            else
                --left;
        }
        trees_left_ -= 2;
        joined_[parts_.of[a / 2]] = 1;
        any_ = true;
        return true;
    }

    const Graph& graph_;
    EdgeSet& set_;
    const std::uint8_t least_, full_;  // degrees
    Bits in_, touched_;                // edges in the set; those that this round has toggled
    std::vector<std::uint8_t> degree_;
    const Components& parts_;
    std::vector<GraphId> ends_left_;
    std::vector<Visit> visits_;  // state
    std::vector<State> root_;    // tree
    std::vector<std::uint8_t> alive_;
    std::vector<Item> queue_;
    std::vector<Step> dear_;
    std::vector<GraphId> toggled_;
    std::vector<std::uint8_t> active_;  // part -> 1 where this round looks
    std::vector<std::uint8_t> joined_;  // part -> 1 where rounds joined
    Bits reached_;                      // states that have a visit of this round
    std::size_t trees_left_ = 0;        // whose end is not served
    std::size_t enough_ = 0;            // a round stops below that
    int price_ = 0, most_ = 0;
    bool any_ = false, stopped_ = false;
};

}  // namespace

EdgeSet join_ends(const Graph& graph, EdgeSet set, int most) {
    Forest(graph, set, 0, most).run(0);
    return set;
}

// Free walks all over before any that cost singletons.
EdgeSet close_paths(const Graph& graph, EdgeSet set) {
    Forest forest(graph, set, 1, 2);
    forest.run(0);
    forest.run(kMaxPrice);
    return set;
}

}  // namespace ravel
