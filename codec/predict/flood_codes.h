// Codes tuples that are constant on parts of the mesh: a part is flooded from its first element,
// link by link (facets of cells, edges of triangles), with a yes or no for each element it comes
// to. So elements within a part cost next to nothing, and its walls (links where it ends) are told
// by the walls around: they go on, mostly straight on. On either side: `Coder` writes or reads.
#pragma once

#include <vector>

#include "predict/tuple_codes.h"

namespace ravel {

inline constexpr std::uint32_t kMostWallClasses = 21;
inline constexpr Id kMostLinks = 16;  // looked at, of an element that is reached

// Elements and their links. A link that leads to another element has a twin there.
class FloodGraph {
  public:
    explicit FloodGraph(std::size_t links) : walls_(links, 0) {}
    FloodGraph(const FloodGraph&) = delete;
    FloodGraph& operator=(const FloodGraph&) = delete;
    virtual ~FloodGraph() = default;

    virtual Id size() const { return 0; }
    virtual Id begin(Id) const { return 0; }  // its links are begin .. end - 1
    virtual Id end(Id) const { return 0; }
    virtual Id twin(Id) const { return kNone; }  // kNone where it leads nowhere
    virtual Id element_of(Id) const { return 0; }
    // How the walls go on about a link of a known element, below kMostWallClasses.
    virtual std::uint32_t walls_about(Id, const std::vector<std::uint8_t>&) const { return 0; }

    // Walls of earlier floods are remembered: what ends at them may end there again.
    void start() {
        for (std::uint8_t& w : walls_) w = w != 0 ? kFormer : 0;
        note_start();
    }
    void set_wall(Id link) {
        walls_[link] |= kWall;
        walls_[twin(link)] |= kWall;
        note_wall(link);
    }
    void set_former(Id link) {
        walls_[link] |= kFormer;
        if (twin(link) != kNone) walls_[twin(link)] |= kFormer;
    }
    void remember(const FloodGraph& other) { walls_ = other.walls_; }
    bool is_wall(Id link) const { return (walls_[link] & kWall) != 0; }
    bool was_wall(Id link) const { return (walls_[link] & kFormer) != 0; }

    // For graphs that look at walls in another way.
    virtual void note_start() {}
    virtual void note_wall(Id) {}

  private:
    static constexpr std::uint8_t kWall = 1, kFormer = 2;
    std::vector<std::uint8_t> walls_;
};

// `tuple` has the writer's numbers before, numbers by use after. Linear. `Graph`: a FloodGraph; a
// final class is asked without detours.
template <class Coder, class Graph>
bool flood(Coder& coder, TupleCodes<Coder>& codes, Graph& graph, std::vector<Id>& tuple) {
    const Id size = graph.size();
    std::vector<std::uint8_t> known(size, 0);
    std::vector<Id> queue;
    Candidates candidates;
    graph.start();
    for (Id first = 0; first < size; ++first) {
        if (known[first]) continue;
        // Whoever is next to it has been flooded and did not go on to it.
        candidates.clear();
        bool refused = first == 0;
        for (Id f = graph.begin(first); f < graph.end(first) && !refused; ++f) {
            const Id g = graph.twin(f);
            refused = g != kNone && known[graph.element_of(g)] &&
                      tuple[graph.element_of(g)] == tuple[first - 1];
        }
        if (!refused) candidates.add(tuple[first - 1], 0, 0);
        if (!codes.code(candidates, 0, tuple[first], tuple[first])) return false;
        known[first] = 1;
        queue.assign(1, first);
        for (std::size_t head = 0; head < queue.size(); ++head) {
            const Id from = queue[head];
            for (Id f = graph.begin(from); f < graph.end(from); ++f) {
                const Id g = graph.twin(f);
                if (g == kNone) continue;
                const Id to = graph.element_of(g);
                if (known[to]) {
                    if (tuple[to] != tuple[from]) graph.set_wall(f);
                    continue;
                }
                std::uint32_t with = 0, against = 0;
                bool walled = false;
                // Elements of very many links are seen in part: the time stays linear.
                const Id most = std::min(graph.end(to), graph.begin(to) + kMostLinks);
                for (Id h = graph.begin(to); h < most; ++h) {
                    const Id i = graph.twin(h);
                    if (i == kNone || !known[graph.element_of(i)]) continue;
                    const bool same = tuple[graph.element_of(i)] == tuple[from];
                    ++(same ? with : against);
                    walled = walled || (same && graph.is_wall(h));
                }
                if (walled) {
                    graph.set_wall(f);
                    continue;
                }
                const bool goes_on = coder.flag(
                    AttributeContexts::flood.at(std::max(with, 1u) - 1, against,
                                                graph.walls_about(f, known), graph.was_wall(f)),
                    Coder::kWrites && codes.number_of(tuple[to]) == tuple[from]);
                if (!goes_on) {
                    graph.set_wall(f);
                    continue;
                }
                tuple[to] = tuple[from];
                known[to] = 1;
                queue.push_back(to);
            }
        }
    }
    return true;
}

}  // namespace ravel
