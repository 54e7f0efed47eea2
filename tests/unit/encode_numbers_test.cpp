#include "encode/numbers.h"

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

using namespace ravel;

namespace {

Array array_of(const std::vector<double>& numbers, Scalar scalar) {
    Array array = make_array(scalar, 3, numbers.size() / 3);
    for (std::size_t i = 0; i < 3 * array.count(); ++i) {
        if (scalar == Scalar::f32)
            array.as<float>()[i] = static_cast<float>(numbers[i]);
        else
            array.as<double>()[i] = numbers[i];
    }
    return array;
}

double value_at(const Array& array, std::size_t i) {
    return array.scalar == Scalar::f32 ? static_cast<double>(array.as<float>()[i])
                                       : array.as<double>()[i];
}

// How many coordinates have no number; the others must come back bit for bit.
std::size_t misfits(const NumberFormat& format, const Array& array) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3 * array.count(); ++i) {
        const double x = value_at(array, i);
        const auto n = number_of(format, x, array.scalar);
        if (!n) {
            ++count;
            continue;
        }
        double again = scaled_of(format, *n).exact;
        if (array.scalar == Scalar::f32) again = static_cast<double>(static_cast<float>(again));
        CHECK(std::bit_cast<std::uint64_t>(again) == std::bit_cast<std::uint64_t>(x));
        CHECK(std::abs(n->whole) < kMostWhole);
    }
    return count;
}

}  // namespace

TEST_CASE("decimals of few places are whole numbers, as float32 and as float64") {
    std::mt19937 random(1);
    std::vector<double> numbers;
    for (int i = 0; i < 3000; ++i)
        numbers.push_back((static_cast<double>(random() % 2000000) - 1e6) / 1e4);
    for (const Scalar scalar : {Scalar::f32, Scalar::f64}) {
        const Array array = array_of(numbers, scalar);
        const NumberFormat format = choose_numbers(array);
        CHECK(format.base == NumberBase::decimal);
        CHECK(format.places == 4);
        CHECK(format.digits == 0);
        CHECK(misfits(format, array) == 0);
        CHECK(number_of(format, value_at(array, 7), scalar)->whole ==
              std::llround(numbers[7] * 1e4));
    }
}

TEST_CASE("decimals of six significant digits keep the digits behind the unit") {
    std::mt19937 random(2);
    std::vector<double> numbers;
    for (int i = 0; i < 3000; ++i) {
        const double scale = std::pow(10.0, static_cast<int>(random() % 5));
        numbers.push_back(static_cast<double>(random() % 900000 + 100000) / (1e3 * scale));
    }
    for (const Scalar scalar : {Scalar::f32, Scalar::f64}) {
        const Array array = array_of(numbers, scalar);
        const NumberFormat format = choose_numbers(array);
        CHECK(format.base == NumberBase::decimal);
        CHECK(format.digits == 6);
        CHECK(misfits(format, array) == 0);
    }
}

TEST_CASE("binary fractions of few places are whole numbers") {
    std::mt19937 random(3);
    std::vector<double> numbers;
    for (int i = 0; i < 3000; ++i) numbers.push_back(static_cast<double>(random() % 4096) / 256);
    const Array array = array_of(numbers, Scalar::f64);
    const NumberFormat format = choose_numbers(array);
    CHECK(format.digits == 0);
    CHECK(format.base == NumberBase::binary);
    CHECK(format.places == 8);
    CHECK(misfits(format, array) == 0);
}

TEST_CASE("floats of full precision are binary numbers, all of them, down to the smallest") {
    std::mt19937_64 random(4);
    for (const Scalar scalar : {Scalar::f32, Scalar::f64}) {
        std::vector<double> numbers;
        for (int i = 0; i < 3000; ++i)
            numbers.push_back(std::ldexp(static_cast<double>(random() >> 11),
                                         -53 - static_cast<int>(random() % 20)));
        numbers[5] = numbers[9] = -0.0;
        numbers[6] = 0.0;
        const Array array = array_of(numbers, scalar);
        const NumberFormat format = choose_numbers(array);
        CHECK(format.base == NumberBase::binary);
        CHECK(format.has_minus_zero);
        CHECK(misfits(format, array) == 0);
    }
}

TEST_CASE("what is no number, or of another format, is refused and never rounded") {
    using Limits = std::numeric_limits<double>;
    std::mt19937_64 random(5);
    for (int round = 0; round < 200; ++round) {
        NumberFormat format;
        format.base = round % 2 == 0 ? NumberBase::decimal : NumberBase::binary;
        format.places = static_cast<int>(random() % 23);
        format.digits = static_cast<int>(random() % 18);
        format.has_minus_zero = round % 4 < 2;
        std::vector<double> numbers{0.0,  -0.0,   1,      -1,    0.1, 1e300, Limits::denorm_min(),
                                    1e16, 0x1p53, 0x1p52, 123.25};
        while (numbers.size() % 3 != 0 || numbers.size() < 60)
            numbers.push_back(std::ldexp(static_cast<double>(random() % 1000000),
                                         static_cast<int>(random() % 60) - 50));
        misfits(format, array_of(numbers, Scalar::f64));
        misfits(format, array_of(numbers, Scalar::f32));
        CHECK(!number_of(format, Limits::infinity(), Scalar::f64));
        CHECK(!number_of(format, Limits::quiet_NaN(), Scalar::f64));
    }
}
