// The walk over tets. A tet entered through a front facet (x0, x1, x2) is told by its apex: the apex
// across one of the three edges (a fold), a new vertex, or an old one. [Gumhold1999] codes tets
// against such a front; the fan counts as contexts are the volume's counterpart of corner counts.
//
// Constant time per tet but for the hash.
//
// Truths of the driver (about the tet being entered):
//     bool apex_is(Id vertex)      is its apex this visited vertex?
//     Id apex()                    its apex if visited, else kNone
//     bool glues(Id facet)         does the walk's facet meet the one it is asked about?
//     bool border(Id facet)        is there no tet across the walk's facet?
//     bool links_through(Id facet) bool leaves_through(Id facet)       (of the tet being left)
#pragma once

#include "walk/tet_front.h"
#include "walk/walk.h"

namespace ravel {

template <class Driver>
class TetWalk {
  public:
    TetWalk(Driver& driver, const WalkLimits& limits)
        : driver_(driver), limits_(limits), front_(walked_.vertex) {
        walked_.kind = CellKind::tet;
        reserve(walked_, limits);
        front_.reserve(std::min<std::size_t>(limits.corners, limits.plausible));
    }

    // False: the answers contradict each other or the limits (only a decoder can see this).
    bool run() {
        while (walked_.cell_count() < limits_.cells)
            if (!visit(kNone, false) || !wind()) return false;
        return walked_.vertex_count == limits_.vertices;
    }

    const Walked& walked() const { return walked_; }
    Walked take() { return std::move(walked_); }

  private:
    enum State : std::uint8_t { open, border, gone };
    enum class Apex : std::uint8_t { fold, fresh, old };
    struct Candidate {
        Id vertex;
        std::uint32_t slot, fan, times;
        bool beyond_border;
    };

    bool wind() {
        pending_.clear();
        Id cell = walked_.cell_count() - 1;
        bool returned = false;
        for (;;) {
            bool link = false;
            const Id out = choose_exit(cell, returned, link);
            if (driver_.failed()) return false;
            if (out == kNone) {
                if (pending_.empty()) return true;
                cell = pending_.back();
                pending_.pop_back();
                returned = true;
                continue;
            }
            if (link) pending_.push_back(cell);
            if (!visit(out, link)) return false;
            cell = walked_.cell_count() - 1;
            returned = false;
        }
    }

    // The rule: leave through the facet whose opposite vertex is oldest, so that the strip sheds old
    // vertices first.
    Id choose_exit(Id cell, bool returned, bool& link) {
        const Id base = 4 * cell;
        std::array<Id, 4> exits{};
        std::uint32_t count = 0;
        for (Id f = base; f < base + 4; ++f)
            if (state_[f] == open) {
                std::uint32_t i = count++;
                for (; i > 0 && walked_.vertex[exits[i - 1]] > walked_.vertex[f]; --i) exits[i] = exits[i - 1];
                exits[i] = f;
            }
        if (count == 0) return kNone;
        bool any_link = false;
        for (std::uint32_t i = 0; i < count; ++i) any_link = any_link || driver_.links_through(exits[i]);
        link = driver_.flag(tet::kLink.at(returned, count - 1), any_link);
        for (std::uint32_t i = 0; i < count; ++i) {
            const Id f = exits[i];
            if (link && i + 1 == count) return f;
            const bool truth = link ? driver_.links_through(f) : driver_.leaves_through(f);
            if (driver_.flag(tet::kExit.at(i, count - i - 1, folded_sides(f), returned), truth)) return f;
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
        driver_.new_vertex(v, corner - walked_.first[walked_.first.size() - 2], stencil);
        return true;
    }

    bool place(Id base, Id gate, Apex& kind) {
        auto& vertex = walked_.vertex;
        const Id back = gate & ~Id{3};
        for (Id i = 0; i < 3; ++i) vertex[base + i] = vertex[back + kOutward[gate & 3][i]];
        const Id apex = code_apex(base, gate, kind);
        if (kind == Apex::fresh) {
            Stencil stencil{Configuration::tet, {vertex[base], vertex[base + 1], vertex[base + 2], vertex[gate]}};
            for (Id k = 0; k < 3; ++k) stencil.at[4 + k] = front_.apex_across(3 * gate + k);
            if (!add_vertex(base + 3, stencil)) return false;
        } else {
            if (apex >= walked_.vertex_count) return false;
            for (Id i = 0; i < 3; ++i)
                if (vertex[base + i] == apex) return false;
            vertex[base + 3] = apex;
        }
        front_.erase(gate);
        state_[gate] = gone;
        walked_.twin[gate] = base + 3;
        walked_.twin[base + 3] = gate;
        front_.add_tet(base, gate);
        return true;
    }

    Id code_apex(Id base, Id gate, Apex& kind) {
        std::array<Candidate, 3> list{};
        std::uint32_t count = 0, borders = 0, most_fan = 0;
        for (Id k = 0; k < 3; ++k) {
            const Id slot = 3 * gate + k, apex = front_.apex_across(slot), fan = front_.fan(slot);
            const bool beyond = state_[front_.mate(slot) / 3] == border;
            borders += beyond;
            if (!beyond) most_fan = std::max(most_fan, fan);
            bool known = false;
            for (Id i = 0; i < 3; ++i) known = known || walked_.vertex[base + i] == apex;
            if (known) continue;
            std::uint32_t i = 0;
            while (i < count && list[i].vertex != apex) ++i;
            if (i < count) {
                ++list[i].times;
                list[i].fan = std::max(list[i].fan, fan);
                list[i].beyond_border = list[i].beyond_border && beyond;
            } else {
                list[count++] = {apex, slot, fan, 1, beyond};
            }
        }
        // Likeliest first; equal ones stay in the order of the gate's edges.
        const auto before = [](const Candidate& a, const Candidate& b) {
            if (a.times != b.times) return a.times > b.times;
            if (a.beyond_border != b.beyond_border) return b.beyond_border;
            return a.fan > b.fan;
        };
        for (std::uint32_t i = 1; i < count; ++i)
            for (std::uint32_t j = i; j > 0 && before(list[j], list[j - 1]); --j)
                std::swap(list[j], list[j - 1]);
        for (std::uint32_t i = 0; i < count; ++i)
            if (driver_.flag(tet::kFold.at(i, list[i].fan - 1, list[i].beyond_border, list[i].times - 1),
                             driver_.apex_is(list[i].vertex))) {
                kind = Apex::fold;
                return list[i].vertex;
            }
        const Id truth = driver_.apex();
        if (driver_.flag(tet::kNew.at(borders, count, most_fan >= 4 ? 2 : most_fan >= 3), truth == kNone)) {
            kind = Apex::fresh;
            return kNone;
        }
        kind = Apex::old;
        return code_old(base, gate, list, count, truth);
    }

    // An old vertex that is no fold: looked for on the front around the gate, ring by ring, then by age.
    Id code_old(Id base, Id gate, const std::array<Candidate, 3>& asked, std::uint32_t asked_count, Id truth) {
        constexpr std::size_t kNear = 32, kFacets = 48;
        near_.clear();
        ring_.assign(1, gate);
        for (std::size_t head = 0; head < ring_.size() && ring_.size() < kFacets; ++head)
            for (Id e = 0; e < 3; ++e) {
                const Id mate = front_.mate(3 * ring_[head] + e), facet = mate / 3;
                if (std::find(ring_.begin(), ring_.end(), facet) != ring_.end()) continue;
                ring_.push_back(facet);
                const Id v = front_.vertex_of_slot(mate);
                bool known = std::find(near_.begin(), near_.end(), v) != near_.end();
                for (Id i = 0; i < 3; ++i) known = known || walked_.vertex[base + i] == v;
                for (std::uint32_t i = 0; i < asked_count; ++i) known = known || asked[i].vertex == v;
                if (!known && near_.size() < kNear) near_.push_back(v);
            }
        const bool is_near = std::find(near_.begin(), near_.end(), truth) != near_.end();
        if (!near_.empty() && driver_.flag(tet::kOldIsNear.at(0), is_near)) {
            for (std::uint32_t i = 0; i + 1 < near_.size(); ++i)
                if (driver_.flag(tet::kOldNear.at(i), driver_.apex_is(near_[i]))) return near_[i];
            return near_.back();
        }
        const std::uint64_t age = driver_.number(tet::kOldFar.base, walked_.vertex_count - 1 - truth);
        return age >= walked_.vertex_count ? kNone : static_cast<Id>(walked_.vertex_count - 1 - age);
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
            std::uint32_t vertices = 0, borders = 0;
            for (Id e = 0; e < 3; ++e) {
                vertices += on_border_[front_.vertex_of_slot(3 * f + e)];
                borders += state_[front_.mate(3 * f + e) / 3] == border;
            }
            if (driver_.flag(tet::kBorder.at(borders, vertices, static_cast<std::uint32_t>(apex)),
                             driver_.border(f))) {
                become_border(f);
                return;
            }
        }
        state_[f] = open;
        front_.insert(f);
    }

    void become_border(Id f) {
        state_[f] = border;
        for (Id e = 0; e < 3; ++e) on_border_[front_.vertex_of_slot(3 * f + e)] = 1;
    }

    Driver& driver_;
    const WalkLimits limits_;
    Walked walked_;
    TetFront front_;
    std::vector<std::uint8_t> state_;       // per facet
    std::vector<std::uint8_t> on_border_;   // per vertex
    std::vector<Id> pending_, near_, ring_;
};

}  // namespace ravel
