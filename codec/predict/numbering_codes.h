// Codes numbers of which each comes once: old places of points, cells, companions, tuples. Where
// the order makes sense the next number follows from those before, by a step that came after the
// same steps, by one, or by what is beside; elsewhere it is told among the numbers that are left.
// On either side: `Coder` writes or reads.
#pragma once

#include <algorithm>
#include <vector>

#include "predict/rank_tree.h"
#include "predict/tuple_codes.h"

namespace ravel {

template <class Coder>
class NumberingCodes {
  public:
    // Numbers 0 .. `numbers` - 1, of which `count` come.
    NumberingCodes(Coder& coder, Id numbers, Id count)
        : coder_(coder), left_(numbers), echo_(count) {
        steps_.reserve(count);
        sizes_.reserve(count);
    }

    // Sets `number`; `guess` is what it may be near, or none. `near`: elements coded before whose
    // guesses missed by about as much. False: no encoder writes this.
    bool code(const double* guess, const Stencil& near, Id truth, Id& number) {
        if (left_.left() == 0) return false;
        const auto is = [&](Id candidate, Context context) {
            if (!left_.has(candidate)) return false;
            number = candidate;
            return coder_.flag(context, Coder::kWrites && truth == candidate);
        };
        const Id echoed = echo_.at() == kNone ? kNone : last_ + steps_[echo_.at()];  // steps wrap
        const Id rank = left_.below(last_ + 1);  // none is the last of all
        const Id next = left_.at(rank < left_.left() ? rank : 0);
        const bool whole = guess != nullptr && std::isfinite(*guess);
        const auto guessed = static_cast<std::int64_t>(
            whole ? std::floor(std::clamp(*guess, 0.0, 0x1p32) + 0.5) : static_cast<double>(last_));
        using C = AttributeContexts;
        std::uint32_t way = 0;
        if (is(echoed, C::number_echo.at(echo_.held())))
            way = 1;
        else if (next != echoed && is(next, C::number_next.at(ways_)))
            way = 2;
        else if (whole && guessed != next && guessed != echoed &&
                 is(static_cast<Id>(std::min<std::int64_t>(guessed, kNone)),
                    C::number_guess.at(ways_)))
            way = 3;
        ways_ = (ways_ << 2 | way) & 15;
        if (way == 0) return code_far(near, guessed, truth, number);
        sizes_.push_nothing();
        done(number);
        return true;
    }

    Id told() const { return static_cast<Id>(steps_.size()); }

  private:
    bool code_far(const Stencil& near, std::int64_t guessed, Id truth, Id& number) {
        sizes_.begin(near);
        const std::int64_t r = std::int64_t{truth} - guessed;
        const auto width = static_cast<int>(std::bit_width(left_.left() - 1));
        was_near_ = coder_.flag(
            AttributeContexts::number_near.at(was_near_),
            Coder::kWrites && static_cast<int>(std::bit_width(magnitude(r))) + 2 < width);
        if (was_near_) {
            const std::int64_t missed = code_residual(coder_, sizes_.scale(0, 0), r);
            sizes_.coded(0, magnitude(missed));
            const auto found =
                static_cast<std::uint64_t>(guessed) + static_cast<std::uint64_t>(missed);
            if (found >= kNone || !left_.has(static_cast<Id>(found))) return false;
            number = static_cast<Id>(found);
            sizes_.push();
        } else {
            const auto below = Coder::kWrites ? left_.below(truth) : 0;
            const auto rank = static_cast<Id>(code_below(below));
            if (rank >= left_.left()) return false;
            number = left_.at(rank);
            sizes_.push_half();
        }
        done(number);
        return true;
    }
    // One of so many as are left, in truncated binary.
    std::uint64_t code_below(Id rank) {
        const Id size = left_.left();
        if (size <= 1) return 0;
        const auto width = static_cast<int>(std::bit_width(size - 1));
        const std::uint64_t brief = (std::uint64_t{1} << width) - size;
        // The writer's value is as the reader puts it together.
        const std::uint64_t code = rank < brief ? rank : rank + brief;
        const std::uint64_t front = coder_.plain(rank < brief ? code : code >> 1, width - 1);
        if (front < brief) return front;
        return (front << 1 | coder_.plain(code & 1, 1)) - brief;
    }
    void done(Id number) {
        left_.take(number);
        steps_.push_back(number - last_);
        last_ = number;
        echo_.next(steps_, static_cast<Id>(steps_.size() - 1));
    }

    Coder& coder_;
    RankTree left_;
    std::vector<Id> steps_;
    TupleEcho echo_;
    ResidualSizes sizes_;
    Id last_ = kNone;         // so that 0 is next
    std::uint32_t ways_ = 0;  // in which the last two were found
    bool was_near_ = false;
};

}  // namespace ravel
