#include "base/float32.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "encode/numbers.h"
#include "predict/field_codes.h"
#include "predict/grid.h"

using namespace ravel;

namespace {

// The casts, through memory that the compiler may not look through.
double cast(double x) {
    volatile float narrow = static_cast<float>(x);
    return static_cast<double>(narrow);
}

std::uint64_t bits_of(double x) {
    return std::bit_cast<std::uint64_t>(x);
}

using Three = std::array<double, 3>;

// Loops over a point's axes, as the codec has them and compilers make vectors of.
Three halves(const Three& a, const Three& b) {
    Three h{};
    for (std::size_t k = 0; k < 3; ++k) h[k] = (a[k] + b[k]) / 2;
    for (double& x : h) x = to_float32(x);
    return h;
}

// Values where rounding turns: by one bit around each power of two, each tie and each end of a
// range, of both signs.
std::vector<double> edges() {
    std::vector<double> some{
        0.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::max(),
        std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::min()};
    for (int e = -160; e <= 130; ++e)
        for (const double fraction : {1.0, 1.5, 2 - 0x1p-23, 2 - 0x1p-24, 2 - 0x1p-25, 1 + 0x1p-23,
                                      1 + 0x1p-24, 1 + 3 * 0x1p-24, 1 + 0x1p-25})
            some.push_back(std::ldexp(fraction, e));
    std::vector<double> all;
    for (const double x : some)
        for (const double y : {std::nextafter(x, 0.0), x, std::nextafter(x, INFINITY)})
            all.insert(all.end(), {y, -y});
    // NaNs: quiet and signalling, with bits that a float32 keeps, and with others.
    for (const std::uint64_t payload :
         {0x7FF8000000000000u, 0x7FF0000000000001u, 0x7FF0000020000000u, 0x7FF800001FFFFFFFu,
          0x7FFFFFFFFFFFFFFFu})
        for (const std::uint64_t sign : {std::uint64_t{0}, std::uint64_t{1} << 63})
            all.push_back(std::bit_cast<double>(payload | sign));
    return all;
}

}  // namespace

TEST_CASE("to_float32 is the cast to float and back at every edge of float32") {
    for (const double x : edges()) CHECK(bits_of(to_float32(x)) == bits_of(cast(x)));
    CHECK(std::signbit(to_float32(-0.0)));
    CHECK(std::isinf(to_float32(0x1.ffffffp127)));
    CHECK(to_float32(0x1.fffffeffffffp127) == 0x1.fffffep127);
}

TEST_CASE("to_float32 is the cast for any bits") {
    std::mt19937_64 random(1);
    std::size_t others = 0;
    for (int i = 0; i < 2'000'000; ++i) {
        std::uint64_t bits = random();
        // Half of them with an exponent that float32 has, or nearly.
        if (i % 2 == 0) bits = (bits & ~(0x7FFull << 52)) | (860 + random() % 300) << 52;
        const double x = std::bit_cast<double>(bits);
        others += bits_of(to_float32(x)) != bits_of(cast(x));
    }
    CHECK(others == 0);
}

TEST_CASE("values that were rounded in a loop over axes are floats") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> some(-1, 1);
    std::size_t others = 0;
    for (int i = 0; i < 1000; ++i) {
        const Three a{some(random), some(random), some(random)};
        const Three b{some(random), some(random), some(random)};
        const Three h = halves(a, b);
        const Grid grid{{a[0], a[1], a[2]}, std::abs(b[0])};
        Three on_grid{}, field{};
        for (std::size_t k = 0; k < 3; ++k) {
            on_grid[k] = coordinate_of(grid, k, i, Scalar::f32);
            field[k] = grid_value(b[k], i, Scalar::f32);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            others += h[k] != cast((a[k] + b[k]) / 2);
            others += on_grid[k] != cast(a[k] + std::abs(b[0]) * i);
            others += field[k] != cast(b[k] * i);
            others += coordinate_of(grid, k, i, Scalar::f64) != a[k] + std::abs(b[0]) * i;
        }
    }
    CHECK(others == 0);
}

TEST_CASE("a coordinate that is no float32 has no number as one") {
    const NumberFormat tenths{NumberBase::decimal, 1, 0, false};
    const NumberFormat whole{NumberBase::binary, 0, 0, false};
    CHECK(number_of(tenths, cast(0.1), Scalar::f32));
    CHECK_FALSE(number_of(tenths, 0.1, Scalar::f32));
    CHECK(number_of(tenths, 0.1, Scalar::f64));
    CHECK(number_of(whole, 0x1p24 + 1, Scalar::f64));
    CHECK_FALSE(number_of(whole, 0x1p24 + 1, Scalar::f32));
}
