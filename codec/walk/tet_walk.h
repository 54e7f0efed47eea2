// The walk over tets. A tet entered through a front triangle (x0, x1, x2) is told by its apex: the
// apex across one of the three edges (a fold), a new vertex, or an old one. [Gumhold1999] codes
// tets against such a front. Where the vertices lie says most about which it is: among the apexes
// across the edges and the front vertices near by, the one whose sphere through the entry facet
// lies lowest is asked for first, under contexts of that height and of how many edges fold onto it.
// Where tets repeat, an earlier gate like the one at hand tells even more.
//
// Constant time per tet but for the hash; the search looks at a bounded number of vertices.
//
// Truths of the driver (about the tet being entered):
//     bool apex_is(Id vertex)      is its apex this visited vertex?
//     Id apex()                    its apex if visited, else kNone
//     bool is_new_near(Point3, reach)   is its apex not visited, and lies near there?
//     bool glues(Id facet)         does the walk's facet meet the one it is asked about?
//     bool border(Id facet)        is there no tet across the walk's facet?
#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "walk/apex_list.h"
#include "walk/apex_search.h"
#include "walk/apex_signs.h"
#include "walk/border_signs.h"
#include "walk/leaders.h"
#include "walk/sphere_family.h"
#include "walk/tet_steps.h"
#include "walk/vertex_grid.h"
#include "walk/walk.h"

namespace ravel {

template <class Driver>
class TetWalk : public TetSteps<Driver> {
    using Base = TetSteps<Driver>;
    using Base::driver_, Base::front_, Base::limits_, Base::on_border_, Base::triangle_of_,
        Base::walked_;

  public:
    TetWalk(Driver& driver, const WalkLimits& limits)
        : Base(driver, limits), grid_(limits.grid_side, limits.grid_count) {
        const std::size_t vertices = std::min<std::size_t>(limits.vertices, limits.plausible);
        grid_.reserve(vertices);
        open_count_.reserve(vertices);
        if (limits.shape_step > 0) {
            leaders_.emplace(limits, vertices);
            leaders_->reserve(std::min<std::size_t>(limits.corners, limits.plausible));
        }
    }

    // False: the answers contradict each other or the limits (only a decoder can see this).
    bool run() {
        while (walked_.cell_count() < limits_.cells)
            if (!visit(kNone) || !wind_component()) return false;
        return this->end();
    }

  private:
    enum class Apex : std::uint8_t { fold, fresh, old };

    bool wind_component() {
        return wind(
            walked_, [&](Id cell) { return choose_exit(cell); },
            [&](Id out) { return visit(out); });
    }

    // The rule finishes what is nearly finished: most borders beside it first, then least open
    // triangles around its vertices, then the oldest vertex opposite.
    Id choose_exit(Id cell) {
        const Id base = 4 * cell;
        Id best = kNone;
        std::uint64_t least = 0;
        for (Id f = base; f < base + 4; ++f) {
            if (triangle_of_[f] == kNone) continue;
            const TetFront::Triangle& t = front_[triangle_of_[f]];
            std::uint64_t open = 0;
            for (Id e = 0; e < 3; ++e) {
                open += open_count_[t.vertex[e]];
                open += front_.across(t, e).border ? 0 : std::uint64_t{1} << 60;
            }
            if (best == kNone || open < least ||
                (open == least && walked_.vertex[f] < walked_.vertex[best]))
                best = f, least = open;
        }
        return this->leave(best);
    }

    bool visit(Id gate) {
        Id base = 0;
        if (!this->begin_cell(gate, base)) return false;
        if (gate == kNone ? !place_seed(base) : !place(base, gate)) return false;
        if (driver_.failed()) return false;
        driver_.end_cell(base / 4);
        return true;
    }

    bool place_seed(Id base) {
        std::array<Id, 4> made;
        if (!this->add_seed(base, made)) return false;
        open_count_.resize(walked_.vertex_count, 0);
        if (leaders_) leaders_->enter_seed();
        for (const Id triangle : made) make_front(triangle, Apex::fresh);
        return true;
    }

    bool place(Id base, Id gate) {
        auto& vertex = walked_.vertex;
        const Id entry = triangle_of_[gate];
        const TetFront::Triangle& t = front_[entry];
        for (Id i = 0; i < 3; ++i) vertex[base + i] = t.vertex[i];
        Apex kind = Apex::fresh;
        Id apex = kNone;
        const bool led = leaders_ && code_led(t, gate, kind, apex);
        if (!led) apex = code_apex(t, kind);
        if (kind == Apex::fresh) {
            if (!this->add_vertex(base + 3, stencil_at(t, vertex[gate], led))) return false;
            open_count_.push_back(0);
        } else {
            if (apex >= walked_.vertex_count || is_in(t.vertex, apex)) return false;
            vertex[base + 3] = apex;
        }
        if (leaders_) leaders_->enter_cell(walked_, base, led);
        this->go_through(gate, base);
        count(t, false);
        for (const Id made : front_.add_tet(entry, vertex[base + 3], base)) make_front(made, kind);
        return true;
    }

    Stencil stencil_at(const TetFront::Triangle& gate, Id behind, bool led) const {
        Stencil stencil = Base::stencil_at(gate, behind);
        if (!led) return stencil;
        stencil.configuration = Configuration::led;
        stencil.borders = 0;
        std::copy_n(leaders_->vertices().begin(), 5, stencil.at.begin() + 7);
        return stencil;
    }

    // Does the apex lie where the gate's leader has it, whether it is new or not?
    bool code_led(const TetFront::Triangle& gate, Id facet, Apex& kind, Id& apex) {
        if (!leaders_->find(walked_, facet,
                            [&](Id v) -> const Point3& { return driver_.place(v); }))
            return false;
        const Point3 there = leaders_->expected();
        const double reach = limits_.grid_side / 2;
        apex = nearest_on_front(grid_, gate.vertex, there, reach);
        const bool fresh = apex == kNone;
        const bool led =
            driver_.flag(leaders_->context(fresh),
                         fresh ? driver_.is_new_near(there, reach) : driver_.apex_is(apex));
        leaders_->learn(led);
        if (!fresh) kind = Apex::old;
        for (Id e = 0; e < 3 && !fresh; ++e)
            if (front_.apex_across(gate, e) == apex) kind = Apex::fold;
        return led;
    }

    Id code_apex(const TetFront::Triangle& gate, Apex& kind) {
        const SphereFamily family(driver_.place(gate.vertex[0]), driver_.place(gate.vertex[1]),
                                  driver_.place(gate.vertex[2]), limits_.mirrored);
        list_.clear(family.unit());
        const std::uint32_t borders = offer_folds(gate, family);
        if (!is_closed_in()) search_.offer_near(grid_, gate.vertex, family, list_);
        const auto answer = [&](const ApexCandidate& candidate) {
            kind = candidate.times > 0 ? Apex::fold : Apex::old;
            return candidate.vertex;
        };
        std::uint32_t height = kNotAbove, times = 0;
        if (!list_.empty()) {
            list_.lift_two();
            const ApexCandidate& lowest = list_[0];
            height = height_class(lowest, family.unit());
            times = lowest.times;
            const std::uint32_t gap = lowest.above ? gap_class(list_, family.unit()) : 3;
            const ApexSigns signs(points_of(gate), family, driver_.place(lowest.vertex));
            if (driver_.flag(tet::kLowest.at((height + 1) / 2, folds_class(lowest), gap,
                                             4 * signs.height() + signs.reach(limits_.grid_side)),
                             driver_.apex_is(lowest.vertex)))
                return answer(lowest);
        }
        const Id truth = driver_.apex();
        if (driver_.flag(tet::kNew.at(height, times, borders, second_class(list_, family.unit())),
                         truth == kNone)) {
            kind = Apex::fresh;
            return kNone;
        }
        list_.sort();
        for (std::size_t i = 1; i < list_.size(); ++i) {
            const auto place = static_cast<std::uint32_t>(i - 1);
            if (driver_.flag(tet::kNext.at(place, list_[i].times, list_[i].above),
                             driver_.apex_is(list_[i].vertex)))
                return answer(list_[i]);
        }
        kind = Apex::old;
        return code_far(gate, family, truth);
    }

    // Is an apex above, and across two edges? Then it is the one, nearly always.
    bool is_closed_in() const {
        for (std::size_t i = 0; i < list_.size(); ++i)
            if (list_[i].above && list_[i].times >= 2) return true;
        return false;
    }

    // The apexes across the gate's edges. Returns how many of them lie across borders.
    std::uint32_t offer_folds(const TetFront::Triangle& gate, const SphereFamily& family) {
        std::uint32_t borders = 0;
        for (Id e = 0; e < 3; ++e) {
            const Id apex = front_.apex_across(gate, e);
            const bool beyond = front_.across(gate, e).border;
            borders += beyond;
            if (open_count_[apex] == 0 || is_in(gate.vertex, apex)) continue;
            list_.change(apex, [&](ApexCandidate& candidate) {
                if (candidate.times == 0 && !family.flat()) {
                    const SphereFamily::Lift lift = family.lift_of(driver_.place(apex));
                    candidate.above = lift.above > 0;
                    candidate.height = candidate.above ? SphereFamily::height_of(lift) : 0;
                }
                ++candidate.times;
                if (!beyond) candidate.fan = std::max(candidate.fan, gate.fan[e]);
            });
        }
        return borders;
    }

    // An apex that is none of the list: by its rank among the front vertices in a large sphere,
    // then among those that only a larger one holds, or by its age.
    Id code_far(const TetFront::Triangle& gate, const SphereFamily& family, Id truth) {
        constexpr std::uint64_t kMostRanks = 64;
        const std::array<Id, ApexList::kMost> listed = list_.vertices();
        double above = -1e300;
        for (const double multiple : {4.0, 10.0}) {
            if (family.flat()) break;
            const double height = multiple * family.unit();
            std::span<ApexSearch::Near> far = search_.below(grid_, gate.vertex, family, height);
            far = far.first(static_cast<std::size_t>(
                std::remove_if(far.begin(), far.end(),
                               [&](const ApexSearch::Near& near) {
                                   bool is_listed = false;
                                   for (const Id v : listed) is_listed |= v == near.vertex;
                                   return is_listed || !(near.height > above);
                               }) -
                far.begin()));
            above = height;
            auto known = far.end();
            if (truth != kNone)
                known = std::find_if(far.begin(), far.end(), [&](const ApexSearch::Near& near) {
                    return near.vertex == truth;
                });
            std::uint64_t rank = kMostRanks;
            if (known != far.end())
                rank = static_cast<std::uint64_t>(
                    std::count_if(far.begin(), far.end(),
                                  [&](const ApexSearch::Near& near) { return near < *known; }));
            if (!driver_.flag(tet::kNear.at(0), rank < kMostRanks)) continue;
            rank = driver_.number(tet::kNearRank.base, rank);
            if (rank >= std::min<std::uint64_t>(kMostRanks, far.size())) return kNone;
            auto lowest = far.begin();
            for (std::uint64_t i = 0; i <= rank; ++i, ++lowest)
                std::iter_swap(lowest, std::min_element(lowest, far.end()));
            return (lowest - 1)->vertex;
        }
        const std::uint64_t age =
            driver_.number(tet::kOldFar.base, walked_.vertex_count - 1 - truth);
        return age >= walked_.vertex_count ? kNone
                                           : static_cast<Id>(walked_.vertex_count - 1 - age);
    }

    // Counts an open triangle in or out. A vertex stands in the grid while an open one has it.
    void count(const TetFront::Triangle& t, bool in) {
        for (const Id v : t.vertex) {
            if (in && open_count_[v]++ == 0) grid_.insert(v, driver_.place(v));
            if (!in && --open_count_[v] == 0) grid_.erase(v);
        }
    }

    // A triangle of the new tet meets a front triangle, is a border, or joins the front.
    void make_front(Id triangle, Apex apex) {
        const TetFront::Triangle& t = front_[triangle];
        const Id f = t.facet;
        if (apex != Apex::fresh) {
            const Id other = front_.find(triangle);
            if (other != kNone) {
                if (driver_.flag(tet::kGlue.at(apex == Apex::fold), driver_.glues(f))) {
                    count(t, false);
                    this->glue(triangle, other);
                } else {
                    // Only one gluing has these vertices, and it is still open.
                    this->become_border(triangle);
                }
                return;
            }
        }
        if (limits_.has_border && driver_.flag(border_context(t), driver_.border(f))) {
            this->become_border(triangle);
            return;
        }
        this->stay_open(triangle);
        count(t, true);
    }

    // Of the question whether a triangle, which a new tet has made, is a border.
    Context border_context(const TetFront::Triangle& t) const {
        const Id behind = walked_.vertex[t.facet];
        BorderSigns signs(points_of(t), driver_.place(behind), limits_.mirrored ? -1 : 1);
        for (Id e = 0; e < 3; ++e) {
            signs.vertices += on_border_[t.vertex[e]];
            const TetFront::Triangle& mate = front_.across(t, e);
            const Id apex = front_.apex_across(t, e);
            signs.meet(
                apex == behind ? signs.height_behind() : signs.height_of(driver_.place(apex)),
                mate.border, [&] { return points_of(mate); });
        }
        const bool bordered = on_border_[behind] != 0;
        const Id like = leaders_ ? leaders_->like(t.facet) : kNone;
        if (like == kNone)
            return tet::kBorder.at(signs.around(), signs.valley, bordered,
                                   signs.shape(limits_.grid_side));
        const bool led = walked_.twin[like] == kNone && triangle_of_[like] == kNone;
        return tet::kLedBorder.at(led, signs.around(), signs.valley, bordered);
    }
    std::array<Point3, 3> points_of(const TetFront::Triangle& t) const {
        return {driver_.place(t.vertex[0]), driver_.place(t.vertex[1]), driver_.place(t.vertex[2])};
    }
    VertexGrid grid_;
    std::vector<std::uint32_t> open_count_;  // per vertex: open triangles around it
    ApexList list_;
    ApexSearch search_;
    std::optional<Leaders> leaders_;
};

}  // namespace ravel
