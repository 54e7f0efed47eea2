// Each part that has more than one strip is looked at by itself. Regions round each strip but the
// main one, larger ones as long as smaller ones find nothing. Then moves at random, as long as
// there are more strips than the bound forces: a choice anew near such a strip that saves nothing
// changes what the next one can do. Cost: a choice changes the orders of strips, which are listed
// anew then; so nodes times moves are bounded, and large parts get few moves or none.
#include "graph/leftover.h"

#include <algorithm>
#include <array>
#include <utility>

#include "graph/bound.h"
#include "graph/region.h"

namespace ravel {
namespace {

constexpr std::array<std::size_t, 4> kSizes{10, 16, 24, 36};
constexpr std::size_t kSteps = 30000;    // of a search
constexpr std::size_t kMostStarts = 48;  // regions of a strip and size
constexpr std::size_t kMostSearches = 20000;
constexpr std::array<std::size_t, 3> kMoveSizes{10, 16, 24};
constexpr std::size_t kMoveSteps = 3000;
constexpr std::size_t kFar = 24;           // steps at random from a strip to where a move is made
constexpr std::size_t kMostTries = 40000;  // of a part
constexpr std::size_t kIdleTries = 8000;   // in a row that save nothing
constexpr std::size_t kNodesMoved = 10000000;  // nodes times moves
constexpr std::size_t kFewMoves = 50;          // not worth to start

class Merger {
  public:
    // Of one part.
    Merger(const Graph& graph, EdgeSet& set)
        : graph_(graph), set_(set), barred_(graph.node_count(), 0) {}

    void run() {
        merge();
        const std::size_t moves = kNodesMoved / graph_.node_count();
        if (left_ == 0 || moves < kFewMoves) return;
        const std::size_t forced = forced_links(graph_, set_);
        std::size_t idle = 0, tries = 0;
        for (std::size_t i = 0; i < moves && tries < kMostTries && left_ > forced; ++i) {
            StripJoiner joiner(graph_, set_);
            const std::size_t before = left_;
            tell_strips_apart(joiner);
            if (left_ < before) idle = 0;
            while (idle < kIdleTries && ++tries < kMostTries && !move(joiner)) ++idle;
            if (idle == kIdleTries) break;
        }
    }

  private:
    void merge() {
        for (std::size_t k = 0; k < kSizes.size() && searches_ < kMostSearches;)
            k = merge_any(kSizes[k]) ? 0 : k + 1;
    }

    // The strip that stays, a path or else the largest; the others.
    void tell_strips_apart(const StripJoiner& joiner) {
        const StripList& strips = joiner.strips();
        main_ = 0;
        for (GraphId s = 1; s < strips.count(); ++s)
            if (strips.shape[main_] != StripShape::path && strips.size(s) > strips.size(main_))
                main_ = s;
        has_path_ = strips.shape[main_] == StripShape::path;
        left_ = strips.count() - 1;
    }

    bool merge_any(std::size_t size) {
        StripJoiner joiner(graph_, set_);
        tell_strips_apart(joiner);
        for (GraphId s = 0; s < joiner.strips().count(); ++s) {
            if (s == main_ || !merge_strip(joiner, s, size)) continue;
            --left_;
            return true;
        }
        return false;
    }

    static std::span<const GraphId> nodes_of(const StripList& strips, GraphId strip) {
        return {strips.node.data() + strips.first[strip], strips.size(strip)};
    }

    bool merge_strip(StripJoiner& joiner, GraphId strip, std::size_t size) {
        const std::span<const GraphId> nodes = nodes_of(joiner.strips(), strip);
        RegionSearch options;
        options.steps = kSteps;
        options.part_has_path = has_path_;
        const auto search = [&](std::span<const GraphId> start) {
            ++searches_;
            return merge_in_region(joiner, grow_region(graph_, start, size, barred_), options,
                                   set_);
        };
        if (2 * nodes.size() <= size) return search(nodes);
        const std::size_t starts = std::min(nodes.size(), kMostStarts);
        for (std::size_t i = 0; i < starts; ++i)
            if (search(nodes.subspan(i * nodes.size() / starts, 1))) return true;
        return false;
    }

    // A search at a strip, or a change near it; true where the set is another then.
    bool move(StripJoiner& joiner) {
        if (left_ == 0) return true;
        auto strip = static_cast<GraphId>(draw(left_));
        if (strip >= main_) ++strip;
        const std::span<const GraphId> nodes = nodes_of(joiner.strips(), strip);
        GraphId start = nodes[draw(nodes.size())];
        RegionSearch options;
        options.steps = kMoveSteps;
        options.part_has_path = has_path_;
        options.seed = state_ | 1;
        options.sideways = draw(2) == 0;
        if (options.sideways)
            for (std::size_t steps = draw(kFar); steps > 0; --steps)
                start = graph_.at(start)[draw(graph_.degree(start))].to;
        const std::size_t size = kMoveSizes[draw(kMoveSizes.size())];
        return merge_in_region(joiner, grow_region(graph_, {&start, 1}, size, barred_), options,
                               set_);
    }

    std::size_t draw(std::size_t below) {
        state_ = state_ * 1664525U + 1013904223U;
        return (std::uint64_t{state_} * below) >> 32;
    }

    const Graph& graph_;
    EdgeSet& set_;
    const std::vector<std::uint8_t> barred_;  // no node
    GraphId main_ = 0;
    bool has_path_ = false;
    std::size_t left_ = 0;  // strips but the main one
    std::size_t searches_ = 0;
    std::uint32_t state_ = 1;  // of the generator
};

}  // namespace

EdgeSet merge_leftover(const Graph& graph, EdgeSet set) {
    const StripList strips = list_strips(graph, set);
    std::vector<GraphId> strips_in(graph.parts.count, 0);
    for (GraphId s = 0; s < strips.count(); ++s)
        ++strips_in[graph.parts.of[strips.node[strips.first[s]]]];
    std::vector<GraphId> number(graph.node_count(), 0), nodes(graph.parts.count, 0);
    for (GraphId n = 0; n < graph.node_count(); ++n) number[n] = nodes[graph.parts.of[n]]++;
    std::vector<std::vector<GraphId>> edges(graph.parts.count);  // of the parts to look at
    for (GraphId e = 0; e < graph.edge_count(); ++e) {
        const GraphId part = graph.parts.of[graph.ends[e][0]];
        if (strips_in[part] > 1) edges[part].push_back(e);
    }
    for (GraphId part = 0; part < graph.parts.count; ++part) {
        if (strips_in[part] < 2) continue;
        std::vector<std::array<GraphId, 2>> ends;
        EdgeSet own;
        for (const GraphId e : edges[part]) {
            ends.push_back({number[graph.ends[e][0]], number[graph.ends[e][1]]});
            own.push_back(set[e]);
        }
        const Graph alone = make_graph(nodes[part], std::move(ends));
        Merger(alone, own).run();
        for (std::size_t i = 0; i < own.size(); ++i) set[edges[part][i]] = own[i];
    }
    return set;
}

}  // namespace ravel
