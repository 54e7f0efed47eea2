// In a part, small regions that don't overlap are looked for round the strips that the set leaves
// over. Whatever the edges outside, f closed strips and singletons lie inside a region, found
// exhaustively; with an end of the part's only path in it, or both, it may be fewer, so at most two
// regions have that relief. A node that is in no region is on one more strip: the strips of the
// part are at least one more than all these together, and the links no fewer than these. Two ways
// to choose regions compete, and so does the deficiency of the maximum 2-matching, d: what it lacks
// is two edge ends for each singleton and for the path, so that there are d - 1 links or more.
// Cost: for each place to look at, the steps of some searches; and one matching.
#include "graph/bound.h"

#include <algorithm>
#include <array>
#include <utility>

#include "graph/region.h"
#include "graph/template_factor.h"

namespace ravel {
namespace {

constexpr std::array<std::size_t, 9> kSizes{4, 7, 10, 13, 16, 20, 24, 30, 36};
constexpr std::size_t kSteps = 20000;  // of a search
constexpr std::size_t kMostSearches = 50000;
constexpr GraphId kMostMatched = 500000;  // nodes; a matching of more takes seconds

// What lies inside the regions of a part, and how much of it the ends of the path save.
struct Inside {
    std::uint64_t strips = 0;
    std::uint64_t nodes = 0;
    std::uint64_t one_end = 0, next_end = 0;  // the two regions where one end saves most
    std::uint64_t both_ends = 0;              // the region where two do

    void add(std::uint64_t fewest, std::uint64_t with_one, std::uint64_t with_both) {
        strips += fewest;
        const std::uint64_t one = fewest - std::min(fewest, with_one);
        next_end = std::max(next_end, std::min(one, one_end));
        one_end = std::max(one_end, one);
        both_ends = std::max(both_ends, fewest - std::min(fewest, with_both));
    }
    std::uint64_t links(std::uint64_t part_nodes) const {
        const std::uint64_t spared = std::max(one_end + next_end, both_ends);
        // Where the regions hold the whole part, its path or one of the strips is the one that
        // stays.
        const std::uint64_t least = nodes < part_nodes ? 0 : 1;
        return strips - std::min(strips, std::max(spared, least));
    }
};

struct Region {
    std::vector<GraphId> nodes;
    GraphId start = 0;                // number of the place it was grown from
    std::array<GraphId, 3> strips{};  // that lie inside, with so many ends of the path
};

class Bound {
  public:
    Bound(const Graph& graph, const EdgeSet& set)
        : graph_(graph),
          strips_(list_strips(graph, set)),
          part_size_(graph.parts.count, 0),
          strips_in_(graph.parts.count, 0),
          links_(graph.parts.count, 0) {
        for (const GraphId part : graph.parts.of) ++part_size_[part];
        for (GraphId s = 0; s < strips_.count(); ++s) ++strips_in_[part_of(s)];
    }

    std::uint64_t run() {
        find_regions();
        // Of each place the region that holds most, or those first that hold most for their size.
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < regions_.size(); ++i)
            if (i + 1 == regions_.size() || regions_[i + 1].start != regions_[i].start)
                order.push_back(i);
        pack(order);
        order.resize(regions_.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            const Region &x = regions_[a], &y = regions_[b];
            return x.strips[0] * y.nodes.size() > y.strips[0] * x.nodes.size();
        });
        pack(order);
        bool all = true;
        for (GraphId part = 0; part < links_.size(); ++part)
            all = all && links_[part] + 1 >= strips_in_[part];
        if (!all && graph_.node_count() <= kMostMatched) look_at_deficiency();
        std::uint64_t sum = 0;
        for (const std::uint64_t links : links_) sum += links;
        return sum;
    }

  private:
    GraphId part_of(GraphId strip) const {
        return graph_.parts.of[strips_.node[strips_.first[strip]]];
    }

    // The strips that are left over and the ends of paths, then the nodes with least choice; in
    // parts that have more than one strip.
    std::vector<std::span<const GraphId>> starts() const {
        std::vector<std::span<const GraphId>> found;
        for (GraphId s = 0; s < strips_.count(); ++s) {
            if (strips_in_[part_of(s)] < 2) continue;
            const std::span<const GraphId> nodes(strips_.node.data() + strips_.first[s],
                                                 strips_.size(s));
            if (strips_.shape[s] == StripShape::path) {
                found.push_back(nodes.first(1));
                found.push_back(nodes.last(1));
            } else if (2 * nodes.size() <= part_size_[part_of(s)] &&
                       nodes.size() <= kSizes.back()) {
                found.push_back(nodes);
            }
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); });
        for (const GraphId& node : strips_.node)
            if (strips_in_[graph_.parts.of[node]] > 1 && graph_.degree(node) <= 2)
                found.push_back({&node, 1});
        return found;
    }

    void find_regions() {
        const std::vector<std::uint8_t> barred(graph_.node_count(), 0);
        std::size_t searches = 0;
        GraphId place = 0;
        for (const std::span<const GraphId> start : starts()) {
            ++place;
            GraphId most = 0;
            for (const std::size_t size : kSizes) {
                if (size < start.size() || ++searches > kMostSearches) continue;
                Region region{grow_region(graph_, start, size, barred), place, {}};
                region.strips[0] = fewest_inside(graph_, region.nodes, 0, kSteps);
                if (region.strips[0] <= most) continue;
                most = region.strips[0];
                for (const int ends : {1, 2})
                    region.strips[static_cast<std::size_t>(ends)] =
                        fewest_inside(graph_, region.nodes, ends, kSteps);
                regions_.push_back(std::move(region));
            }
        }
    }

    void pack(const std::vector<std::size_t>& order) {
        std::vector<Inside> inside(links_.size());
        std::vector<std::uint8_t> taken(graph_.node_count(), 0);
        for (const std::size_t i : order) {
            const Region& region = regions_[i];
            if (std::any_of(region.nodes.begin(), region.nodes.end(),
                            [&](GraphId n) { return taken[n] != 0; }))
                continue;
            Inside& part = inside[graph_.parts.of[region.nodes[0]]];
            part.add(region.strips[0], region.strips[1], region.strips[2]);
            part.nodes += region.nodes.size();
            for (const GraphId n : region.nodes) taken[n] = 1;
        }
        for (GraphId part = 0; part < links_.size(); ++part)
            links_[part] = std::max(links_[part], inside[part].links(part_size_[part]));
    }

    void look_at_deficiency() {
        std::vector<std::uint64_t> missing(links_.size(), 0);
        const std::vector<std::uint8_t> degree = degrees_in(graph_, template_factor(graph_).set);
        for (GraphId n = 0; n < degree.size(); ++n) missing[graph_.parts.of[n]] += 2 - degree[n];
        for (GraphId part = 0; part < links_.size(); ++part)
            if (missing[part] > 2) links_[part] = std::max(links_[part], missing[part] / 2 - 1);
    }

    const Graph& graph_;
    const StripList strips_;
    std::vector<std::uint64_t> part_size_, strips_in_;
    std::vector<std::uint64_t> links_;  // part -> links that are proven so far
    std::vector<Region> regions_;       // by place, then by size
};

}  // namespace

std::uint64_t forced_links(const Graph& graph, const EdgeSet& set) {
    return Bound(graph, set).run();
}

}  // namespace ravel
