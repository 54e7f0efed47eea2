// Nodal vertex and edge processing [DiazGopi2005, 3.1]: around a fan of q cells whose facets are by
// turns in and out of the factor and whose q/2 strip edges belong to q/2 strips, toggling all q
// facets makes them one strip: each strip is opened at its edge and the other facets close the
// ring. One of the strips may be a path. Union-find tells strips apart. Every merge involves a
// strip that is not the majority of its component, so only cells of such strips are looked at, by
// strip edge and the fans that contain it.
// Cost: near-linear per pass; passes end when one changes nothing, and there are at most eight.
#include "strip/merge.h"

#include <array>
#include <utility>

#include "graph/cycles.h"
#include "graph/union_find.h"

namespace ravel {
namespace {

constexpr int kMaxPasses = 8;
constexpr std::size_t kMaxFan =
    64;  // larger fans cannot alternate among so many strips in practice

// Facets crossed when turning around one vertex (polygons) or edge (tets), each as seen from the
// cell it is left by; empty where the fan meets a border.
using Fan = std::vector<Id>;

// The fan around the vertex that `facet` starts at (from its own cell).
bool vertex_fan(const Complex& complex, Id facet, Fan& fan) {
    fan.clear();
    for (Id f = facet;;) {
        f = complex.prev_in_cell(f);
        const Id g = complex.twin[f];
        if (g == kNone || fan.size() == kMaxFan) return false;
        fan.push_back(f);
        if (g == facet) return true;
        f = g;
    }
}

// The fan around the edge of tet facet `facet` that lies opposite its corner `away`.
bool edge_fan(const Complex& complex, Id facet, Id away, Fan& fan) {
    fan.clear();
    Id left = facet, entered_opposite = away;
    std::array<Id, 2> edge{};
    {
        std::size_t n = 0;
        for (Id c = facet & ~Id{3}; c < (facet & ~Id{3}) + 4; ++c)
            if (c != facet && c != away) edge[n++] = complex.vertex[c];
    }
    for (;;) {
        const Id g = complex.twin[left];
        if (g == kNone || fan.size() == kMaxFan) return false;
        fan.push_back(left);
        // In the cell entered by g the fan goes on through the facet opposite the third corner of
        // g.
        Id exit = kNone;
        for (Id c = g & ~Id{3}; c < (g & ~Id{3}) + 4; ++c)
            if (c != g && complex.vertex[c] != edge[0] && complex.vertex[c] != edge[1]) exit = c;
        if (exit == kNone) return false;
        if (complex.cell_of[exit] == complex.cell_of[facet] && exit == facet &&
            g == entered_opposite)
            return true;
        if (exit == facet) return false;
        left = exit;
    }
}

class Merger {
  public:
    Merger(const Complex& complex, const Dual& dual, EdgeSet& set, StripList strips)
        : complex_(complex),
          dual_(dual),
          set_(set),
          strips_(std::move(strips)),
          parts_(dual.graph.parts),
          sets_(strips_.count()),
          part_size_(parts_.count, 0),
          open_(strips_.count(), 0) {
        for (GraphId s = 0; s < strips_.count(); ++s) {
            sets_.weigh(s, strips_.size(s));
            open_[s] = strips_.shape[s] == StripShape::path;
            any_open_ = any_open_ || open_[s] != 0;
        }
        for (const GraphId part : parts_.of) ++part_size_[part];
    }

    std::uint64_t run() {
        std::uint64_t total = 0;
        for (int pass = 0; pass < kMaxPasses; ++pass) {
            std::uint64_t merges = 0;
            for (GraphId s = 0; s < strips_.count(); ++s) {
                const GraphId end = strips_.first[s + 1];
                for (GraphId i = strips_.first[s]; i < end && !in_majority(strips_.node[i]); ++i)
                    merges += merge_at(strips_.node[i]);
            }
            total += merges;
            if (any_open_) total += absorb_at_path_ends();
            if (merges == 0) break;
        }
        return total;
    }

    std::uint64_t strips_left() {
        std::uint64_t count = 0;
        for (GraphId s = 0; s < strips_.count(); ++s) count += sets_.find(s) == s;
        return count;
    }

  private:
    GraphId strip_of(GraphId node) { return sets_.find(strips_.of[node]); }
    GraphId strip_at(Id facet) { return strip_of(dual_.node_of[complex_.cell_of[facet]]); }

    bool in_majority(GraphId node) {
        return 2 * std::uint64_t{sets_.size(strips_.of[node])} > part_size_[parts_.of[node]];
    }

    std::uint64_t merge_at(GraphId node) {
        const Id cell = dual_.cell_of[node];
        std::uint64_t merges = 0;
        for (Id f = complex_.first[cell]; f < complex_.first[cell + 1]; ++f) {
            if (complex_.kind == CellKind::polygon) {
                if (!is_strip(f)) continue;
                const Id g = complex_.twin[f];
                if (vertex_fan(complex_, f, fan_) && toggle()) {
                    ++merges;
                } else if (vertex_fan(complex_, g, fan_) && toggle()) {
                    ++merges;
                }
                continue;
            }
            for (Id i = 1; i < 4 && is_strip(f); ++i) {
                const Id away = (f & ~Id{3}) | ((f + i) & 3);
                if (edge_fan(complex_, f, away, fan_) && toggle()) ++merges;
            }
        }
        return merges;
    }

    bool is_strip(Id facet) const {
        return dual_.edge_of[facet] != kNone && set_[dual_.edge_of[facet]] != 0;
    }

    // Toggles the fan where that merges its strips.
    bool toggle() {
        if (fan_.size() < 4 || fan_.size() % 2 != 0) return false;
        for (std::size_t i = 0; i < fan_.size(); ++i)
            if (is_strip(fan_[i]) == is_strip(fan_[(i + 1) % fan_.size()])) return false;
        found_.clear();
        int paths = 0;
        for (const Id f : fan_) {
            if (!is_strip(f)) continue;
            const GraphId strip = strip_at(f);
            for (const GraphId other : found_)
                if (other == strip) return false;
            found_.push_back(strip);
            paths += open_[strip];
        }
        if (paths > 1) return false;
        for (const Id f : fan_) set_[dual_.edge_of[f]] ^= 1;
        for (const GraphId strip : found_) sets_.unite(found_[0], strip);
        open_[sets_.find(found_[0])] = paths == 1;
        return true;
    }

    // A path end x next to a cycle through y: drop an edge y-z of the cycle, add x-y, go on from z.
    std::uint64_t absorb_at_path_ends() {
        std::uint64_t count = 0;
        const std::vector<std::uint8_t> degree = degrees_in(dual_.graph, set_);
        for (GraphId start = 0; start < dual_.graph.node_count(); ++start) {
            if (degree[start] != 1) continue;
            for (GraphId end = start; end != kNoGraphId;) {
                end = absorb(end);
                if (end != kNoGraphId) ++count;
            }
        }
        return count;
    }

    GraphId absorb(GraphId end) {
        const GraphId own = strip_of(end);
        for (const Arc& out : dual_.graph.at(end)) {
            const GraphId other = strip_of(out.to);
            if (other == own || open_[other] != 0) continue;
            GraphId next = out.to;  // a singleton becomes the end itself
            for (const Arc& arc : dual_.graph.at(out.to)) {
                if (set_[arc.edge] == 0) continue;
                set_[arc.edge] = 0;
                next = arc.to;
                break;
            }
            set_[out.edge] = 1;
            sets_.unite(own, other);
            open_[sets_.find(own)] = 1;
            return next;
        }
        return kNoGraphId;
    }

    const Complex& complex_;
    const Dual& dual_;
    EdgeSet& set_;
    const StripList strips_;
    const Components& parts_;
    UnionFind sets_;
    std::vector<GraphId> part_size_;
    std::vector<std::uint8_t> open_;  // set of strips -> 1 where it is a path
    bool any_open_ = false;
    Fan fan_;
    std::vector<GraphId> found_;
};

}  // namespace

Merged merge_fans(const Complex& complex, const Dual& dual, EdgeSet set, StripList strips) {
    Merged merged{std::move(set), 0, 0};
    Merger merger(complex, dual, merged.set, std::move(strips));
    merged.fan_merges = merger.run();
    merged.strips = merger.strips_left();
    return merged;
}

}  // namespace ravel
