// The walk over tets. A tet entered through a front facet (x0, x1, x2) is told by its apex: the
// apex across one of the three edges (a fold), a new vertex, or an old one. [Gumhold1999] codes
// tets against such a front. Where the vertices lie says most about which it is: among the apexes
// across the edges and the front vertices near by, the one whose sphere through the entry facet
// lies lowest is asked for first, under contexts of that height and of how many edges fold onto it.
//
// Constant time per tet but for the hash; the search looks at a bounded number of vertices.
//
// Beside the truths the driver has
//     Point3 place(Id vertex)      where a visited vertex is, in integers
//
// Truths of the driver (about the tet being entered):
//     bool apex_is(Id vertex)      is its apex this visited vertex?
//     Id apex()                    its apex if visited, else kNone
//     bool glues(Id facet)         does the walk's facet meet the one it is asked about?
//     bool border(Id facet)        is there no tet across the walk's facet?
//     bool links_through(Id facet) bool leaves_through(Id facet)       (of the tet being left)
#pragma once

#include "walk/sphere_family.h"
#include "walk/tet_front.h"
#include "walk/vertex_grid.h"
#include "walk/walk.h"
#include "walk/wind.h"

namespace ravel {

template <class Driver>
class TetWalk {
  public:
    TetWalk(Driver& driver, const WalkLimits& limits)
        : driver_(driver),
          limits_(limits),
          front_(walked_.vertex),
          grid_(limits.grid_side, limits.grid_count) {
        walked_.kind = CellKind::tet;
        reserve(walked_, limits);
        front_.reserve(std::min<std::size_t>(limits.corners, limits.plausible));
    }

    // False: the answers contradict each other or the limits (only a decoder can see this).
    bool run() {
        while (walked_.cell_count() < limits_.cells)
            if (!visit(kNone, false) || !wind_component()) return false;
        return walked_.vertex_count == limits_.vertices;
    }

    const Walked& walked() const { return walked_; }
    Walked take() { return std::move(walked_); }

  private:
    enum State : std::uint8_t { open, border, gone };
    enum class Apex : std::uint8_t { fold, fresh, old };

    bool wind_component() {
        const auto leave = [&](Id cell, bool returned, bool& link, Id& out) {
            out = choose_exit(cell, returned, link);
            return !driver_.failed();
        };
        const auto enter = [&](Id out, bool link, Id& cell) {
            cell = walked_.cell_count();
            return visit(out, link);
        };
        return wind(walked_.cell_count() - 1, pending_, leave, enter);
    }

    // The rule: leave through the facet whose opposite vertex is oldest, so that the strip sheds
    // old vertices first.
    Id choose_exit(Id cell, bool returned, bool& link) {
        const Id base = 4 * cell;
        std::array<Id, 4> exits{};
        std::uint32_t count = 0;
        for (Id f = base; f < base + 4; ++f)
            if (state_[f] == open) {
                std::uint32_t i = count++;
                for (; i > 0 && walked_.vertex[exits[i - 1]] > walked_.vertex[f]; --i)
                    exits[i] = exits[i - 1];
                exits[i] = f;
            }
        if (count == 0) return kNone;
        bool any_link = false;
        for (std::uint32_t i = 0; i < count; ++i)
            any_link = any_link || driver_.links_through(exits[i]);
        link = driver_.flag(tet::kLink.at(returned, count - 1), any_link);
        for (std::uint32_t i = 0; i < count; ++i) {
            const Id f = exits[i];
            if (link && i + 1 == count) return f;
            const bool truth = link ? driver_.links_through(f) : driver_.leaves_through(f);
            if (driver_.flag(tet::kExit.at(i, count - i - 1, folded_sides(f), returned), truth))
                return f;
        }
        return kNone;
    }

    // How many edges of an open facet have been wound round far enough that the next tet may fold.
    std::uint32_t folded_sides(Id facet) const {
        std::uint32_t n = 0;
        for (Id e = 0; e < 3; ++e) n += front_.fan(3 * facet + e) >= 3;
        return n;
    }

    bool visit(Id gate, bool link) {
        if (walked_.cell_count() >= limits_.cells) return false;
        driver_.begin_cell(gate);
        const Id cell = walked_.cell_count(), base = 4 * cell;
        if (base + 4 > limits_.corners) return false;
        walked_.first.push_back(base + 4);
        walked_.gate.push_back(gate);
        walked_.by_link.push_back(link);
        walked_.cell_of.resize(base + 4, cell);
        walked_.vertex.resize(base + 4, kNone);
        walked_.twin.resize(base + 4, kNone);
        state_.resize(base + 4, gone);
        Apex kind = Apex::fresh;
        if (gate == kNone) {
            for (Id i = 0; i < 4; ++i) {
                Stencil stencil;
                const Id known = walked_.vertex_count;
                for (Id j = 0; j < 3 && j < known; ++j) stencil.at[j] = known - 1 - j;
                if (!add_vertex(base + i, stencil)) return false;
            }
            front_.add_seed(base);
        } else {
            if (!place(base, gate, kind)) return false;
        }
        for (Id f = base; f < base + (gate == kNone ? 4 : 3); ++f) make_front(f, kind);
        if (driver_.failed()) return false;
        driver_.end_cell(cell);
        return true;
    }

    bool add_vertex(Id corner, const Stencil& stencil) {
        if (walked_.vertex_count >= limits_.vertices) return false;
        const Id v = walked_.vertex_count++;
        walked_.vertex[corner] = v;
        on_border_.push_back(0);
        open_count_.push_back(0);
        driver_.new_vertex(v, corner - walked_.first[walked_.first.size() - 2], stencil);
        return true;
    }

    bool place(Id base, Id gate, Apex& kind) {
        auto& vertex = walked_.vertex;
        const Id back = gate & ~Id{3};
        for (Id i = 0; i < 3; ++i) vertex[base + i] = vertex[back + kOutward[gate & 3][i]];
        const Id apex = code_apex(base, gate, kind);
        if (kind == Apex::fresh) {
            Stencil stencil = stencil_of(Configuration::tet, {vertex[base], vertex[base + 1],
                                                              vertex[base + 2], vertex[gate]});
            for (Id k = 0; k < 3; ++k) stencil.at[4 + k] = front_.apex_across(3 * gate + k);
            if (!add_vertex(base + 3, stencil)) return false;
        } else {
            if (apex >= walked_.vertex_count) return false;
            for (Id i = 0; i < 3; ++i)
                if (vertex[base + i] == apex) return false;
            vertex[base + 3] = apex;
        }
        front_.erase(gate);
        closed(gate);
        state_[gate] = gone;
        walked_.twin[gate] = base + 3;
        walked_.twin[base + 3] = gate;
        front_.add_tet(base, gate);
        return true;
    }

    struct Candidate {
        Id vertex = kNone;
        double height = 0;   // of its sphere
        bool above = false;  // is it on the right side of the gate, and the gate no degenerate one?
        std::uint32_t times = 0;  // edges of the gate it folds onto
        std::uint32_t fan = 0;    // most tets round one of these
        bool beyond_border = false;
    };
    static bool before(const Candidate& a, const Candidate& b) {
        if (a.above != b.above) return a.above;
        return a.above ? a.height < b.height : a.times > b.times;
    }
    // Keeps the list sorted; equal ones stay in the order they came. What is beyond those asked for
    // is let go, or a crowd of vertices would make each tet cost the square of the crowd.
    static constexpr std::size_t kMostAsked = 12;
    void offer(const Candidate& candidate) {
        std::size_t i = list_.size();
        if (i == kMostAsked) {
            if (!before(candidate, list_.back())) return;
            list_[--i] = candidate;
        } else {
            list_.push_back(candidate);
        }
        for (; i > 0 && before(candidate, list_[i - 1]); --i) list_[i] = list_[i - 1];
        list_[i] = candidate;
    }
    static constexpr std::uint32_t kNotAbove = 13;
    std::uint32_t height_class(const SphereFamily& family, const Candidate& candidate) const {
        static constexpr std::array<double, 12> kBounds{-0.25, 0.0, 0.04, 0.12, 0.25, 0.45,
                                                        0.8,   1.4, 2.5,  5.0,  12.0, 60.0};
        if (!candidate.above) return kNotAbove;
        const double r = family.relative(candidate.height);
        std::uint32_t i = 0;
        while (i < kBounds.size() && r > kBounds[i]) ++i;
        return i;
    }
    bool in_gate(Id base, Id v) const {
        const Id* corner = walked_.vertex.data() + base;
        return v == corner[0] || v == corner[1] || v == corner[2];
    }

    Id code_apex(Id base, Id gate, Apex& kind) {
        const auto& vertex = walked_.vertex;
        const SphereFamily family(driver_.place(vertex[base]), driver_.place(vertex[base + 1]),
                                  driver_.place(vertex[base + 2]), limits_.mirrored);
        list_.clear();
        const std::uint32_t borders = offer_folds(base, gate, family);
        offer_near(base, family);
        const auto answer = [&](const Candidate& candidate) {
            kind = candidate.times > 0 ? Apex::fold : Apex::old;
            return candidate.vertex;
        };
        std::uint32_t height = kNotAbove, times = 0;
        if (!list_.empty()) {
            const Candidate& lowest = list_[0];
            height = height_class(family, lowest);
            times = lowest.times;
            const std::uint32_t fan = std::clamp<std::uint32_t>(lowest.fan, 1, 4) - 1;
            if (driver_.flag(tet::kLowest.at(height, times, fan, lowest.beyond_border),
                             driver_.apex_is(lowest.vertex)))
                return answer(lowest);
        }
        const Id truth = driver_.apex();
        if (driver_.flag(tet::kNew.at(height, times, borders), truth == kNone)) {
            kind = Apex::fresh;
            return kNone;
        }
        for (std::size_t i = 1; i < list_.size(); ++i) {
            const auto place = static_cast<std::uint32_t>(i - 1);
            if (driver_.flag(tet::kNext.at(place, list_[i].times, list_[i].above),
                             driver_.apex_is(list_[i].vertex)))
                return answer(list_[i]);
        }
        kind = Apex::old;
        const std::uint64_t age =
            driver_.number(tet::kOldFar.base, walked_.vertex_count - 1 - truth);
        return age >= walked_.vertex_count ? kNone
                                           : static_cast<Id>(walked_.vertex_count - 1 - age);
    }

    // The apexes across the gate's edges. Returns how many of them lie across borders.
    std::uint32_t offer_folds(Id base, Id gate, const SphereFamily& family) {
        std::uint32_t borders = 0;
        for (Id k = 0; k < 3; ++k) {
            const Id slot = 3 * gate + k, apex = front_.apex_across(slot);
            const std::uint32_t fan = front_.fan(slot);
            const bool beyond = state_[front_.mate(slot) / 3] == border;
            borders += beyond;
            if (open_count_[apex] == 0 || in_gate(base, apex)) continue;
            Candidate candidate;
            candidate.vertex = apex;
            candidate.beyond_border = true;
            const auto known = std::find_if(list_.begin(), list_.end(),
                                            [&](const Candidate& c) { return c.vertex == apex; });
            if (known != list_.end()) {
                candidate = *known;
                list_.erase(known);
            } else if (!family.flat()) {
                candidate.above = family.height_of(driver_.place(apex), candidate.height);
            }
            ++candidate.times;
            if (!beyond) candidate.fan = std::max(candidate.fan, fan);
            candidate.beyond_border = candidate.beyond_border && beyond;
            offer(candidate);
        }
        return borders;
    }

    // Front vertices inside the lowest sphere so far, or inside a rather high one. Where the sphere
    // is large beside the grid's cubes the search is not made, or ends early.
    void offer_near(Id base, const SphereFamily& family) {
        if (family.flat()) return;
        constexpr std::uint64_t kMostCubes = 1000;
        constexpr std::uint32_t kMostVertices = 1500;
        constexpr double kHighest = 9;
        double height = family.height_at(kHighest);
        if (!list_.empty() && list_[0].above && list_[0].height < height) height = list_[0].height;
        const Point3 centre = family.centre_at(height);
        const double radius = family.radius_at(height);
        std::array<std::uint32_t, 3> low{}, high{};
        std::uint64_t cubes = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = grid_.cube_of(centre[axis] - radius, axis);
            high[axis] = grid_.cube_of(centre[axis] + radius, axis);
            cubes *= high[axis] - low[axis] + std::uint64_t{1};
        }
        if (cubes > kMostCubes) return;
        std::uint32_t seen = 0;
        for (std::uint32_t z = low[2]; z <= high[2]; ++z)
            for (std::uint32_t y = low[1]; y <= high[1]; ++y)
                for (std::uint32_t x = low[0]; x <= high[0]; ++x)
                    for (Id v = grid_.first_in(x, y, z); v != kNone; v = grid_.next(v)) {
                        if (++seen > kMostVertices) return;
                        Candidate candidate;
                        candidate.vertex = v;
                        candidate.above = family.height_of(driver_.place(v), candidate.height);
                        if (!candidate.above || candidate.height > height || in_gate(base, v))
                            continue;
                        const bool known =
                            std::any_of(list_.begin(), list_.end(),
                                        [&](const Candidate& c) { return c.vertex == v; });
                        if (!known) offer(candidate);
                    }
    }

    // A vertex stands in the grid while an open facet has it.
    void opened(Id f) {
        for (Id e = 0; e < 3; ++e) {
            const Id v = front_.vertex_of_slot(3 * f + e);
            if (open_count_[v]++ == 0) grid_.insert(v, driver_.place(v));
        }
    }
    void closed(Id f) {
        for (Id e = 0; e < 3; ++e) {
            const Id v = front_.vertex_of_slot(3 * f + e);
            if (--open_count_[v] == 0) grid_.erase(v);
        }
    }

    // Facet f of the new tet meets a front facet, is a border, or joins the front.
    void make_front(Id f, Apex apex) {
        if (apex != Apex::fresh) {
            const Id other = front_.find(f);
            if (other != kNone) {
                if (driver_.flag(tet::kGlue.at(apex == Apex::fold), driver_.glues(f))) {
                    walked_.twin[f] = other;
                    walked_.twin[other] = f;
                    front_.erase(other);
                    closed(other);
                    state_[other] = gone;
                    front_.glue(f, other);
                } else {
                    // Only one gluing has these vertices, and it is still open.
                    become_border(f);
                }
                return;
            }
        }
        if (limits_.has_border) {
            std::uint32_t vertices = 0, flat = 0;
            for (Id e = 0; e < 3; ++e) {
                vertices += on_border_[front_.vertex_of_slot(3 * f + e)];
                const Id mate = front_.mate(3 * f + e) / 3;
                if (state_[mate] == border) flat = std::max(flat, flatness(f, mate));
            }
            if (driver_.flag(
                    tet::kBorder.at(flat, vertices, static_cast<std::uint32_t>(apex), f & 3),
                    driver_.border(f))) {
                become_border(f);
                return;
            }
        }
        state_[f] = open;
        front_.insert(f);
        opened(f);
    }

    Point3 normal_of(Id f) const {
        const Id base = f & ~Id{3};
        const auto& t = kOutward[f & 3];
        const Point3 a = driver_.place(walked_.vertex[base + t[0]]);
        return cross(minus(driver_.place(walked_.vertex[base + t[1]]), a),
                     minus(driver_.place(walked_.vertex[base + t[2]]), a));
    }
    // How nearly two facets lie in one plane: 1 for a fold back, 6 for flat.
    std::uint32_t flatness(Id f, Id g) const {
        const Point3 m = normal_of(f), n = normal_of(g);
        const double d = dot(m, n), square = dot(m, m) * dot(n, n);
        if (!(d > 0)) return 1;
        const double r = d * d;
        return r > 0.9999 * square ? 6
               : r > 0.99 * square ? 5
               : r > 0.9 * square  ? 4
               : r > 0.5 * square  ? 3
                                   : 2;
    }
    void become_border(Id f) {
        state_[f] = border;
        for (Id e = 0; e < 3; ++e) on_border_[front_.vertex_of_slot(3 * f + e)] = 1;
    }

    Driver& driver_;
    const WalkLimits limits_;
    Walked walked_;
    TetFront front_;
    VertexGrid grid_;
    std::vector<std::uint8_t> state_;        // per facet
    std::vector<std::uint8_t> on_border_;    // per vertex
    std::vector<std::uint32_t> open_count_;  // per vertex: open facets around it
    std::vector<Candidate> list_;            // of apexes, likeliest first
    std::vector<Id> pending_;
};

}  // namespace ravel
