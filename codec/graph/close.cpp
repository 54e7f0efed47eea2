// Alternating walks between path ends, as in graph/augment [Petersen1891], grown from all ends at
// once: a breadth-first forest over states (node, hungry or full). Where the full state of a node
// is in one tree and the hungry state in another, the two walks to it make one walk between two
// ends; toggled, it closes a path or joins two. A node may also turn singleton: it gives away both
// its edges. Such steps wait until no others are left. Trees whose end is served grow no more; what
// they hold is free again in the next round.
// Cost: linear per round; a round that joins nothing is the last, and there are at most eight per
// price.
#include "graph/close.h"

#include <algorithm>
#include <utility>

namespace ravel {
namespace {

using State = GraphId;  // 2 * node + (1 where full)

constexpr int kMaxRounds = 8;  // per price; real meshes take one or two
constexpr int kMaxPrice = 3;   // singletons a walk may make, about

class Forest {
  public:
    Forest(const Graph& graph, EdgeSet& set)
        : graph_(graph),
          set_(set),
          degree_(degrees_in(graph, set)),
          parts_(graph.parts),
          ends_left_(parts_.count, 0),
          visits_(2 * std::size_t{graph.node_count()}),
          touched_(graph.edge_count(), 0),
          active_(parts_.count, 1),
          joined_(parts_.count, 0) {
        for (GraphId n = 0; n < graph.node_count(); ++n)
            if (degree_[n] == 1) ++ends_left_[parts_.of[n]];
    }

    // A part where a round joins nothing is done with at that price.
    void run(int price) {
        std::fill(active_.begin(), active_.end(), std::uint8_t{1});
        for (int round = 0; round < kMaxRounds && grow(price); ++round) {
            active_ = joined_;
            std::fill(joined_.begin(), joined_.end(), std::uint8_t{0});
        }
    }

  private:
    struct Visit {
        GraphId round = 0;
        State from = kNoGraphId;
        GraphId edge = kNoGraphId;
        GraphId root = kNoGraphId;
    };
    struct Step {
        State from, to;
        GraphId edge;
    };

    bool seen(State state) const { return visits_[state].round == round_; }
    bool served(GraphId root) const { return degree_[root] != 1; }

    // One forest over the active parts; true where it joined anything.
    bool grow(int most) {
        ++round_;
        any_ = false;
        most_ = most;
        queue_.clear();
        for (GraphId n = 0; n < graph_.node_count(); ++n) {
            const GraphId part = parts_.of[n];
            if (degree_[n] != 1 || active_[part] == 0 || (most > 0 && ends_left_[part] <= 2))
                continue;
            visits_[2 * n] = {round_, kNoGraphId, kNoGraphId, n};
            queue_.push_back(2 * n);
        }
        for (price_ = 0; !queue_.empty(); ++price_) {
            dear_.clear();
            for (std::size_t i = 0; i < queue_.size(); ++i) expand(queue_[i], price_ < most);
            queue_.clear();
            if (price_ == most) break;
            const std::vector<Step> steps = std::move(dear_);
            ++price_;
            for (const Step& step : steps) take(step);
            --price_;
        }
        return any_;
    }

    void expand(State state, bool may_pay) {
        const GraphId node = state / 2;
        if (served(visits_[state].root)) return;
        const bool full = state % 2 == 1;
        for (const Arc& arc : graph_.at(node)) {
            if (touched_[arc.edge] == round_) continue;
            const bool in = set_[arc.edge] != 0;
            if (in && full) take({state, 2 * arc.to, arc.edge});
            // A full singleton takes a second edge.
            if (!in && (!full || degree_[node] == 0)) take({state, 2 * arc.to + 1, arc.edge});
            // A hungry node gives away its other edge too.
            if (in && !full && may_pay && arc.edge != visits_[state].edge)
                dear_.push_back({state, 2 * arc.to, arc.edge});
        }
    }

    void take(const Step& step) {
        const GraphId root = visits_[step.from].root;
        if (served(root) || seen(step.to) || runs_back(step)) return;
        visits_[step.to] = {round_, step.from, step.edge, root};
        const State other = step.to ^ 1;
        if (seen(other) && visits_[other].root != root && !served(visits_[other].root) &&
            join(step.to, other))
            return;
        queue_.push_back(step.to);
    }

    // A walk reaches no state twice, so it can use an edge twice only in both directions. Free
    // rounds let no tree do so at all: that is faster and, measured, leaves fewer cycles to merge.
    bool runs_back(const Step& step) const {
        const State back = (step.from & ~State{1}) | (step.to & 1);
        if (!seen(back) || visits_[back].edge != step.edge ||
            visits_[back].root != visits_[step.from].root)
            return false;
        if (most_ == 0) return true;
        for (State s = step.from; s != kNoGraphId; s = visits_[s].from)
            if (visits_[s].edge == step.edge) return true;
        return false;
    }

    // Toggles the walks to both states, unless they share edges with each other or with one toggled
    // before.
    bool join(State a, State b) {
        GraphId& left = ends_left_[parts_.of[a / 2]];
        if (left <= 2 && price_ > 0) return false;
        walk_.clear();
        bool clean = true;
        for (State s : {a, b}) {
            for (; visits_[s].edge != kNoGraphId; s = visits_[s].from) {
                const GraphId e = visits_[s].edge;
                clean = clean && touched_[e] != round_;
                walk_.push_back(e);
                if (!clean) break;
                touched_[e] = round_;
            }
            if (!clean) break;
        }
        if (!clean) {
            walk_.pop_back();
            for (const GraphId e : walk_) touched_[e] = 0;
            return false;
        }
        for (const GraphId e : walk_) {
            const int change = set_[e] != 0 ? -1 : 1;
            set_[e] ^= 1;
            for (const GraphId node : graph_.ends[e])
                degree_[node] = static_cast<std::uint8_t>(degree_[node] + change);
        }
        left -= 2;
        joined_[parts_.of[a / 2]] = 1;
        any_ = true;
        return true;
    }

    const Graph& graph_;
    EdgeSet& set_;
    std::vector<std::uint8_t> degree_;
    const Components& parts_;
    std::vector<GraphId> ends_left_;
    std::vector<Visit> visits_;
    std::vector<GraphId> touched_;  // edge -> the round that toggled it last
    std::vector<State> queue_;
    std::vector<Step> dear_;
    std::vector<GraphId> walk_;
    std::vector<std::uint8_t> active_,
        joined_;  // part -> 1 where this round looks; where it joined
    GraphId round_ = 0;
    int price_ = 0, most_ = 0;
    bool any_ = false;
};

}  // namespace

EdgeSet join_ends(const Graph& graph, EdgeSet set) {
    Forest(graph, set).run(0);
    return set;
}

// Free walks all over before any that cost singletons.
EdgeSet close_paths(const Graph& graph, EdgeSet set) {
    Forest forest(graph, set);
    forest.run(0);
    forest.run(kMaxPrice);
    return set;
}

}  // namespace ravel
