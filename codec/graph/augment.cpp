// Breadth-first search for alternating walks [Petersen1891, Berge1957], over states (node, hungry or full):
// hungry has lost an edge of the set and takes one from outside it, full has gained one and gives one away.
// A walk from a path end to another path end, toggled, adds one edge and changes no other degree.
// `close_paths` also lets a node turn singleton: it gives away both its edges, at a price of one.
// Walks may pass a node twice but no edge twice: a state is reached once, so only the same edge run
// backwards has to be looked for on the walk. That (no blossoms are shrunk) makes the result near-maximum.
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

enum class Goal : std::uint8_t { augment, close, extend };

class Repair {
  public:
    Repair(const Graph& graph, EdgeSet& set, Goal goal)
        : graph_(graph), set_(set), goal_(goal), degree_(degrees_in(graph, set)),
          visits_(2 * std::size_t{graph.node_count()}) {}

    int degree(GraphId node) const { return degree_[node]; }

    // One walk from `start`, of at most `price` new singletons, toggled where found. Gives the node
    // where the walk ends, or kNoGraphId. Each round of equal price may visit `limit` states.
    GraphId search(GraphId start, int price, GraphId limit) {
        ++stamp_;
        start_ = start;
        layer_.assign(1, 2 * start);
        visits_[2 * start] = {stamp_, kNoGraphId, kNoGraphId};
        seen_ = 1;
        end_ = kNoGraphId;
        for (;; --price) {
            dear_.clear();
            for (std::size_t i = 0; i < layer_.size() && seen_ < limit; ++i)
                if (expand(layer_[i], price > 0)) return finish();
            if (price == 0 || dear_.empty()) return kNoGraphId;
            // States that cost a singleton more wait for the next round, in the order they were met.
            layer_.clear();
            seen_ = 0;
            for (const Step& step : dear_) {
                if (step.to == kNoGraphId) {
                    end_ = step.from;
                    return finish();
                }
                if (!allowed(step)) continue;
                mark(step);
            }
        }
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

    void mark(const Step& step) {
        visits_[step.to] = {stamp_, step.from, step.edge};
        layer_.push_back(step.to);
        ++seen_;
    }

    bool may_end(GraphId node) const {
        switch (goal_) {
            case Goal::augment: return node == start_ ? degree_[node] == 0 : degree_[node] < 2;
            case Goal::close: return node != start_ && degree_[node] == 1;
            case Goal::extend: return degree_[node] == 0;
        }
        return false;
    }

    // True where the walk can end at the state or at one next to it.
    bool expand(State state, bool may_pay) {
        const GraphId node = state / 2;
        if (state % 2 == 1) {
            if (may_end(node)) {
                end_ = state;
                return true;
            }
            // A singleton taken in: it gained one edge and gains another.
            if (degree_[node] == 0) step_out(state, node);
            for (const Arc& arc : graph_.at(node))
                if (set_[arc.edge] != 0) step({state, 2 * arc.to, arc.edge});
            return false;
        }
        step_out(state, node);
        if (goal_ == Goal::close && may_pay) {
            const GraphId entry = visits_[state].edge;
            if (entry != kNoGraphId && degree_[node] == 1 && node != start_)
                dear_.push_back({state, kNoGraphId, kNoGraphId});
            for (const Arc& arc : graph_.at(node))
                if (set_[arc.edge] != 0 && arc.edge != entry)
                    dear_.push_back({state, 2 * arc.to, arc.edge});
        }
        return false;
    }

    void step_out(State state, GraphId node) {
        for (const Arc& arc : graph_.at(node))
            if (set_[arc.edge] == 0) step({state, 2 * arc.to + 1, arc.edge});
    }

    void step(const Step& s) {
        if (allowed(s)) mark(s);
    }

    GraphId finish() {
        for (State s = end_; visits_[s].edge != kNoGraphId; s = visits_[s].from) {
            const GraphId e = visits_[s].edge;
            const int change = set_[e] != 0 ? -1 : 1;
            set_[e] ^= 1;
            for (const GraphId node : graph_.ends[e])
                degree_[node] = static_cast<std::uint8_t>(degree_[node] + change);
        }
        return end_ / 2;
    }

    const Graph& graph_;
    EdgeSet& set_;
    const Goal goal_;
    std::vector<std::uint8_t> degree_;
    std::vector<Visit> visits_;
    std::vector<State> layer_;
    std::vector<Step> dear_;
    GraphId stamp_ = 0, start_ = 0, seen_ = 0;
    State end_ = kNoGraphId;
};

}  // namespace

EdgeSet augment(const Graph& graph, EdgeSet set, const RepairLimits& limits) {
    Repair repair(graph, set, Goal::augment);
    // Short walks first, all over the graph: they leave the long ones less to do.
    for (const GraphId visits : {std::min<GraphId>(limits.visits, 24), limits.visits})
        for (GraphId n = 0; n < graph.node_count(); ++n)
            while (repair.degree(n) < 2 && repair.search(n, 0, visits) != kNoGraphId) {}
    return set;
}

EdgeSet close_paths(const Graph& graph, EdgeSet set, const RepairLimits& limits) {
    const Components parts = find_components(graph);
    std::vector<GraphId> ends(parts.count, 0);
    Repair repair(graph, set, Goal::close);
    std::vector<GraphId> open;
    for (GraphId n = 0; n < graph.node_count(); ++n) {
        if (repair.degree(n) != 1) continue;
        ++ends[parts.of[n]];
        open.push_back(n);
    }
    // Cheap walks everywhere before dear ones, so that the path that stays is the one dearest to close.
    for (const int price : {0, 1, 2, 3}) {
        for (const GraphId n : open) {
            GraphId& left = ends[parts.of[n]];
            if (repair.degree(n) != 1 || (left <= 2 && price > 0)) continue;
            if (repair.search(n, price, limits.visits) != kNoGraphId) left -= 2;
        }
    }
    return set;
}

EdgeSet extend_paths(const Graph& graph, EdgeSet set, const RepairLimits& limits) {
    Repair repair(graph, set, Goal::extend);
    for (GraphId n = 0; n < graph.node_count(); ++n) {
        if (repair.degree(n) != 1) continue;
        for (GraphId end = n; end != kNoGraphId;) end = repair.search(end, 0, limits.visits);
    }
    return set;
}

}  // namespace ravel
