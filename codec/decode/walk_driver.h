// The decoder's side of the walk: reads the answers, and the position of each new vertex on the
// way.
#pragma once

#include <optional>
#include <vector>

#include "container/head.h"
#include "entropy/flag_decoder.h"
#include "entropy/priors.h"
#include "mesh/stencil.h"
#include "predict/position_codes.h"
#include "predict/priors.h"
#include "predict/residual_models.h"
#include "walk/copies.h"
#include "walk/precedents.h"
#include "walk/walk.h"

namespace ravel {

// Reads flags and plain bits for code_residual.
struct ReadingCoder {
    static constexpr bool kWrites = false;
    FlagDecoder& in;
    std::vector<FlagModel> models =
        with_size_kinds(models_of(kResidualPriors, ResidualContexts::count, kResidualPriorSeen));
    bool flag(Context context, bool) { return in.flag(models[context]); }
    std::uint64_t plain(std::uint64_t, int count) { return in.plain(count); }
    std::uint64_t rice(std::uint64_t, int count) { return in.rice(count); }
};

// The truths, which only the encoder knows, are constants here; they cost nothing once compiled.
class DecodeDriver {
  public:
    DecodeDriver(std::span<const std::byte> codes, PositionCodes<ReadingCoder>& positions,
                 const FlagDecoder& position_bits, std::vector<FlagModel> models, CellKind kind,
                 const BlockHead& block, bool keeps_stencils)
        : in_(codes),
          positions_(positions),
          position_bits_(position_bits),
          models_(std::move(models)),
          copies_(kind, block.has_copies ? block.vertices : 0),
          flip_(kind == CellKind::tet ? tet::kFlip.base : surface::kFlip.base),
          has_copies_(block.has_copies),
          has_flips_(block.has_flips),
          has_stand_ins_(positions.format().has_stand_ins),
          keeps_stencils_(keeps_stencils) {
        if (block.has_precedents) precedents_.emplace(block.cells, block.corners);
    }

    bool flag(Context context, bool) {
        const auto read = [&](FlagModel& model, bool) { return in_.flag(model); };
        return precedents_ ? precedents_->flag(models_, context, false, read)
                           : in_.flag(models_[context]);
    }
    std::uint64_t number(Context base, std::uint64_t) {
        std::uint32_t bits = 1;
        while (bits < kNumberSteps && flag(base + bits - 1, false)) ++bits;
        return (std::uint64_t{1} << (bits - 1) | in_.plain(static_cast<int>(bits) - 1)) - 1;
    }
    bool failed() const { return bad_ || in_.exhausted() || position_bits_.exhausted(); }
    bool finished() const { return in_.finished() && position_bits_.finished(); }

    void begin_cell(Id gate) {
        if (precedents_) precedents_->begin_cell(gate == kNone);
    }
    void new_vertex(Id vertex, Id, const Stencil& stencil) {
        code_vertex(vertex, stencil);
        if (has_stand_ins_)
            places_.push_back(place_of(positions_.format(), positions_.values().back()));
    }
    const Point3& place(Id vertex) const {
        return has_stand_ins_ ? places_[vertex] : positions_.values()[vertex];
    }
    void end_cell(Id) {
        if (!has_flips_) return;
        last_flip_ = flag(flip_ + last_flip_, false);
        flipped_.push_back(last_flip_);
    }

    // Per vertex the earlier one at the same point, or kNone; empty where there are no copies.
    const std::vector<Id>& copy_of() const { return copies_.of(); }
    const std::vector<std::uint8_t>& flipped() const { return flipped_; }
    // Of the vertices that are no copies, where they are kept.
    std::vector<Stencil> take_stencils() { return std::move(stencils_); }

    Id degree() const { return 0; }
    bool zips(Id) const { return false; }
    bool is_new(Id) const { return false; }
    Id gap(Id, bool&) const { return kNone; }
    bool apex_is(Id) const { return false; }
    Id apex() const { return kNone; }
    bool is_new_near(const Point3&, double) const { return false; }
    bool glues(Id) const { return false; }
    bool meets(Id) const { return true; }
    bool border(Id) const { return false; }

  private:
    void code_vertex(Id vertex, const Stencil& stencil) {
        const Id of = has_copies_ ? copies_.next(*this, vertex, stencil, kNone) : kNone;
        if (of == vertex) {
            bad_ = true;
            positions_.next({}, {});
            return;
        }
        if (of != kNone) {
            positions_.copy(of);
            return;
        }
        if (!positions_.next(stencil, {})) bad_ = true;
        if (keeps_stencils_) stencils_.push_back(stencil);
    }

    FlagDecoder in_;
    PositionCodes<ReadingCoder>& positions_;
    const FlagDecoder& position_bits_;
    std::vector<FlagModel> models_;
    std::optional<Precedents> precedents_;
    Copies copies_;
    const Context flip_;
    const bool has_copies_, has_flips_, has_stand_ins_, keeps_stencils_;
    std::vector<Stencil> stencils_;
    std::vector<Point3> places_;
    std::vector<std::uint8_t> flipped_;
    bool last_flip_ = false, bad_ = false;
};

}  // namespace ravel
