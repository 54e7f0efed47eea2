// Breadth-first search for alternating walks [Petersen1891, Berge1957], over states (node, hungry
// or full): hungry has lost an edge of the set and takes one from outside it, full has gained one
// and gives one away. A walk from a path end to another path end, toggled, adds one edge and
// changes no other degree. Walks may pass a node twice but no edge twice: a state is reached once,
// so only the same edge run backwards has to be looked for on the walk. That (no blossoms are
// shrunk) makes the result near-maximum.
// Cost: linear for short walks; a search gives up after `limits.visits` states.
#include "graph/augment.h"

#include <algorithm>

namespace ravel {
namespace {

// A state is 2 * node + (1 where full).
using State = GraphId;

struct Visit {
    GraphId stamp = 0;
    State from = kNoGraphId;
    GraphId edge = kNoGraphId;
};

enum class Goal : std::uint8_t { augment, extend };

class Repair {
  public:
    Repair(const Graph& graph, EdgeSet& set, Goal goal)
        : graph_(graph),
          set_(set),
          goal_(goal),
          degree_(degrees_in(graph, set)),
          visits_(2 * std::size_t{graph.node_count()}) {}

    int degree(GraphId node) const { return degree_[node]; }

    // The shortest walk from `start` met within `limit` states, toggled. Gives the node where the
    // walk ends, or kNoGraphId.
    GraphId search(GraphId start, GraphId limit) {
        ++stamp_;
        start_ = start;
        queue_.assign(1, 2 * start);
        visits_[2 * start] = {stamp_, kNoGraphId, kNoGraphId};
        for (std::size_t i = 0; i < queue_.size() && queue_.size() < limit; ++i)
            if (expand(queue_[i])) return finish(queue_[i]);
        return kNoGraphId;
    }

  private:
    struct Step {
        State from, to;
        GraphId edge;
    };

    bool seen(State state) const { return visits_[state].stamp == stamp_; }

    // The step's target is new and its edge is not on the walk already.
    bool allowed(const Step& step) const {
        if (seen(step.to)) return false;
        const State back = (step.from & ~State{1}) | (step.to & 1);
        if (!seen(back) || visits_[back].edge != step.edge) return true;
        for (State s = step.from; s != kNoGraphId; s = visits_[s].from)
            if (visits_[s].edge == step.edge) return false;
        return true;
    }

    bool may_end(GraphId node) const {
        switch (goal_) {
            case Goal::augment:
                return node == start_ ? degree_[node] == 0 : degree_[node] < 2;
            case Goal::extend:
                return degree_[node] == 0;
        }
        return false;
    }

    // True where the walk can end at the state.
    bool expand(State state) {
        const GraphId node = state / 2;
        const bool full = state % 2 == 1;
        if (full && may_end(node)) return true;
        for (const Arc& arc : graph_.at(node)) {
            if ((set_[arc.edge] != 0) != full) continue;
            const Step step{state, 2 * arc.to + (full ? 0 : 1), arc.edge};
            if (!allowed(step)) continue;
            visits_[step.to] = {stamp_, step.from, step.edge};
            queue_.push_back(step.to);
        }
        return false;
    }

    GraphId finish(State end) {
        for (State s = end; visits_[s].edge != kNoGraphId; s = visits_[s].from) {
            const GraphId e = visits_[s].edge;
            const int change = set_[e] != 0 ? -1 : 1;
            set_[e] ^= 1;
            for (const GraphId node : graph_.ends[e])
                degree_[node] = static_cast<std::uint8_t>(degree_[node] + change);
        }
        return end / 2;
    }

    const Graph& graph_;
    EdgeSet& set_;
    const Goal goal_;
    std::vector<std::uint8_t> degree_;
    std::vector<Visit> visits_;
    std::vector<State> queue_;
    GraphId stamp_ = 0, start_ = 0;
};

}  // namespace

EdgeSet augment(const Graph& graph, EdgeSet set, const RepairLimits& limits) {
    Repair repair(graph, set, Goal::augment);
    // Short walks first, all over the graph: they leave the long ones less to do.
    for (const GraphId visits : {std::min<GraphId>(limits.visits, 24), limits.visits})
        for (GraphId n = 0; n < graph.node_count(); ++n)
            while (repair.degree(n) < 2 && repair.search(n, visits) != kNoGraphId) {
            }
    return set;
}

EdgeSet extend_paths(const Graph& graph, EdgeSet set, const RepairLimits& limits) {
    Repair repair(graph, set, Goal::extend);
    for (GraphId n = 0; n < graph.node_count(); ++n) {
        if (repair.degree(n) != 1) continue;
        for (GraphId end = n; end != kNoGraphId;) end = repair.search(end, limits.visits);
    }
    return set;
}

}  // namespace ravel
