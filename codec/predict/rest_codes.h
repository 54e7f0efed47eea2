// Codes of a number what is behind its whole part: digits behind the point, and the sign of zero.
// On either side: `Coder` writes or reads flags and plain bits.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "predict/numbers.h"
#include "predict/residual_context.h"

namespace ravel {

template <class Coder>
class RestCodes {
  public:
    RestCodes(Coder& coder, const NumberFormat& format) : coder_(coder), format_(format) {}

    // `guess`: of the value, if it may tell. False: a value no encoder writes.
    bool next(std::uint32_t axis, const double* guess, Number& n) {
        using C = ResidualContexts;
        const NumberFormat& f = format_;
        if (f.digits == 0) {
            n.rest = 0;
            if (n.whole == 0 && f.has_minus_zero)
                n.negative = minus_zero_[axis] =
                    coder_.flag(C::minus_zero.at(axis, minus_zero_[axis]), n.negative);
            else
                n.negative = false;
            return true;
        }
        int digits = rest_digits(f, n.whole);
        if (n.whole == 0) {
            const bool zero = coder_.flag(C::whole_zero.at(axis, was_zero_[axis]), n.rest == 0);
            was_zero_[axis] = zero;
            if (zero) {
                n.rest = 0;
                n.negative = f.has_minus_zero && coder_.flag(C::minus_zero.at(axis, 0), n.negative);
                return true;
            }
            n.negative = coder_.plain(n.negative, 1) != 0;
            int zeros = 0;
            while (zeros < kMostLeading &&
                   coder_.flag(C::leading.at(static_cast<std::uint32_t>(zeros)), zeros < n.zeros))
                ++zeros;
            n.zeros = zeros;
            if (f.base == NumberBase::decimal && f.places + zeros + digits > kMostPlaces)
                return false;
        } else if (digits == 0) {
            n.rest = 0;
            return true;
        } else if (guess != nullptr) {
            return next_by(*guess, axis, digits, n);
        } else {
            const auto d = static_cast<std::uint32_t>(digits);
            if (coder_.flag(C::rest_zero.at(d), n.rest == 0)) {
                n.rest = 0;
                return true;
            }
            if (f.base == NumberBase::decimal && f.places + digits > kMostPlaces) return false;
        }
        const int width =
            f.base == NumberBase::binary
                ? digits
                : static_cast<int>(std::bit_width(kTens[static_cast<std::size_t>(digits)] - 1));
        n.rest = coder_.plain(n.rest, width);
        return n.rest != 0 &&
               (f.base == NumberBase::binary || n.rest < kTens[static_cast<std::size_t>(digits)]);
    }

  private:
    // The rest as a residual of what lies behind the point of the guess.
    bool next_by(double guess, std::uint32_t axis, int digits, Number& n) {
        const NumberFormat& f = format_;
        const bool decimal = f.base == NumberBase::decimal;
        const std::uint64_t one =
            decimal ? kTens[static_cast<std::size_t>(digits)] : std::uint64_t{1} << digits;
        const double part = std::abs(guess) - static_cast<double>(magnitude(n.whole));
        // To the nearest, ties to even, as floats are rounded.
        const auto near =
            static_cast<std::uint64_t>((part * static_cast<double>(one) + 0x1p52) - 0x1p52);
        std::uint64_t& expected = rest_expected_[axis];
        const std::int64_t r =
            code_residual(coder_, scale_of(expected), static_cast<std::int64_t>(n.rest - near));
        expect(expected, std::min(magnitude(r), static_cast<std::uint64_t>(kMostWhole)));
        n.rest = near + static_cast<std::uint64_t>(r);
        return n.rest < one && (n.rest == 0 || !decimal || f.places + digits <= kMostPlaces);
    }

    Coder& coder_;
    const NumberFormat format_;
    std::array<bool, 3> minus_zero_{}, was_zero_{};
    std::array<std::uint64_t, 3> rest_expected_{};
};

}  // namespace ravel
