// Passes over the strips that are left, with larger regions as long as small ones find nothing. A
// choice in a region changes the orders of its part's strips, so a part waits for the next pass
// then.
// Cost: the steps of all searches are bounded; a pass that merges nothing is the last of its size.
#include "graph/leftover.h"

#include <algorithm>
#include <array>
#include <utility>

#include "graph/region.h"

namespace ravel {
namespace {

constexpr std::array<std::size_t, 4> kSizes{10, 14, 18, 24};
constexpr std::size_t kSteps = 4000;     // of a search
constexpr std::size_t kMostStarts = 48;  // regions of a strip and size
constexpr std::size_t kMostSearches = 20000;

class Merger {
  public:
    Merger(const Graph& graph, EdgeSet& set)
        : graph_(graph), set_(set), barred_(graph.node_count(), 0) {}

    void run() {
        for (std::size_t k = 0; k < kSizes.size() && searches_ < kMostSearches;) {
            const Pass pass = merge_all(kSizes[k]);
            if (pass == Pass::done) return;
            k = pass == Pass::merged ? 0 : k + 1;
        }
    }

  private:
    enum class Pass : std::uint8_t { merged, nothing, done };

    Pass merge_all(std::size_t size) {
        StripJoiner joiner(graph_, set_);
        if (joiner.strips_left() == graph_.parts.count) return Pass::done;
        const StripList& strips = joiner.strips();
        // The strip that stays, and whether the part may not get a path.
        std::vector<GraphId> main(graph_.parts.count, kNoGraphId);
        for (GraphId s = 0; s < strips.count(); ++s) {
            GraphId& best = main[joiner.part_of(s)];
            if (best == kNoGraphId ||
                (strips.shape[best] != StripShape::path &&
                 (strips.shape[s] == StripShape::path || strips.size(s) > strips.size(best))))
                best = s;
        }
        std::vector<std::uint8_t> changed(graph_.parts.count, 0);
        bool merged = false;
        for (GraphId s = 0; s < strips.count(); ++s) {
            const GraphId part = joiner.part_of(s);
            if (s == main[part] || changed[part] != 0) continue;
            const bool path = strips.shape[main[part]] == StripShape::path;
            changed[part] = merge_strip(joiner, s, path, size);
            merged = merged || changed[part] != 0;
        }
        return merged ? Pass::merged : Pass::nothing;
    }

    bool merge_strip(StripJoiner& joiner, GraphId strip, bool path, std::size_t size) {
        const StripList& strips = joiner.strips();
        const std::span<const GraphId> nodes(strips.node.data() + strips.first[strip],
                                             strips.size(strip));
        if (2 * nodes.size() <= size) return search(joiner, nodes, path, size);
        const std::size_t starts = std::min(nodes.size(), kMostStarts);
        for (std::size_t i = 0; i < starts; ++i)
            if (search(joiner, nodes.subspan(i * nodes.size() / starts, 1), path, size))
                return true;
        return false;
    }

    bool search(StripJoiner& joiner, std::span<const GraphId> start, bool path, std::size_t size) {
        ++searches_;
        const std::vector<GraphId> region = grow_region(graph_, start, size, barred_);
        return merge_in_region(joiner, region, path, set_, kSteps);
    }

    const Graph& graph_;
    EdgeSet& set_;
    const std::vector<std::uint8_t> barred_;
    std::size_t searches_ = 0;
};

}  // namespace

EdgeSet merge_leftover(const Graph& graph, EdgeSet set) {
    Merger(graph, set).run();
    return set;
}

}  // namespace ravel
