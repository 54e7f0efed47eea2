#include "encode/numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "base/float32.h"

namespace ravel {
namespace {

constexpr double kBitsOfTen = 3.3219280948873623;
// What a coordinate costs that does not fit, about; and at most one in so many may be such.
// `told`: which part of all coordinates is told digit by digit; others are those of other points.
struct Misfits {
    double bits;
    std::size_t fewest;
    double told;
};

// The shortest decimal that reads as x: mantissa * 10^-places, without zeros at the end behind the
// point.
struct Decimal {
    std::uint64_t mantissa = 0;
    int places = 0;  // not negative
    int digits = 0;  // of the mantissa
    bool fits = false;
};

Decimal shortest_decimal(double x, Scalar scalar) {
    char text[40];
    const double a = std::abs(x);
    const auto end =
        scalar == Scalar::f32
            ? std::to_chars(text, text + sizeof text, static_cast<float>(a),
                            std::chars_format::scientific)
                  .ptr
            : std::to_chars(text, text + sizeof text, a, std::chars_format::scientific).ptr;
    Decimal d;
    const char* at = text;
    int exponent = 0;
    for (; at != end && *at != 'e'; ++at) {
        if (*at == '.') continue;
        d.mantissa = d.mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
        ++d.digits;
    }
    if (at != end) {
        ++at;
        const bool negative = *at == '-';
        for (++at; at != end; ++at) exponent = exponent * 10 + (*at - '0');
        if (negative) exponent = -exponent;
    }
    d.places = d.digits - 1 - exponent;
    for (; d.places < 0 && d.digits < 17; ++d.places, ++d.digits) d.mantissa *= 10;
    d.fits = d.places >= 0;
    return d;
}

// Mantissa of as many bits as it needs, in front of the point `exponent` of them.
struct Binary {
    int exponent = 0, digits = 0;
};

Binary binary_of(double x) {
    Binary b;
    const double m = std::frexp(std::abs(x), &b.exponent);
    const auto whole = static_cast<std::uint64_t>(std::ldexp(m, 53));
    b.digits = 53 - std::countr_zero(whole);
    return b;
}

// How many of the sampled coordinates have each number of places and of digits.
struct Counts {
    std::vector<std::size_t> by_places, by_digits, by_front;  // front: digits before the point
    std::size_t numbers = 0, misfits = 0;
    double fronts = 0;  // sum, of binary ones

    explicit Counts(std::size_t most) : by_places(most), by_digits(80), by_front(most) {}
};

constexpr int kMiddle = 1100;  // fronts and binary places may be negative

// The number of places (digits) that costs least; coordinates with more of them are misfits, which
// must be few and cost their whole parts, too. `least` is infinite where there is none.
template <class Cost>
int cheapest(const std::vector<std::size_t>& counts, int low, int high, std::size_t misfits,
             const Misfits& price, const Cost& bits_of, double& least) {
    std::size_t above = misfits;
    for (const std::size_t n : counts) above += n;
    const std::size_t all = above;
    int best = low;
    least = INFINITY;
    for (int k = 0; k <= high; ++k) {
        above -= counts[static_cast<std::size_t>(k)];
        if (k < low || above * price.fewest > all) continue;
        const double bits = bits_of(k) * price.told * static_cast<double>(all) +
                            price.bits * static_cast<double>(above);
        if (bits < least) least = bits, best = k;
    }
    return best;
}

// The greatest front but for a thousandth of the coordinates.
int most_front(const Counts& counts) {
    std::size_t left = counts.numbers / 1000;
    int front = static_cast<int>(counts.by_front.size()) - 1;
    for (; front > 0; --front) {
        const std::size_t n = counts.by_front[static_cast<std::size_t>(front)];
        if (n > left) break;
        left -= n;
    }
    return front - kMiddle;
}

std::optional<Number> decimal_number(const NumberFormat& f, double x, Scalar scalar) {
    Number n;
    if (x == 0) {
        n.negative = std::signbit(x);
        return n;
    }
    const Decimal d = shortest_decimal(x, scalar);
    if (!d.fits) return {};
    const auto tens = [](int e) { return kTens[static_cast<std::size_t>(e)]; };
    std::uint64_t whole = 0;
    if (d.places <= f.places) {
        const int more = f.places - d.places;
        if (more + d.digits > 18) return {};
        whole = d.mantissa * tens(more);
    } else {
        const int behind = d.places - f.places;
        if (f.digits == 0) return {};
        std::uint64_t part = d.mantissa;
        if (behind < d.digits) whole = d.mantissa / tens(behind), part = d.mantissa % tens(behind);
        const int digits = rest_digits(f, static_cast<std::int64_t>(whole));
        if (whole == 0) {
            n.zeros = behind - d.digits;
            if (n.zeros > kMostLeading || digits < d.digits ||
                f.places + n.zeros + digits > kMostPlaces)
                return {};
            n.rest = part * tens(digits - d.digits);
        } else {
            if (digits < behind || f.places + digits > kMostPlaces) return {};
            n.rest = part * tens(digits - behind);
        }
    }
    if (whole >= static_cast<std::uint64_t>(kMostWhole)) return {};
    n.negative = x < 0;
    n.whole = n.negative ? -static_cast<std::int64_t>(whole) : static_cast<std::int64_t>(whole);
    if (n.whole != 0) n.negative = false;
    return n;
}

std::optional<Number> binary_number(const NumberFormat& f, double x) {
    Number n;
    const double q = std::ldexp(std::abs(x), f.places);
    if (!(q < static_cast<double>(kMostWhole))) return {};
    const double front = std::floor(q);
    n.whole = static_cast<std::int64_t>(front);
    const double behind = q - front;
    if (behind != 0) {
        if (f.digits == 0) return {};
        int exponent = 0;
        const double m = std::frexp(behind, &exponent);
        const int digits = rest_digits(f, n.whole);
        if (n.whole == 0) n.zeros = -exponent;
        if (n.zeros > kMostLeading) return {};
        const double rest = n.whole == 0 ? std::ldexp(m, digits) : std::ldexp(behind, digits);
        if (rest != std::floor(rest) || rest < 1) return {};
        n.rest = static_cast<std::uint64_t>(rest);
    }
    if (std::signbit(x)) {
        n.negative = n.whole == 0;
        n.whole = -n.whole;
    }
    return n;
}

}  // namespace

double whole_near(const NumberFormat& format, double x) {
    const double q = format.base == NumberBase::decimal
                         ? x * kTensAsDoubles[static_cast<std::size_t>(format.places)]
                         : std::ldexp(x, format.places);
    return std::abs(q) < static_cast<double>(kMostWhole) ? std::trunc(q) : 0;
}

std::optional<Number> number_of(const NumberFormat& format, double x, Scalar scalar) {
    if (!std::isfinite(x)) return {};
    const std::optional<Number> n = format.base == NumberBase::decimal
                                        ? decimal_number(format, x, scalar)
                                        : binary_number(format, x);
    if (!n) return {};
    double again = scaled_of(format, *n).exact;
    if (scalar == Scalar::f32) again = to_float32(again);
    if (again != x || std::signbit(again) != std::signbit(x)) return {};
    if (!format.has_minus_zero && x == 0 && std::signbit(x)) return {};
    return n;
}

NumberFormat choose_numbers(const Array& positions, bool behind) {
    constexpr std::size_t kMostSamples = 200000;
    const std::size_t values = positions.arity * positions.count();
    // Whatever the order of the points, the same values are looked at.
    const std::size_t one_in = values / kMostSamples + 1;
    const auto is_sampled = [&](double x) {
        return one_in == 1 ||
               (std::bit_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u >> 32) % one_in == 0;
    };
    const bool narrow = positions.scalar == Scalar::f32;
    const auto at = [&](std::size_t i) {
        return narrow ? static_cast<double>(positions.as<float>()[i]) : positions.as<double>()[i];
    };
    Counts decimal(2400), binary(2400);
    std::vector<double> sampled;
    for (std::size_t i = 0; i < values; ++i) {
        const double x = at(i);
        if (x == 0 || !std::isfinite(x) || !is_sampled(x)) continue;
        sampled.push_back(std::abs(x));
        const Decimal d = shortest_decimal(x, positions.scalar);
        ++decimal.numbers;
        if (d.fits && d.places <= kMostPlaces + 17) {
            ++decimal.by_places[static_cast<std::size_t>(d.places)];
            ++decimal.by_digits[static_cast<std::size_t>(d.digits)];
            ++decimal.by_front[static_cast<std::size_t>(d.digits - d.places + kMiddle)];
        } else {
            ++decimal.misfits;
        }
        const Binary b = binary_of(x);
        ++binary.numbers;
        const auto places = static_cast<std::size_t>(
            std::clamp(b.digits - b.exponent, -kMiddle, kMiddle) + kMiddle);
        ++binary.by_places[places];
        ++binary.by_digits[static_cast<std::size_t>(b.digits)];
        ++binary.by_front[static_cast<std::size_t>(std::clamp(b.exponent, -kMiddle, kMiddle) +
                                                   kMiddle)];
        binary.fronts += b.exponent;
    }
    NumberFormat best{NumberBase::binary, 0, 0, false};
    for (std::size_t i = 0; i < values && !best.has_minus_zero; ++i)
        best.has_minus_zero = at(i) == 0 && std::signbit(at(i));
    const bool minus_zero = best.has_minus_zero;
    if (binary.numbers == 0) return best;
    const auto n = static_cast<double>(binary.numbers);
    std::sort(sampled.begin(), sampled.end());
    const double told =
        static_cast<double>(std::unique(sampled.begin(), sampled.end()) - sampled.begin()) / n;
    double least = INFINITY;
    const auto offer = [&](NumberBase base, int places, int digits, double bits) {
        if (bits < least && (behind || digits == 0))
            least = bits, best = {base, places, digits, minus_zero};
    };
    double bits = 0;
    const double front = binary.fronts / n;
    const Misfits price = behind ? Misfits{narrow ? 42.0 : 74.0, 2, told} : Misfits{100, 50, 1};
    const auto with_front = [&](double behind_point) {
        return std::max(front + behind_point, 0.0);
    };
    const int front10 = most_front(decimal), front2 = most_front(binary);
    const int places10 = cheapest(
        decimal.by_places, 0, std::min(kMostPlaces, 15 - std::max(front10, 0)), decimal.misfits,
        price, [&](int k) { return with_front(k * kBitsOfTen); }, bits);
    offer(NumberBase::decimal, places10, 0, bits);
    const int digits10 = cheapest(
        decimal.by_digits, 1, 17, decimal.misfits, price, [&](int s) { return s * kBitsOfTen; },
        bits);
    // Of 16 and more digits the last ones may be behind the unit of the largest, too.
    double largest = 0, above = 1;
    for (int f = 0; f < front10; ++f) above *= 10;
    for (std::size_t i = 0; i < values; ++i)
        if (std::abs(at(i)) < above) largest = std::max(largest, std::abs(at(i)));
    int unit10 = digits10 - front10;
    while (unit10 > 0 && unit10 <= kMostPlaces &&
           largest * kTensAsDoubles[static_cast<std::size_t>(unit10)] >=
               static_cast<double>(kMostWhole))
        --unit10;
    if (unit10 >= 0 && unit10 <= kMostPlaces) offer(NumberBase::decimal, unit10, digits10, bits);
    const int places2 = cheapest(
        binary.by_places, 0, 52 - front2 + kMiddle, 0, price,
        [&](int k) { return with_front(k - kMiddle); }, bits);
    offer(NumberBase::binary, places2 - kMiddle, 0, bits);
    const int digits2 = cheapest(
        binary.by_digits, 1, 53, 0, price, [&](int s) { return s; }, bits);
    offer(NumberBase::binary, std::clamp(digits2 - front2, -kMiddle, kMiddle), digits2, bits);
    return best;
}

}  // namespace ravel
