#include "encode/field_plan.h"

#include <optional>

#include "base/float32.h"
#include "encode/bits_writer.h"
#include "encode/numbers.h"
#include "entropy/pack.h"
#include "predict/array_planes.h"

namespace ravel {
namespace {

constexpr std::size_t kMostTried = 1 << 15;  // tuples
constexpr int kTrialLevel = 9;               // of zstd

double value_at(const Array& values, std::size_t i) {
    return values.scalar == Scalar::f32 ? static_cast<double>(values.as<float>()[i])
                                        : values.as<double>()[i];
}

std::int64_t integer_at(const Array& values, std::size_t i) {
    switch (values.scalar) {
        case Scalar::u8:
            return values.as<std::uint8_t>()[i];
        case Scalar::i8:
            return values.as<std::int8_t>()[i];
        case Scalar::u16:
            return values.as<std::uint16_t>()[i];
        case Scalar::i16:
            return values.as<std::int16_t>()[i];
        case Scalar::u32:
            return values.as<std::uint32_t>()[i];
        case Scalar::i32:
            return values.as<std::int32_t>()[i];
        case Scalar::f32:
            return static_cast<std::int64_t>(image_of(values.as<std::uint32_t>()[i]));
        case Scalar::f64:
            return static_cast<std::int64_t>(image_of(values.as<std::uint64_t>()[i]));
        default:
            return values.as<std::int64_t>()[i];
    }
}

Array first_of(const Array& values, std::size_t count) {
    Array some{values.scalar, values.arity, {}};
    some.bytes.assign(values.bytes.begin(),
                      values.bytes.begin() + static_cast<std::ptrdiff_t>(count * values.stride()));
    return some;
}

// Are most tuples three floats of length 1?
bool has_unit_length(const Array& values) {
    if (values.arity != 3 || !is_float(values.scalar)) return false;
    std::size_t unit = 0;
    for (std::size_t t = 0; t < values.count(); ++t) {
        double square = 0;
        for (std::size_t k = 0; k < 3; ++k)
            square += value_at(values, 3 * t + k) * value_at(values, 3 * t + k);
        unit += std::abs(square - 1) < 0.01;
    }
    return 10 * unit > 9 * values.count();
}

// The number on a grid that decodes to exactly this value.
std::optional<Number> grid_number(const FieldFormat& format, double x, Scalar scalar) {
    const double whole = std::floor(x / format.step + 0.5);
    if (!(std::abs(whole) < static_cast<double>(kMostWhole))) return {};
    Number n;
    n.whole = static_cast<std::int64_t>(whole);
    const double again = grid_value(format.step, n.whole, scalar);
    if (again != x || std::signbit(again) != std::signbit(x)) return {};
    return n;
}

// The directions; those that do not decode to exactly these values are outliers.
void find_directions(const Array& values, FieldFormat& format, FieldTruth& truth) {
    for (std::size_t t = 0; t < values.count(); ++t) {
        const Point3 given{value_at(values, 3 * t), value_at(values, 3 * t + 1),
                           value_at(values, 3 * t + 2)};
        const auto numbers = octahedral_numbers(given, format.octahedral);
        const Point3 again = octahedral_direction(numbers, format.octahedral);
        for (std::size_t k = 0; k < 2; ++k) truth.whole[3 * t + k] = numbers[k];
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = values.scalar == Scalar::f32 ? to_float32(again[k]) : again[k];
            if (x != given[k] || std::signbit(x) != std::signbit(given[k]))
                truth.outlier[t] = format.has_outliers = true;
        }
    }
}

}  // namespace

FieldTruth truth_of(const Array& values, FieldFormat& format) {
    FieldTruth truth;
    const std::size_t count = values.count() * values.arity;
    truth.whole.resize(count);
    format.has_outliers = false;
    if (format.numbers == FieldNumbers::integer || format.numbers == FieldNumbers::image) {
        for (std::size_t i = 0; i < count; ++i) truth.whole[i] = integer_at(values, i);
        return truth;
    }
    truth.negative.assign(count, false);
    truth.outlier.assign(values.count(), false);
    if (format.octahedral > 0) {
        find_directions(values, format, truth);
        return truth;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const double x = value_at(values, i);
        const std::optional<Number> n = format.numbers == FieldNumbers::grid
                                            ? grid_number(format, x, values.scalar)
                                            : number_of(format.unit, x, values.scalar);
        if (n) {
            truth.whole[i] = n->whole;
            truth.negative[i] = n->negative;
        } else {
            truth.outlier[i / values.arity] = format.has_outliers = true;
        }
    }
    return truth;
}

FieldPlan plan_field(const Array& values, Around& around, const FieldFormat* grid) {
    const Array some = first_of(values, std::min(values.count(), kMostTried));
    FieldPlan best;
    best.bytes = pack(planes_of(some), kTrialLevel).size();
    if (some.count() == 0) return best;
    const auto offer = [&](const FieldFormat& format, const FieldTruth& truth) {
        FlagEncoder out;
        BitsWriter coder{out};
        Array again = some;
        code_values(coder, format, around, again, truth);
        const std::size_t bytes = out.finish().size();
        if (bytes < best.bytes) best = {false, format, bytes};
    };
    const bool unit_length = has_unit_length(some);
    const auto offer_numbers = [&](FieldFormat format) {
        const FieldTruth truth = truth_of(some, format);
        std::size_t outliers = 0;
        for (const bool o : truth.outlier) outliers += o;
        if (4 * outliers > some.count()) return;
        for (const Guess guess : {Guess::nearest, Guess::mean, Guess::linear, Guess::normal}) {
            if (guess == Guess::normal && !unit_length) continue;
            format.guess = guess;
            offer(format, truth);
        }
        if (!unit_length) return;
        format.by_angle = true;
        offer(format, truth);
        if (format.octahedral > 0) return;
        if (best.planes || best.format.numbers != format.numbers) return;
        format = best.format;
        format.unit_length = true;
        offer(format, truth);
    };
    FieldFormat format;
    if (!is_float(values.scalar)) {
        offer_numbers(format);
    } else {
        format.numbers = FieldNumbers::image;
        offer_numbers(format);
        format.unit = choose_numbers(values, false);
        format.numbers = FieldNumbers::unit;
        offer_numbers(format);
        if (grid != nullptr) offer_numbers(*grid);
    }
    best.bytes = best.bytes * values.count() / some.count();
    return best;
}

}  // namespace ravel
