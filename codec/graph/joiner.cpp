// A ring takes edges from strips, which fall into segments, and joins their ends by its other
// edges; whether one strip comes out depends on the order and direction in which the strips run
// through the ring. Where it meets each strip once, one strip always does.
#include "graph/joiner.h"

#include <algorithm>
#include <utility>

namespace ravel {

StripJoiner::StripJoiner(const Graph& graph, EdgeSet& set, StripList strips)
    : graph_(graph),
      set_(set),
      strips_(std::move(strips)),
      part_size_(graph.parts.count, 0),
      sets_(strips_.count()),
      open_(strips_.count(), 0),
      ropes_(strips_),
      strips_left_(strips_.count()) {
    for (GraphId s = 0; s < strips_.count(); ++s) {
        part_size_[part_of(s)] += strips_.size(s);
        sets_.weigh(s, strips_.size(s));
        open_[s] = strips_.shape[s] == StripShape::path;
    }
}

bool StripJoiner::toggle(std::span<const RingLink> ring) {
    if (!place_cuts(ring) || !follow_segments(ring.size())) return false;
    bool open = false;
    for (const Cut& cut : cuts_) open = open || open_[cut.strip] != 0;
    stretches_.clear();
    for (const Segment& segment : segments_) add_stretches(segment);
    const GraphId first = cuts_[0].strip;
    for (const Cut& cut : cuts_) strips_left_ -= sets_.unite(first, cut.strip);
    const GraphId strip = sets_.find(first);
    ropes_.join(strip, stretches_);
    open_[strip] = open;
    for (const RingLink& link : ring) {
        set_[link.in] = 0;
        set_[link.out] = 1;
    }
    return true;
}

// Cuts by strip and rank; false where two strips are paths or all cuts are of one strip.
bool StripJoiner::place_cuts(std::span<const RingLink> ring) {
    cuts_.clear();
    const GraphId first = strip_of(ring[0].tail);
    if (std::all_of(ring.begin(), ring.end(),
                    [&](const RingLink& link) { return strip_of(link.tail) == first; }))
        return false;
    int paths = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const GraphId strip = strip_of(ring[i].tail);
        const GraphId tail = ropes_.rank(ring[i].tail), head = ropes_.rank(ring[i].head);
        const bool forward = (tail + 1) % size(strip) == head;
        const auto same = [&](const Cut& cut) { return cut.strip == strip; };
        if (std::none_of(cuts_.begin(), cuts_.end(), same)) paths += open_[strip];
        cuts_.push_back({strip, forward ? tail : head, i, forward});
    }
    if (paths > 1) return false;
    std::sort(cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) {
        return a.strip != b.strip ? a.strip < b.strip : a.rank < b.rank;
    });
    for (std::size_t i = 1; i < cuts_.size(); ++i)
        if (cuts_[i].strip == cuts_[i - 1].strip && cuts_[i].rank == cuts_[i - 1].rank)
            return false;
    return true;
}

std::size_t StripJoiner::next_cut(std::size_t cut) const {
    if (cut + 1 < cuts_.size() && cuts_[cut + 1].strip == cuts_[cut].strip) return cut + 1;
    while (cut > 0 && cuts_[cut - 1].strip == cuts_[cut].strip) --cut;
    return cut;
}

std::size_t StripJoiner::previous_cut(std::size_t cut) const {
    if (cut > 0 && cuts_[cut - 1].strip == cuts_[cut].strip) return cut - 1;
    while (cut + 1 < cuts_.size() && cuts_[cut + 1].strip == cuts_[cut].strip) ++cut;
    return cut;
}

// From segment 0 along the ring's other edges; true where that takes in all segments.
bool StripJoiner::follow_segments(std::size_t links) {
    segments_.clear();
    std::size_t segment = 0;
    bool reversed = false;
    do {
        segments_.push_back({segment, reversed});
        // Leave the segment at a side of a cut: the node before it, or behind it when running
        // backwards.
        const Cut& cut = cuts_[reversed ? segment : next_cut(segment)];
        const bool at_tail = cut.forward != reversed;
        const std::size_t link = (cut.link + (at_tail ? links - 1 : 1)) % links;
        std::size_t other = 0;
        while (cuts_[other].link != link) ++other;
        // From a tail the out edge leads to the last head, from a head to the next tail.
        const bool behind = cuts_[other].forward == at_tail;
        segment = behind ? other : previous_cut(other);
        reversed = !behind;
    } while (segment != 0 && segments_.size() <= cuts_.size());
    return !reversed && segments_.size() == cuts_.size();
}

// Segments that run past the end of their rope's order are two stretches.
void StripJoiner::add_stretches(const Segment& segment) {
    const Cut& cut = cuts_[segment.cut];
    const GraphId begin = cut.rank + 1, end = cuts_[next_cut(segment.cut)].rank + 1;
    const bool reversed = segment.reversed;
    if (begin < end) {
        stretches_.push_back({cut.strip, begin, end, reversed});
        return;
    }
    const Ropes::Stretch tail{cut.strip, begin, size(cut.strip), reversed};
    const Ropes::Stretch start{cut.strip, 0, end, reversed};
    stretches_.push_back(reversed ? start : tail);
    stretches_.push_back(reversed ? tail : start);
}

// All of a strip, from rank `cut` on round to the one before it, or that backwards.
void StripJoiner::add_round(GraphId strip, GraphId cut, bool reversed) {
    const GraphId count = size(strip);
    const Ropes::Stretch tail{strip, cut % count, count, reversed};
    const Ropes::Stretch start{strip, 0, cut % count, reversed};
    stretches_.push_back(reversed ? start : tail);
    stretches_.push_back(reversed ? tail : start);
}

GraphId StripJoiner::absorb(GraphId end, GraphId edge, GraphId next) {
    const GraphId path = strip_of(end), cycle = strip_of(next);
    const auto neighbour = [&](GraphId node) {
        for (const Arc& arc : graph_.at(node))
            if (set_[arc.edge] != 0) return arc;
        return Arc{node, kNoGraphId};
    };
    const auto comes_after = [&](GraphId node, GraphId before) {
        return (ropes_.rank(before) + 1) % size(strip_of(node)) == ropes_.rank(node);
    };
    // The path is run through up to its end, the cycle from `next` on; a singleton is no cycle.
    const Arc last = neighbour(next);
    stretches_.clear();
    const bool forward = comes_after(end, neighbour(end).to);
    add_round(path, ropes_.rank(end) + (forward ? 1 : 0), !forward);
    const bool onward = comes_after(next, last.to);
    add_round(cycle, ropes_.rank(next) + (onward ? 0 : 1), !onward);
    if (last.edge != kNoGraphId) set_[last.edge] = 0;
    set_[edge] = 1;
    sets_.unite(path, cycle);
    --strips_left_;
    const GraphId strip = sets_.find(path);
    ropes_.join(strip, stretches_);
    open_[strip] = 1;
    return last.to;
}

}  // namespace ravel
