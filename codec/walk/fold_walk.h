// The walk over tets by folds: what the front looks like tells which apex is likely, not where its
// vertices lie. That takes more codes than TetWalk's and a fraction of its time. A tet entered
// through a front triangle is told by its apex: the one across the edge that most tets are around
// (a fold), a new vertex, or one of those near by on the front, in the order in which a search from
// triangle to triangle meets them. [Gumhold1999] codes tets against such a front.
//
// Constant time per tet but for the hash; the search looks at a bounded number of triangles.
//
// Truths of the driver: apex and border, see TetWalk, and
//     bool meets(Id facet)     does the walk's facet meet the open triangle that has its vertices?
//                              This walk is for meshes where all do.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "walk/front_search.h"
#include "walk/tet_steps.h"
#include "walk/walk.h"

namespace ravel {

template <class Driver>
class FoldWalk : public TetSteps<Driver> {
    using Base = TetSteps<Driver>;
    using Base::driver_, Base::front_, Base::limits_, Base::on_border_, Base::triangle_of_,
        Base::walked_;

  public:
    FoldWalk(Driver& driver, const WalkLimits& limits) : Base(driver, limits) {}

    // False: the answers contradict each other or the limits (only a decoder can see this), or the
    // mesh is not one for this walk (only an encoder).
    bool run() {
        while (walked_.cell_count() < limits_.cells)
            if (!visit(kNone) || !wind_component()) return false;
        return this->end();
    }

  private:
    static constexpr Id kFresh = kNone - 1;  // an apex that is a new vertex

    bool wind_component() {
        return wind(
            walked_, [&](Id cell) { return choose_exit(cell); },
            [&](Id out) { return visit(out); });
    }

    // Where most tets are around the edges, so that folds close them one after the other.
    Id choose_exit(Id cell) {
        const Id* const open = &triangle_of_[4 * cell];
        Id best = kNone;
        if ((open[0] & open[1] & open[2] & open[3]) != kNone) {
            // Of as many the first; nobody foresees which.
            unsigned most = 0;
            for (Id i = 0; i < 4; ++i) {
                const auto& fan = front_[open[i] == kNone ? 0 : open[i]].fan;
                const unsigned tets = open[i] == kNone ? 0 : unsigned{fan[0]} + fan[1] + fan[2];
                most = std::max(most, 4 * tets + 3 - i);
            }
            best = 4 * cell + 3 - (most & 3);
        }
        return this->leave(best);
    }

    bool visit(Id gate) {
        Id base = 0;
        if (!this->begin_cell(gate, base)) return false;
        if (gate == kNone ? !place_seed(base) : !place(base, gate)) return false;
        if (failed_ || driver_.failed()) return false;
        driver_.end_cell(base / 4);
        return true;
    }

    bool place_seed(Id base) {
        if (!this->add_seed(base, left_)) return false;
        left_count_ = 4;
        make_front(true);
        return true;
    }

    bool place(Id base, Id gate) {
        auto& vertex = walked_.vertex;
        const Id entry = triangle_of_[gate];
        const TetFront::Triangle& t = front_[entry];
        for (Id i = 0; i < 3; ++i) vertex[base + i] = t.vertex[i];
        Id edge = kNone;
        const Id apex = code_apex(entry, t, edge);
        const bool fresh = apex == kFresh;
        if (fresh) {
            if (!this->add_vertex(base + 3, this->stencil_at(t, vertex[gate]))) return false;
        } else {
            if (apex >= walked_.vertex_count || is_in(t.vertex, apex)) return false;
            vertex[base + 3] = apex;
        }
        this->go_through(gate, base);
        const auto made = front_.add_tet(entry, vertex[base + 3], base);
        left_count_ = 0;
        // Nobody foresees across which edge a fold is; so that triangle is not looked for.
        if (edge != kNone) {
            glue(made[edge], front_.beyond(made[edge]));
            for (Id k = 1; k < 3; ++k)
                left_[left_count_++] = made[FrontSearch::edge_after(edge, k)];
        } else {
            for (const Id triangle : made) left_[left_count_++] = triangle;
        }
        if (!fresh) glue_left();
        make_front(fresh);
        return true;
    }

    // `edge`: the one of a fold that is likely, if it is that; the triangle across it is open.
    Id code_apex(Id entry, const TetFront::Triangle& gate, Id& edge) {
        // The edge that most tets are around; none where there is a border beyond.
        std::array<Id, 3> across;
        std::array<std::uint32_t, 3> tets;
        std::uint32_t borders = 0;
        for (Id e = 0; e < 3; ++e) {
            across[e] = front_.apex_across(gate, e);
            const std::uint32_t border = front_.across(gate, e).border;
            tets[e] = border != 0 ? 0 : gate.fan[e];
            borders += border;
        }
        // Of as many the first; nobody foresees which.
        const Id first = 2 - (std::max({4 * tets[0] + 2, 4 * tets[1] + 1, 4 * tets[2]}) & 3);
        const Id fold = across[first];
        const Id truth = driver_.apex();
        std::uint32_t second = 0, times = 0;
        for (Id e = 0; e < 3; ++e) {
            if (e != first) second = std::max(second, tets[e]);
            times += across[e] == fold;
        }
        if (!is_in(gate.vertex, fold) &&
            driver_.flag(tet::kFold.at(tets[first], second, times - 1, borders), truth == fold)) {
            if (tets[first] > 0) edge = first;
            return fold;
        }
        std::uint32_t beside = 0;
        for (const Id v : gate.vertex) beside += on_border_[v];
        if (driver_.flag(tet::kFoldNew.at(tets[first], second, borders, beside), truth == kNone))
            return kFresh;
        const Id rank = code_rank(gate, first, search_.rank_of(front_, entry, first, truth));
        if (rank < FrontSearch::kMost) return search_.at_rank(front_, entry, first, rank);
        const std::uint64_t age =
            driver_.number(tet::kFoldAge.base, walked_.vertex_count - 1 - truth);
        return age >= walked_.vertex_count ? kNone
                                           : static_cast<Id>(walked_.vertex_count - 1 - age);
    }

    // The place of an old apex in the search beside the edge.
    Id code_rank(const TetFront::Triangle& gate, Id edge, Id truth) {
        std::uint32_t borders = 0;
        for (Id i = 1; i < 3; ++i)
            borders += i * front_.across(gate, FrontSearch::edge_after(edge, i)).border;
        const Context near = tet::kFoldNear.at(borders);
        if (!driver_.flag(near, truth < FrontSearch::kNear)) {
            const std::uint64_t more =
                driver_.number(tet::kFoldRank.base, truth - FrontSearch::kNear);
            return static_cast<Id>(
                std::min<std::uint64_t>(more + FrontSearch::kNear, FrontSearch::kMost));
        }
        Id node = 1;
        for (int bit = 2; bit >= 0; --bit)
            node = 2 * node + driver_.flag(near + node, (truth >> bit & 1) != 0);
        return node - FrontSearch::kNear;
    }

    // Those of `left_` that meet an open triangle leave it.
    void glue_left() {
        std::size_t left = 0;
        for (std::size_t i = 0; i < left_count_; ++i) {
            const Id other = front_.find(left_[i]);
            if (other == kNone)
                left_[left++] = left_[i];
            else
                glue(left_[i], other);
        }
        left_count_ = left;
    }

    // A triangle of the new tet meets the open one that has its vertices.
    void glue(Id triangle, Id other) {
        if (!driver_.meets(front_[triangle].facet)) failed_ = true;
        Base::glue(triangle, other);
    }

    // The triangles of `left_` are borders or join the front. Those that no border is near are
    // asked about together.
    void make_front(bool fresh) {
        std::array<std::uint32_t, 4> contact{};
        std::uint32_t apart = 0;
        if (limits_.has_border) {
            for (std::size_t i = 0; i < left_count_; ++i) {
                contact[i] = contact_of(front_[left_[i]]);
                apart += contact[i] < 2;
            }
        }
        bool any_apart = false;
        if (apart > 0) {
            bool truth = false;
            for (std::size_t i = 0; i < left_count_; ++i)
                truth |= contact[i] < 2 && driver_.border(front_[left_[i]].facet);
            any_apart = driver_.flag(tet::kFoldBorders.at(apart, fresh), truth);
        }
        for (std::size_t i = 0; i < left_count_; ++i) {
            const Id triangle = left_[i];
            if (limits_.has_border && (any_apart || contact[i] >= 2) &&
                driver_.flag(tet::kFoldBorder.at(contact[i]),
                             driver_.border(front_[triangle].facet)))
                this->become_border(triangle);
            else
                this->stay_open(triangle);
        }
    }

    // How near a triangle is to borders.
    std::uint32_t contact_of(const TetFront::Triangle& t) const {
        std::uint32_t vertices = 0, mates = 0, fan = 0;
        for (Id e = 0; e < 3; ++e) {
            vertices += on_border_[t.vertex[e]];
            const bool border = front_.across(t, e).border;
            mates += border;
            fan = std::max(fan, border ? std::uint32_t{t.fan[e]} : 0u);
        }
        return mates == 0 ? vertices : 4 + 6 * (mates - 1) + std::min(fan, 6u) - 1;
    }

    FrontSearch search_;
    bool failed_ = false;
    std::array<Id, 4> left_{};  // of the new tet: triangles that met none
    std::size_t left_count_ = 0;
};

}  // namespace ravel
