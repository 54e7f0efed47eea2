// Trees with random priorities [SeidelAragon1996] over runs; the priorities are a hash of the runs'
// numbers, so that the same cuts make the same trees.
// Cost: linear to build; rank and cut are logarithmic in the number of runs of the rope.
#include "graph/ropes.h"

#include <algorithm>
#include <tuple>

namespace ravel {
namespace {

constexpr std::size_t kMostEntries = 512;  // of a list of the index

GraphId hash(GraphId x) {
    x = (x ^ (x >> 16)) * 0x7feb352dU;
    x = (x ^ (x >> 15)) * 0x846ca68bU;
    return x ^ (x >> 16);
}

}  // namespace

void Ropes::Index::append(GraphId begin, GraphId run) {
    if (lists_.empty() || lists_.back().size() == kMostEntries / 2) {
        lists_.emplace_back();
        first_.push_back(begin);
    }
    lists_.back().push_back({begin, run});
}

std::size_t Ropes::Index::list_of(GraphId place) const {
    const auto after = std::upper_bound(first_.begin(), first_.end(), place);
    return static_cast<std::size_t>(after - first_.begin()) - 1;
}

void Ropes::Index::insert(GraphId begin, GraphId run) {
    const std::size_t k = list_of(begin);
    const auto after = [](GraphId p, const Entry& entry) { return p < entry.begin; };
    auto& list = lists_[k];
    list.insert(std::upper_bound(list.begin(), list.end(), begin, after), {begin, run});
    if (list.size() < kMostEntries) return;
    const auto half = list.begin() + kMostEntries / 2;
    const auto next = static_cast<std::ptrdiff_t>(k) + 1;
    std::vector<Entry> rest(half, list.end());
    list.erase(half, list.end());
    first_.insert(first_.begin() + next, rest.front().begin);
    lists_.insert(lists_.begin() + next, std::move(rest));
}

GraphId Ropes::Index::run_at(GraphId place) const {
    const auto after = [](GraphId p, const Entry& entry) { return p < entry.begin; };
    const auto& list = lists_[list_of(place)];
    return (std::upper_bound(list.begin(), list.end(), place, after) - 1)->run;
}

Ropes::Ropes(const StripList& strips, GraphId extra) : node_(strips.node) {
    for (GraphId i = 0; i < extra; ++i) node_.push_back(static_cast<GraphId>(node_.size()));
    place_.resize(node_.size());
    for (GraphId i = 0; i < node_.size(); ++i) place_[node_[i]] = i;
    for (GraphId s = 0; s < strips.count() + extra; ++s) {
        const GraphId begin =
            s < strips.count() ? strips.first[s] : strips.first.back() + (s - strips.count());
        const GraphId end = s < strips.count() ? strips.first[s + 1] : begin + 1;
        root_.push_back(add_run(begin, end));
        index_.append(begin, root_.back());
    }
}

GraphId Ropes::add_run(GraphId begin, GraphId end) {
    const auto run = static_cast<GraphId>(runs_.size());
    runs_.push_back({begin, end, kNone, kNone, kNone, end - begin, hash(run), false, false});
    return run;
}

GraphId Ropes::rank(GraphId node) const {
    const GraphId place = place_[node], run = index_.run_at(place);
    // Seen from below: the rank in the tree of each run on the way up, as if that were not reversed
    // by those above it.
    const Run& own = runs_[run];
    GraphId rank = size_of(own.left) + (own.backwards ? own.end - 1 - place : place - own.begin);
    if (own.reversed) rank = own.size - 1 - rank;
    for (GraphId below = run; runs_[below].up != kNone; below = runs_[below].up) {
        const Run& above = runs_[runs_[below].up];
        if (above.right == below) rank += size_of(above.left) + above.length();
        if (above.reversed) rank = above.size - 1 - rank;
    }
    return rank;
}

GraphId Ropes::node_at(GraphId rope, GraphId rank) const {
    for (GraphId run = root_[rope];;) {
        const Run& here = runs_[run];
        if (here.reversed) rank = here.size - 1 - rank;
        const GraphId left = size_of(here.left);
        if (rank < left) {
            run = here.left;
        } else if (rank < left + here.length()) {
            return node_[here.backwards ? here.end - 1 - (rank - left)
                                        : here.begin + (rank - left)];
        } else {
            rank -= left + here.length();
            run = here.right;
        }
    }
}

void Ropes::update(GraphId run) {
    Run& here = runs_[run];
    here.size = size_of(here.left) + here.length() + size_of(here.right);
    for (const GraphId below : {here.left, here.right})
        if (below != kNone) runs_[below].up = run;
}

void Ropes::push_down(GraphId run) {
    Run& here = runs_[run];
    if (!std::exchange(here.reversed, false)) return;
    std::swap(here.left, here.right);
    here.backwards = !here.backwards;
    for (const GraphId below : {here.left, here.right})
        if (below != kNone) runs_[below].reversed = !runs_[below].reversed;
}

std::pair<GraphId, GraphId> Ropes::split(GraphId root, GraphId count) {
    if (root == kNone || count == 0) return {kNone, root};
    if (count == runs_[root].size) return {root, kNone};
    push_down(root);
    const GraphId left = size_of(runs_[root].left);
    if (count <= left) {
        const auto [first, rest] = split(runs_[root].left, count);
        runs_[root].left = rest;
        update(root);
        runs_[root].up = kNone;
        if (first != kNone) runs_[first].up = kNone;
        return {first, root};
    }
    if (count >= left + runs_[root].length()) {
        const auto [first, rest] = split(runs_[root].right, count - left - runs_[root].length());
        runs_[root].right = first;
        update(root);
        runs_[root].up = kNone;
        if (rest != kNone) runs_[rest].up = kNone;
        return {root, rest};
    }
    // The run itself is cut: what follows in order becomes a run of its own.
    const GraphId kept = count - left, right = runs_[root].right;
    const bool backwards = runs_[root].backwards;
    const GraphId begin = runs_[root].begin, end = runs_[root].end;
    const GraphId cut = backwards ? end - kept : begin + kept;
    const GraphId fresh = add_run(cut, end);  // the higher places
    index_.insert(cut, fresh);
    runs_[root].end = cut;
    runs_[fresh].backwards = backwards;
    const GraphId first = backwards ? fresh : root, second = backwards ? root : fresh;
    const GraphId before = runs_[root].left;
    for (const GraphId run : {root, fresh}) {
        runs_[run].left = runs_[run].right = kNone;
        update(run);
        runs_[run].up = kNone;
    }
    return {merge(before, first), merge(second, right)};
}

GraphId Ropes::merge(GraphId a, GraphId b) {
    if (a == kNone || b == kNone) {
        const GraphId root = a == kNone ? b : a;
        if (root != kNone) runs_[root].up = kNone;
        return root;
    }
    const bool first = runs_[a].priority > runs_[b].priority;
    const GraphId root = first ? a : b;
    push_down(root);
    if (first)
        runs_[a].right = merge(runs_[a].right, b);
    else
        runs_[b].left = merge(a, runs_[b].left);
    update(root);
    runs_[root].up = kNone;
    return root;
}

void Ropes::join(GraphId into, std::span<const Stretch> stretches) {
    pieces_.clear();
    for (GraphId i = 0; i < stretches.size(); ++i) pieces_.push_back({i, kNone});
    const auto by_rank = [&](const Piece& a, const Piece& b) {
        const Stretch &x = stretches[a.stretch], &y = stretches[b.stretch];
        return x.rope != y.rope ? x.rope < y.rope : x.begin < y.begin;
    };
    std::sort(pieces_.begin(), pieces_.end(), by_rank);
    for (Piece& piece : pieces_) {
        const Stretch& stretch = stretches[piece.stretch];
        GraphId& root = root_[stretch.rope];
        std::tie(piece.root, root) = split(root, stretch.end - stretch.begin);
        if (stretch.reversed && piece.root != kNone)
            runs_[piece.root].reversed = !runs_[piece.root].reversed;
    }
    std::sort(pieces_.begin(), pieces_.end(),
              [](const Piece& a, const Piece& b) { return a.stretch < b.stretch; });
    GraphId whole = kNone;
    for (const Piece& piece : pieces_) whole = merge(whole, piece.root);
    root_[into] = whole;
}

}  // namespace ravel
