// The decoder's side of the walk: reads the answers, and the position of each new vertex on the
// way.
#pragma once

#include <vector>

#include "base/bytes.h"
#include "entropy/flag_decoder.h"
#include "entropy/priors.h"
#include "mesh/stencil.h"
#include "predict/position_codes.h"
#include "predict/priors.h"
#include "walk/walk.h"

namespace ravel {

// Reads flags and plain bits for code_residual.
struct ReadingCoder {
    static constexpr bool kWrites = false;
    FlagDecoder& in;
    std::vector<FlagModel> models =
        models_of(kResidualPriors, ResidualContexts::count, kResidualPriorSeen);
    bool flag(Context context, bool) { return in.flag(models[context]); }
    std::uint64_t plain(std::uint64_t, int count) { return in.plain(count); }
};

// The truths, which only the encoder knows, are constants here; they cost nothing once compiled.
class DecodeDriver {
  public:
    DecodeDriver(std::span<const std::byte> codes, PositionCodes<ReadingCoder>& positions,
                 const FlagDecoder& position_bits, std::vector<FlagModel> models, Context copy,
                 Context copy_number, Context flip, bool has_copies, bool has_flips,
                 bool keeps_stencils)
        : in_(codes),
          positions_(positions),
          position_bits_(position_bits),
          models_(std::move(models)),
          copy_(copy),
          copy_number_(copy_number),
          flip_(flip),
          has_copies_(has_copies),
          has_flips_(has_flips),
          has_stand_ins_(positions.format().has_stand_ins),
          keeps_stencils_(keeps_stencils) {}

    bool flag(Context context, bool) { return in_.flag(models_[context]); }
    std::uint64_t number(Context base, std::uint64_t) {
        std::uint32_t bits = 1;
        while (bits < kNumberSteps && flag(base + bits - 1, false)) ++bits;
        return (std::uint64_t{1} << (bits - 1) | in_.plain(static_cast<int>(bits) - 1)) - 1;
    }
    bool failed() const { return bad_ || in_.exhausted() || position_bits_.exhausted(); }
    bool finished() const { return in_.finished() && position_bits_.finished(); }

    void begin_cell(Id) {}
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
    const std::vector<Id>& copy_of() const { return copy_of_; }
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
    bool border(Id) const { return false; }

  private:
    void code_vertex(Id vertex, const Stencil& stencil) {
        Id of = kNone;
        if (has_copies_ && (last_was_copy_ = flag(copy_ + last_was_copy_, false))) {
            const std::int64_t first = static_cast<std::int64_t>(
                last_copied_ + static_cast<std::uint64_t>(unzigzag(number(copy_number_, 0))));
            if (first < 0 || first >= static_cast<std::int64_t>(vertex) ||
                copy_of_[static_cast<std::size_t>(first)] != kNone) {
                bad_ = true;
                positions_.next({}, {});
                copy_of_.push_back(kNone);
                return;
            }
            of = static_cast<Id>(first);
            last_copied_ = of;
        }
        if (has_copies_) copy_of_.push_back(of);
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
    const Context copy_, copy_number_, flip_;
    const bool has_copies_, has_flips_, has_stand_ins_, keeps_stencils_;
    std::vector<Stencil> stencils_;
    std::vector<Point3> places_;
    std::vector<Id> copy_of_;
    std::vector<std::uint8_t> flipped_;
    std::uint64_t last_copied_ = 0;
    bool last_was_copy_ = false, last_flip_ = false, bad_ = false;
};

}  // namespace ravel
