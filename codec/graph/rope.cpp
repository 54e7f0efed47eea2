// Runs in order and an index of them by place. When there are too many, the nodes are listed anew
// in order.
// Cost: rank log runs, join runs log runs and, once in kMaxRuns / 3 joins or so, linear.
#include "graph/rope.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ravel {
namespace {

constexpr std::size_t kMaxRuns = 1024;

}  // namespace

GraphId Rope::rank(GraphId place) const {
    const auto after =
        std::upper_bound(by_place_.begin(), by_place_.end(), place,
                         [&](GraphId p, GraphId run) { return p < runs_[run].begin; });
    const Run& run = runs_[*(after - 1)];
    return run.rank + (run.reversed ? run.end - 1 - place : place - run.begin);
}

void Rope::join(std::span<const Stretch> stretches, std::vector<GraphId>& place) {
    std::vector<Run> joined;
    GraphId rank = 0;
    // Other ropes keep their places behind those of this one.
    std::vector<std::pair<const Rope*, GraphId>> shifts{{this, 0}};
    GraphId places = size();
    for (const Stretch& stretch : stretches) {
        auto shift = std::find_if(shifts.begin(), shifts.end(),
                                  [&](const auto& s) { return s.first == stretch.rope; });
        if (shift == shifts.end()) {
            shift = shifts.insert(shifts.end(), {stretch.rope, places});
            places += stretch.rope->size();
        }
        const std::size_t from = joined.size();
        for (const Run& run : stretch.rope->runs_) {
            const GraphId begin = std::max(run.rank, stretch.begin);
            const GraphId end = std::min(run.rank + (run.end - run.begin), stretch.end);
            if (begin >= end) continue;
            Run part = run;
            part.begin = run.reversed ? run.end - (end - run.rank) : run.begin + (begin - run.rank);
            part.end = part.begin + (end - begin);
            part.begin += shift->second;
            part.end += shift->second;
            joined.push_back(part);
        }
        if (stretch.reversed) {
            std::reverse(joined.begin() + static_cast<std::ptrdiff_t>(from), joined.end());
            for (std::size_t i = from; i < joined.size(); ++i)
                joined[i].reversed = !joined[i].reversed;
        }
        for (std::size_t i = from; i < joined.size(); ++i) {
            joined[i].rank = rank;
            rank += joined[i].end - joined[i].begin;
        }
    }
    for (std::size_t i = 1; i < shifts.size(); ++i) {
        for (const GraphId node : shifts[i].first->nodes_) {
            place[node] = size();
            nodes_.push_back(node);
        }
    }
    runs_ = std::move(joined);
    index_runs();
    tidy(place);
}

void Rope::start_anew() {
    runs_.assign(1, {0, size(), 0, false});
    by_place_.assign(1, 0);
}

void Rope::index_runs() {
    by_place_.resize(runs_.size());
    std::iota(by_place_.begin(), by_place_.end(), GraphId{0});
    std::sort(by_place_.begin(), by_place_.end(),
              [&](GraphId a, GraphId b) { return runs_[a].begin < runs_[b].begin; });
}

void Rope::tidy(std::vector<GraphId>& place) {
    if (runs_.size() <= kMaxRuns) return;
    std::vector<GraphId> ordered;
    ordered.reserve(nodes_.size());
    for (const Run& run : runs_)
        for (GraphId i = 0; i < run.end - run.begin; ++i)
            ordered.push_back(nodes_[run.reversed ? run.end - 1 - i : run.begin + i]);
    nodes_ = std::move(ordered);
    for (GraphId i = 0; i < size(); ++i) place[nodes_[i]] = i;
    start_anew();
}

}  // namespace ravel
