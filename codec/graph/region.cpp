// Depth first over the nodes of the region, those first that have fewest choices: a node takes as
// many of its edges as it needs, or is a singleton, or an end of the part's path. Fragments of
// strips are known by their two ends; where an edge joins both ends of one, a strip is closed,
// which costs one, as does a singleton. Cost: exponential in the region, so bounded by a number of
// steps.
#include "graph/region.h"

#include <algorithm>
#include <array>
#include <utility>

namespace ravel {
namespace {

constexpr GraphId kOutside = kNoGraphId;  // where a fragment leaves the region for good
constexpr std::size_t kMostDegree = 12;   // of a node inside

class Search {
  public:
    struct Edge {
        GraphId a, b;  // places in the region
        GraphId id;
    };

    explicit Search(std::size_t nodes, std::uint32_t seed = 0)
        : random_(seed),
          edges_of_(nodes),
          need_(nodes, 2),
          stubs_(nodes, 0),
          fixed_(nodes, 0),
          mate_(nodes) {
        for (GraphId i = 0; i < nodes; ++i) mate_[i] = i;
        open_.assign(nodes, 1);
    }

    void add_edge(const Edge& edge) {
        for (const GraphId n : {edge.a, edge.b})
            edges_of_[n].push_back(static_cast<GraphId>(edges_.size()));
        edges_.push_back(edge);
        chosen_.push_back(kUndecided);
    }
    // An edge out of the region that may be taken.
    void add_stub(GraphId node) { ++stubs_[node]; }
    // What is outside joins two nodes, or leads from one to the end of a path.
    void add_fragment(GraphId a, GraphId b) {
        for (const GraphId n : {a, b})
            if (n != kOutside) {
                --need_[n];
                fixed_[n] = 1;
            }
        closed_ += join(a, b);
    }

    // Is there a choice that closes no more strips than `most`, with just so many path ends?
    bool run(int most, int ends, std::size_t steps) {
        most_ = most;
        ends_left_ = ends;
        steps_left_ = steps;
        return closed_ <= most && choose();
    }
    // There is none.
    bool refutes(int most, int ends, std::size_t steps) {
        return !run(most, ends, steps) && steps_left_ > 0;
    }
    bool is_chosen(std::size_t edge) const { return chosen_[edge] == kIn; }
    const std::vector<Edge>& edges() const { return edges_; }

  private:
    enum Choice : std::uint8_t { kUndecided, kIn, kOut };

    // Gives 1 where that closes a strip; what it changes is on the trail.
    int join(GraphId a, GraphId b) {
        const GraphId x = a == kOutside ? kOutside : mate_[a];
        const GraphId y = b == kOutside ? kOutside : mate_[b];
        if (x == b && b != kOutside) return 1;
        for (const auto& [end, other] : {std::array{x, y}, std::array{y, x}}) {
            if (end == kOutside) continue;
            trail_.push_back({end, mate_[end]});
            mate_[end] = other;
        }
        return 0;
    }
    void undo(std::size_t size) {
        for (; trail_.size() > size; trail_.pop_back()) mate_[trail_.back()[0]] = trail_.back()[1];
    }

    std::vector<GraphId> undecided(GraphId node) const {
        std::vector<GraphId> found;
        for (const GraphId e : edges_of_[node])
            if (chosen_[e] == kUndecided) found.push_back(e);
        return found;
    }

    bool choose() {
        if (steps_left_ == 0 || --steps_left_ == 0) return false;
        // The node with least room: edges it may take beyond those it needs.
        GraphId node = kOutside;
        int least = 0;
        for (GraphId n = 0; n < open_.size(); ++n) {
            if (open_[n] == 0) continue;
            int room = stubs_[n] - need_[n];
            for (const GraphId e : edges_of_[n]) room += chosen_[e] == kUndecided;
            if (node == kOutside || room < least) {
                node = n;
                least = room;
            }
        }
        if (node == kOutside) return ends_left_ == 0;
        open_[node] = 0;
        std::vector<GraphId> free = undecided(node);
        if (random_ != 0)
            for (std::size_t i = free.size(); i > 1; --i) std::swap(free[i - 1], free[draw(i)]);
        for (const GraphId e : free) chosen_[e] = kOut;
        if (take(node, free, 0, need_[node])) return true;
        if (ends_left_ > 0 && need_[node] > 0) {
            --ends_left_;
            const std::size_t size = trail_.size();
            --need_[node];
            const int closed = join(node, kOutside);
            if (closed == 0 && take(node, free, 0, need_[node])) return true;
            undo(size);
            ++need_[node];
            ++ends_left_;
        }
        if (need_[node] == 2 && fixed_[node] == 0 && closed_ < most_) {
            ++closed_;
            const int need = std::exchange(need_[node], 0);
            if (choose()) return true;
            need_[node] = need;
            --closed_;
        }
        for (const GraphId e : free) chosen_[e] = kUndecided;
        open_[node] = 1;
        return false;
    }

    // Takes `count` more of the node's free edges from the i-th on, or stubs for the rest.
    bool take(GraphId node, const std::vector<GraphId>& free, std::size_t i, int count) {
        if (count == 0) return choose();
        const std::size_t size = trail_.size();
        for (; i < free.size(); ++i) {
            const GraphId e = free[i];
            const GraphId other = edges_[e].a == node ? edges_[e].b : edges_[e].a;
            if (open_[other] == 0 || need_[other] == 0) continue;
            const int closes = join(node, other);
            if (closed_ + closes <= most_) {
                closed_ += closes;
                --need_[other];
                const std::uint8_t fixed = std::exchange(fixed_[other], 1);
                chosen_[e] = kIn;
                if (take(node, free, i + 1, count - 1)) return true;
                chosen_[e] = kOut;
                fixed_[other] = fixed;
                ++need_[other];
                closed_ -= closes;
            }
            undo(size);
        }
        if (stubs_[node] < count) return false;
        for (int k = 0; k < count; ++k) join(node, kOutside);
        if (choose()) return true;
        undo(size);
        return false;
    }

    std::size_t draw(std::size_t below) {
        random_ = random_ * 1664525U + 1013904223U;
        return (std::uint64_t{random_} * below) >> 32;
    }

    std::uint32_t random_;  // 0 where choices are tried in order
    std::vector<Edge> edges_;
    std::vector<Choice> chosen_;
    std::vector<std::vector<GraphId>> edges_of_;
    std::vector<int> need_;            // edges that a node still takes
    std::vector<int> stubs_;           // edges out of the region that it may take
    std::vector<std::uint8_t> fixed_;  // it has an edge, so is no singleton
    std::vector<std::uint8_t> open_;   // not yet chosen for
    std::vector<GraphId> mate_;        // end of a fragment -> its other end
    std::vector<std::array<GraphId, 2>> trail_;
    int closed_ = 0, most_ = 0, ends_left_ = 0;
    std::size_t steps_left_ = 0;
};

// Nodes of a region and their places in it.
class Places {
  public:
    explicit Places(std::span<const GraphId> region) {
        for (GraphId i = 0; i < region.size(); ++i) sorted_.push_back({region[i], i});
        std::sort(sorted_.begin(), sorted_.end());
    }
    // kOutside for nodes that are not in the region.
    GraphId of(GraphId node) const {
        const auto found =
            std::lower_bound(sorted_.begin(), sorted_.end(), std::pair<GraphId, GraphId>{node, 0});
        return found != sorted_.end() && found->first == node ? found->second : kOutside;
    }

  private:
    std::vector<std::pair<GraphId, GraphId>> sorted_;
};

template <class Stub>
void add_edges(const Graph& graph, std::span<const GraphId> region, const Places& places,
               Search& search, const Stub& stub) {
    for (GraphId i = 0; i < region.size(); ++i) {
        for (const Arc& arc : graph.at(region[i])) {
            const GraphId other = places.of(arc.to);
            if (other == kOutside)
                stub(i);
            else if (graph.ends[arc.edge][0] == region[i])
                search.add_edge({i, other, arc.edge});
        }
    }
}

// What of the region's strips is as it is.
struct Outside {
    int closed = 0;     // strips that touch the region, and singletons in it
    int ends = 0;       // ends of a path that are in the region
    bool path = false;  // one touches it
};

Outside add_fragments(StripJoiner& joiner, std::span<const GraphId> region, Search& search) {
    struct Met {
        GraphId strip, rank, place;
    };
    std::vector<Met> met;
    for (GraphId i = 0; i < region.size(); ++i)
        met.push_back({joiner.strip_of(region[i]), joiner.rank(region[i]), i});
    std::sort(met.begin(), met.end(), [](const Met& a, const Met& b) {
        return a.strip != b.strip ? a.strip < b.strip : a.rank < b.rank;
    });
    Outside outside;
    for (std::size_t begin = 0, end = 0; begin < met.size(); begin = end) {
        while (end < met.size() && met[end].strip == met[begin].strip) ++end;
        const GraphId strip = met[begin].strip, size = joiner.size(strip);
        for (std::size_t i = begin; i + 1 < end; ++i)
            if (met[i].rank + 1 < met[i + 1].rank)
                search.add_fragment(met[i].place, met[i + 1].place);
        const Met &first = met[begin], &last = met[end - 1];
        if (joiner.is_open(strip)) {
            outside.path = true;
            outside.ends += (first.rank == 0) + (last.rank + 1 == size);
            if (first.rank > 0) search.add_fragment(kOutside, first.place);
            if (last.rank + 1 < size) search.add_fragment(last.place, kOutside);
            continue;
        }
        ++outside.closed;
        if (first.rank + size > last.rank + 1) search.add_fragment(last.place, first.place);
    }
    return outside;
}

}  // namespace

std::vector<GraphId> grow_region(const Graph& graph, std::span<const GraphId> start,
                                 std::size_t size, const std::vector<std::uint8_t>& barred) {
    std::vector<GraphId> region(start.begin(), start.end());
    struct Near {
        GraphId node;
        std::size_t edges;
    };
    std::vector<Near> near;
    const auto in_region = [&](GraphId node) {
        return std::find(region.begin(), region.end(), node) != region.end();
    };
    const auto see = [&](GraphId node) {
        for (const Arc& arc : graph.at(node)) {
            if (barred[arc.to] != 0 || graph.degree(arc.to) > kMostDegree || in_region(arc.to))
                continue;
            const auto known = std::find_if(near.begin(), near.end(),
                                            [&](const Near& n) { return n.node == arc.to; });
            if (known == near.end())
                near.push_back({arc.to, 1});
            else
                ++known->edges;
        }
    };
    for (const GraphId node : start) see(node);
    while (region.size() < size && !near.empty()) {
        // Fewest edges that would lead out: those to other nodes, less those it has inward.
        const auto best =
            std::min_element(near.begin(), near.end(), [&](const Near& a, const Near& b) {
                return graph.degree(a.node) + 2 * b.edges < graph.degree(b.node) + 2 * a.edges;
            });
        const GraphId node = best->node;
        near.erase(best);
        region.push_back(node);
        see(node);
    }
    return region;
}

bool merge_in_region(StripJoiner& joiner, std::span<const GraphId> region,
                     const RegionSearch& options, EdgeSet& set) {
    const Places places(region);
    Search search(region.size(), options.seed);
    add_edges(joiner.graph(), region, places, search, [](GraphId) {});
    const Outside now = add_fragments(joiner, region, search);
    const int most = options.sideways ? now.closed : now.closed - 1;
    const std::size_t steps = options.steps;
    bool found = search.run(most, now.ends, steps);
    // A path that is in the region with both its ends may close, a part without one may get one.
    if (!found && now.ends == 2) found = search.run(most + 1, 0, steps);
    if (!found && !options.part_has_path) found = search.run(most - 1, 2, steps);
    if (!found) return false;
    bool changed = false;
    for (std::size_t e = 0; e < search.edges().size(); ++e) {
        const std::uint8_t in = search.is_chosen(e) ? 1 : 0;
        changed |= std::exchange(set[search.edges()[e].id], in) != in;
    }
    return changed;
}

GraphId fewest_inside(const Graph& graph, std::span<const GraphId> region, int ends,
                      std::size_t steps) {
    const Places places(region);
    Search search(region.size());
    add_edges(graph, region, places, search, [&](GraphId i) { search.add_stub(i); });
    int most = 0;
    while (most < static_cast<int>(region.size()) && search.refutes(most, ends, steps)) ++most;
    return static_cast<GraphId>(most);
}

}  // namespace ravel
