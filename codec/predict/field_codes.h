// Codes the values of one attribute, element after element, on either side: `Coder` writes or reads
// (see code_residual). Values are numbers of a unit; a number is guessed from those of known
// elements, and what the guess misses is coded by how much it missed there.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "base/float32.h"
#include "predict/attribute_contexts.h"
#include "predict/float_image.h"
#include "predict/linear_guess.h"
#include "predict/octahedron.h"
#include "ravel/mesh.h"

namespace ravel {

// What numbers stand for values: integers themselves; floats by their image (float_image.h), or as
// decimals and the like; or the steps of a grid, which loses what is finer.
enum class FieldNumbers : std::uint8_t { integer, image, unit, grid };

struct FieldFormat {
    FieldNumbers numbers = FieldNumbers::integer;
    NumberFormat unit;          // without digits behind the unit
    double step = 1;            // of the grid
    bool has_outliers = false;  // some tuples are stored bit for bit instead
    bool unit_length = false;   // three floats, whose squares sum to about 1
    int octahedral = 0;         // of the grid: bits of the two numbers of a unit vector, or 0
    bool by_angle = false;      // guessed normals weigh cells by their angle, not by their area
    Guess guess = Guess::nearest;
};

// What is to be coded: the numbers of all tuples; outliers have none.
struct FieldTruth {
    std::vector<std::int64_t> whole;
    std::vector<bool> negative;  // zeros, where the unit has a minus zero
    std::vector<bool> outlier;
};

// The value of a number on a grid: IEEE double, one operation, rounded to float32 where that is the
// scalar. The encoder measures its errors with it.
inline double grid_value(double step, std::int64_t whole, Scalar scalar) {
    const double x = step * static_cast<double>(whole);
    return scalar == Scalar::f32 ? to_float32(x) : x;
}

inline std::uint64_t load_bits(const std::byte* from, std::size_t size) {
    std::uint64_t bits = 0;
    for (std::size_t b = 0; b < size; ++b) bits |= static_cast<std::uint64_t>(from[b]) << 8 * b;
    return bits;
}
inline void store_bits(std::byte* to, std::uint64_t bits, std::size_t size) {
    for (std::size_t b = 0; b < size; ++b) to[b] = static_cast<std::byte>(bits >> 8 * b);
}

template <class Coder>
class FieldCodes {
  public:
    // `out` holds the values, as they are or as they come to be known; elements are its tuples.
    FieldCodes(Coder& coder, const FieldFormat& format, Array& out, const FieldTruth& truth)
        : coder_(coder),
          format_(format),
          out_(out),
          truth_(truth),
          arity_(out.arity),
          width_(size_of(out.scalar)),
          sizes_((out.arity + 2) / 3) {
        if (counts()) known_.resize(std::size_t{arity_} * out.count());
    }

    // Tuple `element`; those `beside` it and `normal` (in values) are known. False: no encoder
    // writes this.
    bool next(Id element, const Beside& beside, const Shares& shares, const Point3& normal) {
        const std::size_t base = std::size_t{element} * arity_;
        if (format_.has_outliers) {
            was_outlier_ = coder_.flag(AttributeContexts::outlier.at(was_outlier_),
                                       Coder::kWrites && truth_.outlier[element]);
            if (was_outlier_) return code_outlier(base, beside);
        }
        Stencil near;
        near.configuration = static_cast<Configuration>(std::min<std::uint32_t>(beside.count, 3));
        for (std::uint32_t i = 0; i < 3 && i < beside.count; ++i) near.at[i] = beside.at[i];
        bool sane = true;
        for (std::size_t group = 0; group < sizes_.size() && sane; ++group) {
            ResidualSizes& sizes = sizes_[group];
            sizes.begin(near);
            const std::size_t first = 3 * group, count = std::min<std::size_t>(3, arity_ - first);
            std::array<std::size_t, 3> order{0, 1, 2};
            Point3 guess{};
            for (std::size_t k = 0; k < count; ++k)
                guess[k] = guess_of(first + k, beside, shares, normal);
            if (format_.octahedral > 0) {
                sane = code_direction(sizes, base, guess);
                sizes.push();
                continue;
            }
            if (format_.unit_length) put_longest_last(guess, order);
            double rest = 1;  // of the square of the length
            for (std::size_t slot = 0; slot < count && sane; ++slot) {
                const std::size_t k = order[slot];
                // The sign of a NaN is the machine's.
                if (format_.unit_length && slot == 2)
                    guess[k] = std::copysign(std::sqrt(std::max(rest, 0.0)) * units(),
                                             std::isfinite(guess[k]) ? guess[k] : 1);
                sane = code(sizes, slot, base + first + k, whole_of(guess[k], beside, first + k));
                if (format_.unit_length) {
                    const double x = known(base + first + k) / units();
                    rest -= x * x;
                }
            }
            sizes.push();
        }
        return sane;
    }

  private:
    // Are numbers kept beside the values?
    bool counts() const {
        return format_.numbers == FieldNumbers::unit || format_.numbers == FieldNumbers::grid;
    }
    // Units in 1.
    double units() const {
        if (format_.numbers == FieldNumbers::grid) return 1 / format_.step;
        if (format_.numbers != FieldNumbers::unit) return 1;
        return format_.unit.base == NumberBase::decimal
                   ? kTensAsDoubles[static_cast<std::size_t>(format_.unit.places)]
                   : std::ldexp(1.0, format_.unit.places);
    }
    std::byte* at(std::size_t i) const { return out_.bytes.data() + i * width_; }

    // A known value in units.
    double known(std::size_t i) const {
        if (counts()) return known_[i];
        const std::uint64_t bits = load_bits(at(i), width_);
        switch (out_.scalar) {
            case Scalar::f32:
                return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
            case Scalar::f64:
                return std::bit_cast<double>(bits);
            case Scalar::u64:
                return static_cast<double>(bits);
            default:
                return static_cast<double>(signed_of(bits));
        }
    }
    std::int64_t signed_of(std::uint64_t bits) const {
        switch (out_.scalar) {
            case Scalar::i8:
                return static_cast<std::int8_t>(bits);
            case Scalar::i16:
                return static_cast<std::int16_t>(bits);
            case Scalar::i32:
                return static_cast<std::int32_t>(bits);
            default:
                return static_cast<std::int64_t>(bits);
        }
    }
    // A known number.
    std::int64_t whole(std::size_t i) const {
        if (counts()) return static_cast<std::int64_t>(known_[i]);
        const std::uint64_t bits = load_bits(at(i), width_);
        if (out_.scalar == Scalar::f32)
            return static_cast<std::int64_t>(image_of(static_cast<std::uint32_t>(bits)));
        if (out_.scalar == Scalar::f64) return static_cast<std::int64_t>(image_of(bits));
        return signed_of(bits);
    }

    double guess_of(std::size_t k, const Beside& beside, const Shares& shares,
                    const Point3& normal) const {
        if (format_.guess == Guess::normal) return normal[k % 3] * units();
        double sum = 0;
        for (std::uint32_t i = 0; i < beside.count; ++i)
            sum += shares[i] * known(std::size_t{beside.at[i]} * arity_ + k);
        return sum;
    }
    // The number nearest to a guess.
    std::int64_t whole_of(double guess, const Beside& beside, std::size_t k) const {
        if (!std::isfinite(guess) || (format_.guess == Guess::nearest && !counts()))
            return beside.count == 0 ? 0 : whole(std::size_t{beside.at[0]} * arity_ + k);
        if (format_.numbers == FieldNumbers::image)
            return static_cast<std::int64_t>(
                out_.scalar == Scalar::f32
                    ? image_of(std::bit_cast<std::uint32_t>(static_cast<float>(guess)))
                    : image_of(std::bit_cast<std::uint64_t>(guess)));
        const double most = counts() ? 0x1p53 : 0x1p62;
        return static_cast<std::int64_t>(std::floor(std::clamp(guess, -most, most) + 0.5));
    }

    static void put_longest_last(const Point3& guess, std::array<std::size_t, 3>& order) {
        for (std::size_t i = 0; i < 2; ++i)
            if (std::abs(guess[order[i]]) > std::abs(guess[order[2]]))
                std::swap(order[i], order[2]);
        if (order[0] > order[1]) std::swap(order[0], order[1]);
    }

    std::int64_t code_number(ResidualSizes& sizes, std::size_t slot, std::size_t i,
                             std::int64_t guess) {
        const std::int64_t n = Coder::kWrites ? truth_.whole[i] : 0;
        const std::int64_t r =
            code_residual(coder_, sizes.scale(slot, slot),
                          static_cast<std::int64_t>(static_cast<std::uint64_t>(n) -
                                                    static_cast<std::uint64_t>(guess)));
        sizes.coded(slot, magnitude(r));
        // A file may hold any residual: the sum wraps.
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(guess) +
                                         static_cast<std::uint64_t>(r));
    }
    // Three floats by two numbers.
    bool code_direction(ResidualSizes& sizes, std::size_t base, const Point3& guess) {
        const auto near = octahedral_numbers(guess, format_.octahedral);
        std::array<std::int64_t, 2> numbers{};
        const auto most = static_cast<std::uint64_t>(octahedral_side(format_.octahedral));
        for (std::size_t k = 0; k < 2; ++k) {
            numbers[k] = code_number(sizes, k, base + k, near[k]);
            if (magnitude(numbers[k]) > most) return false;
        }
        const Point3 direction = octahedral_direction(numbers, format_.octahedral);
        for (std::size_t k = 0; k < 3; ++k) {
            known_[base + k] = direction[k];
            put_float(base + k, direction[k]);
        }
        return true;
    }
    bool code(ResidualSizes& sizes, std::size_t slot, std::size_t i, std::int64_t guess) {
        const std::int64_t n = code_number(sizes, slot, i, guess);
        if (format_.numbers == FieldNumbers::integer) {
            put(i, static_cast<std::uint64_t>(n));
            return true;
        }
        if (format_.numbers == FieldNumbers::image) {
            const auto image = static_cast<std::uint64_t>(n);
            put(i, out_.scalar == Scalar::f32 ? bits32_of(image) : bits64_of(image));
            return true;
        }
        if (magnitude(n) >= static_cast<std::uint64_t>(kMostWhole)) return false;
        Number number{n, 0, 0, false};
        if (n == 0 && format_.unit.has_minus_zero)
            number.negative =
                coder_.flag(AttributeContexts::minus_zero.at(static_cast<std::uint32_t>(slot)),
                            Coder::kWrites && truth_.negative[i]);
        known_[i] = static_cast<double>(n);
        put_float(i, format_.numbers == FieldNumbers::grid
                         ? grid_value(format_.step, n, out_.scalar)
                         : scaled_of(format_.unit, number).exact);
        return true;
    }
    bool code_outlier(std::size_t base, const Beside& beside) {
        for (std::size_t k = 0; k < arity_; ++k) {
            put(base + k, coder_.plain(Coder::kWrites ? load_bits(at(base + k), width_) : 0,
                                       static_cast<int>(8 * width_)));
            known_[base + k] =
                beside.count == 0 ? 0 : known_[std::size_t{beside.at[0]} * arity_ + k];
        }
        for (ResidualSizes& sizes : sizes_) sizes.push_nothing();
        return true;
    }
    // The writer's values are there already.
    void put(std::size_t i, std::uint64_t bits) {
        if constexpr (!Coder::kWrites) store_bits(at(i), bits, width_);
    }
    void put_float(std::size_t i, double x) {
        put(i, out_.scalar == Scalar::f32 ? std::bit_cast<std::uint32_t>(static_cast<float>(x))
                                          : std::bit_cast<std::uint64_t>(x));
    }

    Coder& coder_;
    const FieldFormat& format_;
    Array& out_;
    const FieldTruth& truth_;
    const std::uint32_t arity_;
    const std::size_t width_;
    std::vector<double> known_;         // in units, where numbers are not the values themselves
    std::vector<ResidualSizes> sizes_;  // per three components
    bool was_outlier_ = false;
};

}  // namespace ravel
