// Two strips side by side are opened there and joined to one path. Rotations of the path [Posa1976]
// then move its tail until it is next to its head, and the path closes: where the tail has an edge
// to a node y of the path, that edge is added, and the edge from y towards the tail is dropped; its
// other end is the new tail. A part's open strip counts as a cycle through one more node, the gap,
// that has an edge to every node. Rotations are tried depth first, nearer tails only, on a list of
// stretches of both strips' orders; ropes change when a trial has succeeded.
// Cost: a trial visits few hundred nodes; all together `steps_per_node` per node.
#include "graph/rotate.h"

#include <algorithm>
#include <array>
#include <utility>

#include "graph/cycles.h"
#include "graph/ropes.h"

namespace ravel {
namespace {

constexpr std::uint64_t kSpareSteps = 1 << 27;  // small graphs may be searched to the end
constexpr int kPasses = 4;
constexpr int kMaxRotations = 2000;     // of a trial
constexpr std::uint64_t kSteps = 50;    // that a rotation counts as
constexpr std::size_t kMaxTrials = 96;  // per strip and pass

class Merger {
  public:
    Merger(const Graph& graph, EdgeSet& set, const RotationLimits& limits)
        : graph_(graph),
          set_(set),
          depth_(limits.depth),
          strips_(list_strips(graph, set)),
          strip_of_(strips_.of),
          ropes_(strips_, graph.parts.count),
          distance_(graph.node_count(), kFar),
          steps_left_(limits.steps_per_node * graph.node_count() + kSpareSteps) {
        strip_of_.resize(std::size_t{graph.node_count()} + graph.parts.count, kNoGraphId);
    }

    std::uint64_t run() {
        std::vector<GraphId> order(strips_.count());
        for (GraphId s = 0; s < order.size(); ++s) order[s] = s;
        std::stable_sort(order.begin(), order.end(), [&](GraphId a, GraphId b) {
            return part_of(a) != part_of(b) ? part_of(a) < part_of(b)
                                            : strips_.size(a) < strips_.size(b);
        });
        for (auto begin = order.begin(); begin != order.end();) {
            auto end = begin;
            while (end != order.end() && part_of(*end) == part_of(*begin)) ++end;
            if (end - begin > 1) merge_part({begin, end});
            begin = end;
        }
        return merges_;
    }

  private:
    static constexpr GraphId kFar = kNoGraphId;

    GraphId part_of(GraphId strip) const {
        return graph_.parts.of[strips_.node[strips_.first[strip]]];
    }

    // `strips` with the smallest first.
    void merge_part(std::vector<GraphId> strips) {
        gap_ = graph_.node_count() + part_of(strips[0]);
        // A path is the one that takes in the others: the gap is in it.
        auto main = std::find_if(strips.begin(), strips.end(),
                                 [&](GraphId s) { return strips_.shape[s] == StripShape::path; });
        if (main == strips.end()) main = strips.end() - 1;
        main_ = *main;
        strips.erase(main);
        if (strips_.shape[main_] == StripShape::path) add_gap();
        take_in(strips);
        if (!strips.empty() && strip_of_[gap_] == kNoGraphId && open_beside(strips)) {
            take_in(strips);
            close_gap();
        }
    }

    void add_gap() {
        const GraphId size = ropes_.size(main_);
        beside_gap_ = {ropes_.node_at(main_, 0), ropes_.node_at(main_, size - 1)};
        const GraphId gap = strips_.count() + part_of(main_);
        ropes_.join(main_,
                    std::array<Ropes::Stretch, 2>{{{main_, 0, size, false}, {gap, 0, 1, false}}});
        strip_of_[gap_] = main_;
    }

    // Of a strip that is as it was at first.
    std::span<const GraphId> nodes_of(GraphId strip) const {
        return {strips_.node.data() + strips_.first[strip], strips_.size(strip)};
    }

    // Takes strips into the main one, pass after pass; leaves those that resist.
    void take_in(std::vector<GraphId>& strips) {
        for (int pass = 0; pass < kPasses; ++pass) {
            const std::size_t before = strips.size();
            std::erase_if(strips, [&](GraphId s) { return try_strip(s, true); });
            if (strips.size() == before || strips.empty()) break;
        }
    }

    bool open_beside(std::vector<GraphId>& strips) {
        const auto taken = std::find_if(strips.begin(), strips.end(),
                                        [&](GraphId s) { return try_strip(s, false); });
        if (taken == strips.end()) return false;
        strips.erase(taken);
        add_gap();
        return true;
    }

    bool in_set(const Arc& arc) const { return set_[arc.edge] != 0; }

    // Opens both strips side by side in every way and joins them. False where they do not touch, or
    // are to close again and do not.
    bool try_strip(GraphId strip, bool closes) {
        std::size_t trials = 0;
        for (const GraphId s : nodes_of(strip)) {
            for (const Arc& join : graph_.at(s)) {
                if (strip_of_[join.to] != main_) continue;
                for (const Arc& a : openings(join.to)) {
                    for (const Arc& b : openings(s)) {
                        if (closes && (steps_left_ < kSteps || ++trials > kMaxTrials)) return false;
                        if (try_opened(strip, {a.to, a.edge}, join, {b.to, b.edge}, s, closes))
                            return true;
                    }
                }
            }
        }
        return false;
    }

    // The edges a node can be cut from; a singleton needs no cut.
    std::vector<Arc> openings(GraphId node) const {
        std::vector<Arc> found;
        for (const Arc& arc : graph_.at(node))
            if (in_set(arc)) found.push_back(arc);
        if (found.empty() && ropes_.size(strip_of_[node]) == 1) found.push_back({node, kNoGraphId});
        return found;
    }

    bool try_opened(GraphId strip, const Arc& main_cut, const Arc& join, const Arc& cut, GraphId s,
                    bool closes) {
        order_.clear();
        toggled_.clear();
        append(main_, main_cut.to, join.to);
        append(strip, s, cut.to);
        for (const GraphId edge : {main_cut.edge, cut.edge, join.edge})
            if (edge != kNoGraphId) toggle(edge);
        head_ = main_cut.to;
        tail_ = cut.to;
        other_ = strip;
        if (!closes || closes_within_reach()) {
            commit(strip);
            return true;
        }
        while (!toggled_.empty()) untoggle();
        return false;
    }

    bool closes_within_reach() {
        measure();
        rotations_left_ = kMaxRotations;
        const std::array<GraphId, 2> beside = beside_gap_;
        for (int depth = 1; depth <= depth_ && rotations_left_ > 0; depth += 2)
            if (close(depth)) return true;
        beside_gap_ = beside;
        return false;
    }

    void toggle(GraphId edge) {
        set_[edge] ^= 1;
        toggled_.push_back(edge);
    }
    void untoggle() {
        set_[toggled_.back()] ^= 1;
        toggled_.pop_back();
    }

    // A strip's order from `first` to its neighbour `last`, the long way round.
    void append(GraphId strip, GraphId first, GraphId last) {
        const GraphId r = ropes_.rank(first), size = ropes_.size(strip);
        const auto add = [&](GraphId begin, GraphId end, bool reversed) {
            if (begin < end) order_.push_back({strip, begin, end, reversed});
        };
        if ((ropes_.rank(last) + 1) % size == r) {
            add(r, size, false);
            add(0, r, false);
        } else {
            add(0, r + 1, true);
            add(r + 1, size, true);
        }
    }

    // Where the node is on the path at hand; kFar for nodes of other strips.
    GraphId position(GraphId node) const {
        const GraphId strip = strip_of_[node];
        if (strip != main_ && strip != other_) return kFar;
        const GraphId rank = ropes_.rank(node);
        GraphId before = 0;
        for (const Ropes::Stretch& s : order_) {
            if (s.rope == strip && s.begin <= rank && rank < s.end)
                return before + (s.reversed ? s.end - 1 - rank : rank - s.begin);
            before += s.end - s.begin;
        }
        return kFar;
    }

    // Turns round what follows position `cut`.
    void turn(GraphId cut) {
        GraphId before = 0;
        for (std::size_t i = 0; i < order_.size(); ++i) {
            Ropes::Stretch& s = order_[i];
            const GraphId length = s.end - s.begin;
            if (before + length > cut && before < cut) {
                Ropes::Stretch rest = s;
                const GraphId kept = cut - before;
                if (s.reversed) {
                    rest.end = s.end - kept;
                    s.begin = rest.end;
                } else {
                    rest.begin = s.begin + kept;
                    s.end = rest.begin;
                }
                order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(i) + 1, rest);
            }
            before += order_[i].end - order_[i].begin;
            if (before < cut) continue;
            const auto from =
                order_.begin() + static_cast<std::ptrdiff_t>(before > cut ? i : i + 1);
            std::reverse(from, order_.end());
            for (auto it = from; it != order_.end(); ++it) it->reversed = !it->reversed;
            return;
        }
    }

    // Distances from the head, as far as rotations can bring the tail near.
    void measure() {
        for (const GraphId node : near_) distance_[node] = kFar;
        near_.assign(1, head_);
        distance_[head_] = 0;
        const auto reach = static_cast<GraphId>(2 * depth_);
        for (std::size_t i = 0; i < near_.size() && distance_[near_[i]] < reach; ++i) {
            for (const Arc& arc : graph_.at(near_[i])) {
                if (distance_[arc.to] != kFar) continue;
                distance_[arc.to] = distance_[near_[i]] + 1;
                near_.push_back(arc.to);
            }
            if (near_.size() > 2000) break;
        }
        steps_left_ -= std::min<std::uint64_t>(steps_left_, near_.size());
    }

    bool close(int depth) {
        for (const Arc& arc : graph_.at(tail_)) {
            if (arc.to != head_ || in_set(arc)) continue;
            toggle(arc.edge);
            return true;
        }
        if (depth == 0) return false;
        const GraphId tail = tail_;
        for (const Arc& arc : graph_.at(tail)) {
            if (in_set(arc)) continue;
            const GraphId at = position(arc.to);
            if (at == kFar) continue;
            for (const Arc& next : graph_.at(arc.to)) {
                if (!in_set(next) || next.to == tail || !worth(next.to, depth) ||
                    position(next.to) != at + 1)
                    continue;
                if (!spend()) return false;
                toggle(next.edge);
                toggle(arc.edge);
                if (rotate(at + 1, next.to, depth)) return true;
                tail_ = tail;
                untoggle();
                untoggle();
                break;
            }
        }
        return close_by_gap(depth);
    }

    // The gap moves to the tail; its neighbour on the tail's side is the new tail.
    bool close_by_gap(int depth) {
        if (strip_of_[gap_] != main_) return false;
        const GraphId tail = tail_;
        const GraphId at = position(gap_);
        for (GraphId& beside : beside_gap_) {
            const GraphId next = beside;
            if (next == tail || !worth(next, depth) || position(next) != at + 1) continue;
            if (!spend()) return false;
            beside = tail;
            if (rotate(at + 1, next, depth)) return true;
            beside = next;
            tail_ = tail;
            break;
        }
        return false;
    }

    bool worth(GraphId node, int depth) const {
        return distance_[node] != kFar && distance_[node] <= static_cast<GraphId>(2 * depth - 1);
    }

    bool spend() {
        if (rotations_left_ == 0 || steps_left_ < kSteps) return false;
        --rotations_left_;
        steps_left_ -= kSteps;
        return true;
    }

    bool rotate(GraphId cut, GraphId tail, int depth) {
        const std::vector<Ropes::Stretch> order = order_;
        turn(cut);
        tail_ = tail;
        if (close(depth - 1)) return true;
        order_ = order;
        return false;
    }

    void commit(GraphId strip) {
        ropes_.join(main_, order_);
        for (const GraphId node : nodes_of(strip)) strip_of_[node] = main_;
        ++merges_;
    }

    // Closes the path over the gap.
    void close_gap() {
        const std::array<GraphId, 2> ends = beside_gap_;
        order_.clear();
        toggled_.clear();
        other_ = main_;
        strip_of_[gap_] = kNoGraphId;
        const GraphId r = ropes_.rank(gap_), size = ropes_.size(main_);
        if (r + 1 < size) order_.push_back({main_, r + 1, size, false});
        if (r > 0) order_.push_back({main_, 0, r, false});
        const bool forward = position(ends[0]) == 0;
        head_ = ends[forward ? 0 : 1];
        tail_ = ends[forward ? 1 : 0];
        if (head_ != tail_ && !closes_within_reach())
            while (!toggled_.empty()) untoggle();
    }

    const Graph& graph_;
    EdgeSet& set_;
    const int depth_;
    const StripList strips_;
    std::vector<GraphId> strip_of_;  // node -> strip that holds it now
    Ropes ropes_;
    std::vector<GraphId> distance_, near_;
    std::uint64_t steps_left_;
    std::uint64_t merges_ = 0;
    GraphId main_ = 0, gap_ = 0;
    std::array<GraphId, 2> beside_gap_{kNoGraphId, kNoGraphId};

    // The trial at hand.
    GraphId other_ = 0, head_ = 0, tail_ = 0;
    std::vector<Ropes::Stretch> order_;
    std::vector<GraphId> toggled_;
    int rotations_left_ = 0;
};

}  // namespace

RotationMerge merge_by_rotations(const Graph& graph, EdgeSet set, const RotationLimits& limits) {
    RotationMerge merged{std::move(set), 0};
    merged.merges = Merger(graph, merged.set, limits).run();
    return merged;
}

}  // namespace ravel
