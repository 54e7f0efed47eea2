// Gates that lead others. Where tets repeat, the apex beyond a gate lies as it lay beyond an
// earlier gate like it, its leader, carried over with the tet before. A cell that was told by its
// leader is like the cell that the leader led to, and so its gates have theirs there; a gate whose
// cell is like none is led by the last of its shape.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/carry.h"
#include "mesh/stencil.h"
#include "walk/contexts.h"
#include "walk/gate_shapes.h"
#include "walk/tet_front.h"
#include "walk/walk.h"

namespace ravel {

class Leaders {
  public:
    Leaders(const WalkLimits& limits, std::size_t vertices)
        : shapes_(limits.shape_step, vertices),
          square_(limits.grid_side * limits.grid_side),
          maps_(!limits.leaders_move) {}

    void reserve(std::size_t corners) { like_.reserve(corners); }

    // Looks for the leader of a gate, a facet of the walk, which may lead others from now on. False
    // if there is none. Constant time.
    template <class Place>
    bool find(const Walked& walked, Id facet, const Place& place) {
        const auto& triple = kOutward[facet & 3];
        Leader own{facet, {}};
        std::array<Id, 3> gate{};
        for (std::size_t i = 0; i < 3; ++i) {
            own.corner[i] = (facet & ~Id{3}) + triple[i];
            gate[i] = walked.vertex[own.corner[i]];
        }
        const Id behind = walked.vertex[facet];
        last_ = &shapes_.enter(gate, behind, own, leader_, place);
        const Id like = like_[facet];
        goes_on_ = like != kNone && walked.twin[like] != kNone;
        if (goes_on_) {
            leader_.facet = like;
            for (std::size_t i = 0; i < 3; ++i) leader_.corner[i] = like_[own.corner[i]];
        }
        if (leader_.facet == kNone) return false;
        for (std::size_t i = 0; i < 3; ++i) vertex_[i] = walked.vertex[leader_.corner[i]];
        vertex_[3] = walked.vertex[leader_.facet];
        vertex_[4] = walked.vertex[walked.twin[leader_.facet]];
        const Frame from{place(vertex_[0]), place(vertex_[1]), place(vertex_[2]),
                         place(vertex_[3])};
        const Frame to{place(gate[0]), place(gate[1]), place(gate[2]), place(behind)};
        expected_ = carried(place(vertex_[4]), from, to, maps_);
        mismatch_ = class_of(mismatch(from, to));
        return true;
    }

    // Of the leader that was found: where it has the apex; its gate's corners, the apex behind it
    // and that beyond it.
    const Point3& expected() const { return expected_; }
    const std::array<Id, 5>& vertices() const { return vertex_; }
    Context context(bool fresh) const {
        const std::uint32_t misses = goes_on_ ? 8 + (missed_on_ & 7) : last_->missed & 7;
        return tet::kLed.at(misses, missed_ & 3, fresh, mismatch_);
    }
    // Whether it has led right.
    void learn(bool right) {
        std::uint32_t& missed = goes_on_ ? missed_on_ : last_->missed;
        missed = missed << 1 | !right;
        missed_ = missed_ << 1 | !right;
    }

    // The facet that one of a cell that was led is like, or kNone.
    Id like(Id facet) const { return like_[facet]; }
    // After each cell: which corner each of its corners is like, if it was led.
    void enter_seed() { like_.resize(like_.size() + 4, kNone); }
    void enter_cell(const Walked& walked, Id base, bool led) {
        like_.resize(base + std::size_t{4}, kNone);
        if (!led) return;
        const Id entry = walked.twin[leader_.facet];
        like_[base + 3] = entry;
        for (Id i = 0; i < 3; ++i)
            for (Id c = entry & ~Id{3}; c < (entry & ~Id{3}) + 4; ++c)
                if (walked.vertex[c] == vertex_[i]) like_[base + i] = c;
    }

  private:
    // Rounding alone makes ends of edges differ by up to two on each axis.
    std::uint32_t class_of(double square) const {
        return square <= 12 ? 0 : square < square_ / 256 ? 1 : square < square_ / 16 ? 2 : 3;
    }

    GateShapes shapes_;
    double square_;         // of the side of the grid's cubes
    bool maps_;             // see carried()
    std::vector<Id> like_;  // per corner of the walk, or kNone
    GateShapes::Last* last_ = nullptr;
    Leader leader_;
    std::array<Id, 5> vertex_{};
    bool goes_on_ = false;  // from the cell before, rather than by shape
    Point3 expected_{};
    std::uint32_t mismatch_ = 0;
    std::uint32_t missed_ = 0, missed_on_ = 0;  // bit k: k gates ago; of those that went on
};

}  // namespace ravel
