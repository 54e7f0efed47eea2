// Coordinates as whole numbers of a unit, and what is finer than the unit. A grid has whole numbers
// alone. Lossless coordinates are decimals (most text files hold decimals of few digits: the idea
// of [AfroozehBoncz2024], with digits beyond the unit) or binary fractions of few bits.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace ravel {

enum class NumberBase : std::uint8_t { grid, decimal, binary };

// The unit is base^-places. With digits > 0 every number has that many significant digits: where
// its whole part has fewer, the others follow the point.
struct NumberFormat {
    NumberBase base = NumberBase::grid;
    int places = 0;  // decimal: 0..22
    int digits = 0;  // decimal: up to 17, binary: up to 53
    bool has_minus_zero = false;

    bool operator==(const NumberFormat&) const = default;
};

inline constexpr int kMostPlaces = 22;  // 10^22 is a double, 10^23 is not
inline constexpr int kMostBinaryPlaces = 1200;
inline constexpr int kMostLeading = 63;  // zeros behind the point
inline constexpr std::int64_t kMostWhole = std::int64_t{1} << 53;

// |value| in units is |whole| + rest * base^-(digits behind the point). A whole part of 0 has
// `zeros` zeros between point and rest, rest starts with a digit that is not 0, and `negative`
// tells the sign (that of zero, too). A coordinate that is no such number is `escaped`: the whole
// part, which is near it if that can be, stands for it, and `rest` has the bits of the float.
struct Number {
    std::int64_t whole = 0;
    std::uint64_t rest = 0;
    int zeros = 0;
    bool negative = false;
    bool escaped = false;

    bool operator==(const Number&) const = default;
};

// Powers of ten. Filled when the program starts, as Rates are (entropy/flag_model.h).
template <class T, std::size_t kCount>
struct Tens : std::array<T, kCount> {
    Tens() {
        T t = 1;  // as a double too each product is exact
        for (T& x : *this) x = t, t *= 10;
    }
};
inline const Tens<std::uint64_t, 20> kTens;
inline const Tens<double, kMostPlaces + 1> kTensAsDoubles;

inline std::uint64_t magnitude(std::int64_t r) {
    return r < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(r) : static_cast<std::uint64_t>(r);
}

// Digits of n in the base; none for 0.
inline int digits_of(std::uint64_t n, NumberBase base) {
    if (base == NumberBase::binary) return static_cast<int>(std::bit_width(n));
    int d = 0;
    while (d < 20 && n >= kTens[static_cast<std::size_t>(d)]) ++d;
    return d;
}

// Digits of the rest.
inline int rest_digits(const NumberFormat& format, std::int64_t whole) {
    const int d = format.digits - digits_of(magnitude(whole), format.base);
    return d > 0 ? d : 0;
}

// About how many bits they take.
inline int rest_bits(const NumberFormat& format, std::int64_t whole) {
    const int digits = rest_digits(format, whole);
    return format.base == NumberBase::decimal ? (10 * digits + 2) / 3 : digits;
}

// Rounded as floats are, whatever its exponent, by its bits. GCC 12 leaves the conversion to float
// and back out where it makes vectors of it.
inline double to_24_bits(double x) {
    std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    bits += 0x0FFFFFFF + (bits >> 29 & 1);  // ties to even
    return std::bit_cast<double>(bits & ~std::uint64_t{0x1FFFFFFF});
}

struct Scaled {
    double units;  // the value in units, near enough to predict from
    double exact;  // the value
};

// Needs places + zeros + digits of the rest to be at most kMostPlaces for decimals. Of an escaped
// one its whole part.
inline Scaled scaled_of(const NumberFormat& format, const Number& n) {
    if (n.escaped) return scaled_of(format, {n.whole, 0, 0, false, false});
    if (format.base == NumberBase::grid) {
        const auto units = static_cast<double>(n.whole);
        return {units, units};
    }
    const bool negative = n.whole < 0 || (n.whole == 0 && n.negative);
    const std::uint64_t m = magnitude(n.whole);
    const int digits = rest_digits(format, n.whole);
    Scaled s{};
    if (format.base == NumberBase::decimal) {
        const auto behind = static_cast<std::size_t>(n.rest == 0 ? 0 : digits + n.zeros);
        const double all = static_cast<double>(
            n.rest == 0 ? m : m * kTens[static_cast<std::size_t>(digits)] + n.rest);
        s.units = all / kTensAsDoubles[behind];
        s.exact = all / kTensAsDoubles[behind + static_cast<std::size_t>(format.places)];
    } else {
        s.units = static_cast<double>(m);
        if (n.rest != 0) s.units += std::ldexp(static_cast<double>(n.rest), -digits - n.zeros);
        s.exact = std::ldexp(s.units, -format.places);
    }
    if (negative) s.units = -s.units, s.exact = -s.exact;
    return s;
}

}  // namespace ravel
