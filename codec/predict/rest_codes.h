// Codes of a number what is behind its whole part: digits behind the point, the sign of zero, or
// all bits of a float that is no such number. On either side: `Coder` writes or reads flags and
// plain bits.
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
    // `escape_bits`: of a float; 0 where none is escaped.
    RestCodes(Coder& coder, const NumberFormat& format, int escape_bits)
        : coder_(coder), format_(format), escape_bits_(escape_bits) {}

    // `guess`: of the value, if it may tell. False: a value no encoder writes.
    bool next(std::uint32_t axis, const double* guess, Number& n) {
        using C = ResidualContexts;
        const NumberFormat& f = format_;
        if (escape_bits_ > 0 && is_escaped(axis, n)) return true;
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
    // The bits are often those of the last one on the axis.
    bool is_escaped(std::uint32_t axis, Number& n) {
        using C = ResidualContexts;
        n.escaped = coder_.flag(C::escape.at(axis, was_escaped_[axis]), n.escaped);
        was_escaped_[axis] = n.escaped;
        if (!n.escaped) return false;
        std::uint64_t& last = escaped_[axis];
        if (!coder_.flag(C::escape_same.at(axis), n.rest == last))
            last = coder_.plain(n.rest, escape_bits_);
        n.rest = last;
        return true;
    }

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
    const int escape_bits_;
    std::array<bool, 3> minus_zero_{}, was_zero_{}, was_escaped_{};
    std::array<std::uint64_t, 3> escaped_{};
    std::array<std::uint64_t, 3> rest_expected_{};
};

}  // namespace ravel
