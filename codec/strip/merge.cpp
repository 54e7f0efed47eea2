// Nodal vertex and edge processing [DiazGopi2005, 3.1]: around a fan of q cells whose facets are by
// turns in and out of the factor and whose q/2 strip edges belong to q/2 strips, toggling all q
// facets makes them one strip: each strip is opened at its edge and the other facets close the
// ring. One of the strips may be a path. Union-find tells strips apart. Every merge involves a
// strip that is not the majority of its component, so only cells of such strips are looked at, by
// strip edge and the fans that contain it.
// Cost: near-linear per pass; passes end when one changes nothing, and there are at most eight.
#include "strip/merge.h"

#include <array>

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
    Merger(const Complex& complex, const Dual& dual, StripJoiner& joiner)
        : complex_(complex), dual_(dual), joiner_(joiner), strips_(joiner.strips()) {
        for (GraphId s = 0; s < strips_.count() && strips_.shape[s] == StripShape::path; ++s) {
            ends_.push_back(strips_.node[strips_.first[s]]);
            ends_.push_back(strips_.node[strips_.first[s + 1] - 1]);
        }
    }

    std::uint64_t run() {
        const std::uint64_t before = joiner_.strips_left();
        for (int pass = 0; pass < kMaxPasses; ++pass) {
            const std::uint64_t left = joiner_.strips_left();
            for (GraphId s = 0; s < strips_.count(); ++s) {
                const GraphId end = strips_.first[s + 1];
                for (GraphId i = strips_.first[s]; i < end && !joiner_.in_majority(s); ++i)
                    merge_at(strips_.node[i]);
            }
            const bool merged = joiner_.strips_left() != left;
            absorb_at_path_ends();
            if (!merged) break;
        }
        return before - joiner_.strips_left();
    }

  private:
    void merge_at(GraphId node) {
        const Id cell = dual_.cell_of[node];
        for (Id f = complex_.first[cell]; f < complex_.first[cell + 1]; ++f) {
            if (!is_strip(f)) continue;
            if (complex_.kind == CellKind::polygon) {
                if (vertex_fan(complex_, f, fan_) && toggle()) continue;
                if (vertex_fan(complex_, complex_.twin[f], fan_)) toggle();
                continue;
            }
            for (Id i = 1; i < 4 && is_strip(f); ++i) {
                const Id away = (f & ~Id{3}) | ((f + i) & 3);
                if (edge_fan(complex_, f, away, fan_)) toggle();
            }
        }
    }

    GraphId node_at(Id facet) const { return dual_.node_of[complex_.cell_of[facet]]; }
    bool is_strip(Id facet) const {
        return dual_.edge_of[facet] != kNone && joiner_.in_set(dual_.edge_of[facet]);
    }

    // Toggles the fan where it is a ring that meets each strip once.
    bool toggle() {
        const std::size_t q = fan_.size();
        if (q < 4 || q % 2 != 0) return false;
        for (std::size_t i = 0; i < q; ++i)
            if (is_strip(fan_[i]) == is_strip(fan_[(i + 1) % q])) return false;
        found_.clear();
        for (std::size_t i = is_strip(fan_[0]) ? 0 : 1; i < q; i += 2) {
            const GraphId strip = joiner_.strip_of(node_at(fan_[i]));
            for (const GraphId other : found_)
                if (other == strip) return false;
            found_.push_back(strip);
        }
        ring_.clear();
        for (std::size_t i = is_strip(fan_[0]) ? 0 : 1; i < q; i += 2)
            ring_.push_back({dual_.edge_of[fan_[i]], dual_.edge_of[fan_[(i + 1) % q]],
                             node_at(fan_[i]), node_at(complex_.twin[fan_[i]])});
        return joiner_.toggle(ring_);
    }

    // A path end x next to a cycle through y: drop an edge y-z of the cycle, add x-y, go on from z.
    void absorb_at_path_ends() {
        for (GraphId& end : ends_)
            for (GraphId at = end; at != kNoGraphId; at = absorb(at)) end = at;
    }

    GraphId absorb(GraphId end) {
        const GraphId own = joiner_.strip_of(end);
        for (const Arc& arc : dual_.graph.at(end)) {
            const GraphId other = joiner_.strip_of(arc.to);
            if (other != own && !joiner_.is_open(other))
                return joiner_.absorb(end, arc.edge, arc.to);
        }
        return kNoGraphId;
    }

    const Complex& complex_;
    const Dual& dual_;
    StripJoiner& joiner_;
    const StripList& strips_;
    std::vector<GraphId> ends_;  // of paths
    Fan fan_;
    std::vector<GraphId> found_;
    std::vector<RingLink> ring_;
};

}  // namespace

std::uint64_t merge_fans(const Complex& complex, const Dual& dual, StripJoiner& joiner) {
    return Merger(complex, dual, joiner).run();
}

}  // namespace ravel
