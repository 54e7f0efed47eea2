#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "predict/array_planes.h"
#include "predict/float_image.h"
#include "predict/grid.h"
#include "predict/position_codes.h"
#include "predict/predictor.h"
#include "predict/vertex_index.h"

using namespace ravel;

namespace {

using Limits = std::numeric_limits<double>;

std::vector<double> ascending_doubles() {
    return {-Limits::infinity(),
            -Limits::max(),
            -1e300,
            -1.5,
            -1,
            -Limits::min(),
            -Limits::denorm_min(),
            -0.0,
            0.0,
            Limits::denorm_min(),
            Limits::min(),
            1,
            std::nextafter(1.0, 2.0),
            1.5,
            1e300,
            Limits::max(),
            Limits::infinity()};
}

// A coder that remembers: what is written is read back in order.
struct Tape {
    std::vector<std::uint64_t> tape;
    std::size_t at = 0;
    bool reading = false;
    bool flag(Context, bool truth) { return plain(truth, 1) != 0; }
    std::uint64_t plain(std::uint64_t truth, int) {
        if (reading) return tape.at(at++);
        tape.push_back(truth);
        return truth;
    }
};

}  // namespace

TEST_CASE("the image of a float64 keeps the order of numbers") {
    const auto numbers = ascending_doubles();
    for (std::size_t i = 1; i < numbers.size(); ++i)
        CHECK(image_of(std::bit_cast<std::uint64_t>(numbers[i - 1])) <
              image_of(std::bit_cast<std::uint64_t>(numbers[i])));
}

TEST_CASE("the image of a float32 keeps the order of numbers and stays within 32 bits") {
    std::uint64_t last = 0;
    for (const double x : ascending_doubles()) {
        if (std::isfinite(x) && std::abs(x) > 3e38) continue;
        const auto f = static_cast<float>(x);
        if (static_cast<double>(f) != x) continue;
        const std::uint64_t image = image_of(std::bit_cast<std::uint32_t>(f));
        CHECK(image > last);
        CHECK(image <= 0xFFFFFFFFu);
        last = image;
    }
}

TEST_CASE("images are one to one on bit patterns, NaNs and all") {
    std::mt19937_64 random(1);
    for (int i = 0; i < 100000; ++i) {
        const std::uint64_t wide = random();
        const auto narrow = static_cast<std::uint32_t>(wide);
        REQUIRE(bits64_of(image_of(wide)) == wide);
        REQUIRE(image_of(bits64_of(wide)) == wide);
        REQUIRE(bits32_of(image_of(narrow)) == narrow);
        REQUIRE(image_of(bits32_of(narrow)) == narrow);
    }
}

TEST_CASE("wrapped differences lead back") {
    std::mt19937_64 random(2);
    for (int i = 0; i < 10000; ++i) {
        const std::uint64_t a = random(), b = random();
        REQUIRE(b + static_cast<std::uint64_t>(wrapped_difference(a, b, false)) == a);
        const std::uint64_t x = a & 0xFFFFFFFFu, y = b & 0xFFFFFFFFu;
        const std::int64_t d = wrapped_difference(x, y, true);
        REQUIRE(d >= -(std::int64_t{1} << 31));
        REQUIRE(d < std::int64_t{1} << 31);
        REQUIRE(static_cast<std::uint32_t>(y + static_cast<std::uint64_t>(d)) == x);
    }
}

TEST_CASE("planes come back for every scalar and arity") {
    std::mt19937 random(3);
    for (unsigned s = 0; s <= static_cast<unsigned>(Scalar::f64); ++s)
        for (const std::uint32_t arity : {1u, 2u, 3u, 7u, 65535u})
            for (const std::size_t count :
                 {std::size_t{0}, std::size_t{1}, std::size_t{arity < 10 ? 50u : 2u}}) {
                Array array = make_array(static_cast<Scalar>(s), arity, count);
                for (std::byte& b : array.bytes) b = static_cast<std::byte>(random());
                const Bytes planes = planes_of(array);
                REQUIRE(planes.size() == array.bytes.size());
                const Array again = array_of_planes(array.scalar, arity, planes);
                CHECK(again.scalar == array.scalar);
                CHECK(again.arity == arity);
                CHECK(again.bytes == array.bytes);
            }
}

TEST_CASE("planes of a slow ramp are small numbers first and zeros after") {
    Array array = make_array(Scalar::i32, 1, 1000);
    for (int i = 0; i < 1000; ++i)
        array.as<std::int32_t>()[static_cast<std::size_t>(i)] = i * 3 - 500;
    const Bytes planes = planes_of(array);
    for (std::size_t i = 1; i < 1000; ++i) CHECK(planes[i] == std::byte{6});
    for (std::size_t i = 2001; i < planes.size(); ++i) CHECK(planes[i] == std::byte{0});
}

namespace {

// Stencils of every configuration, with and without what may be missing, over vertices 0 .. 10.
std::vector<Stencil> all_stencils() {
    std::vector<Stencil> all;
    const auto add = [&](Configuration c, std::initializer_list<std::size_t> present) {
        Stencil s;
        s.configuration = c;
        for (const std::size_t i : present) s.at[i] = static_cast<Id>(i);
        all.push_back(s);
    };
    using C = Configuration;
    add(C::seed, {});
    add(C::seed, {0});
    add(C::seed, {0, 1});
    add(C::seed, {0, 1, 2});
    add(C::quad_third, {0, 1, 2, 3});
    add(C::quad_third, {0, 1, 2, 3, 4, 5});
    add(C::quad_fourth, {0, 1, 2});
    add(C::quad_fourth, {0, 1, 2, 3, 4});
    add(C::quad_fourth, {0, 1, 2, 3, 4, 5, 6});
    add(C::quad_corner, {0, 1, 2, 3, 4, 7, 8});
    add(C::quad_corner, {0, 1, 2, 3, 4, 5, 6, 7, 8});
    add(C::quad_corner, {0, 1, 2, 3, 4, 7, 8, 9, 10});
    add(C::quad_corner, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    for (std::uint8_t variant = 0; variant < kTriangleVariants; ++variant) {
        add(C::triangle, {0, 1, 2, 3, 4, 5, 6, 7});
        all.back().variant = variant;
    }
    add(C::polygon, {0, 1, 2});
    add(C::polygon, {0, 1, 2, 3});
    add(C::tet, {0, 1, 2, 3, 4, 5, 6});
    add(C::border, {0, 1, 2, 3});
    return all;
}

}  // namespace

TEST_CASE("a guess is the base and the weighted features") {
    std::mt19937 random(11);
    for (int round = 0; round < 200; ++round) {
        Weights weights;
        for (auto& row : weights)
            for (auto& w : row) w = static_cast<std::int16_t>(random());
        std::vector<Point3> values(kStencilSize);
        for (Point3& p : values)
            for (double& x : p) x = static_cast<double>(random() % 100000) - 50000;
        const bool mirrored = round % 2 == 1;
        Predictor predictor(weights, mirrored);
        for (const Stencil& stencil : all_stencils()) {
            const std::size_t c = weight_set_of(stencil);
            const Features f = features_of(stencil, values, mirrored);
            const Point3 guess = predictor.guess(stencil, values);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                double want = 0;
                for (std::size_t i = 0; i < kFeatureCount[c]; ++i)
                    want += weights[c][i] * f.feature[i][axis];
                want = f.base[axis] + want / 4096;
                INFO("weights " << c);
                // Whole numbers are exact whatever the order of the sums.
                if (stencil.configuration == Configuration::tet ||
                    stencil.configuration == Configuration::border)
                    CHECK(guess[axis] == Approx(want));
                else
                    CHECK(guess[axis] == want);
            }
        }
    }
}

TEST_CASE("a regular tet's apex is guessed over its gate, mirrored or not") {
    // The gate, the apex behind it and the apexes across its edges, all edges as long.
    const double h = std::sqrt(2.0 / 3), r = 1 / std::sqrt(3.0);
    const std::vector<Point3> values{{1000 * r, 0, 0},  {-500 * r, 500, 0}, {-500 * r, -500, 0},
                                     {0, 0, -1000 * h}, {-1000 * r, 0, 1},  {500 * r, -500, 1},
                                     {500 * r, 500, 1}};
    Stencil stencil;
    stencil.configuration = Configuration::tet;
    for (Id i = 0; i < 7; ++i) stencil.at[i] = i;
    const Point3 up = Predictor(kDefaultWeights, false).guess(stencil, values);
    CHECK(up[2] > 300);
    CHECK(up[2] < 1000);
    const Point3 down = Predictor(kDefaultWeights, true).guess(stencil, values);
    CHECK(down[2] < -300);
}

TEST_CASE("guesses from the farthest numbers with the largest weights stay finite") {
    Weights weights;
    for (const std::int16_t w : {std::int16_t{32767}, std::int16_t{-32768}}) {
        for (auto& row : weights) row.fill(w);
        Predictor predictor(weights, false);
        for (unsigned signs = 0; signs < 1u << kStencilSize; ++signs) {
            std::vector<Point3> values(kStencilSize);
            for (std::size_t i = 0; i < kStencilSize; ++i) {
                const auto most = static_cast<double>(signs >> i & 1 ? kMostWhole : -kMostWhole);
                values[i] = {most, -most, most};
            }
            for (const Stencil& stencil : all_stencils())
                for (const double x : predictor.guess(stencil, values)) {
                    REQUIRE(std::abs(x) < 0x1p70);
                }
        }
    }
}

TEST_CASE("residuals of every size come back under every scale") {
    std::vector<std::int64_t> residuals{0, std::numeric_limits<std::int64_t>::min(),
                                        std::numeric_limits<std::int64_t>::max()};
    for (int bit = 0; bit < 63; ++bit)
        for (const std::int64_t d : {-1, 0, 1}) {
            residuals.push_back((std::int64_t{1} << bit) + d);
            residuals.push_back(-(std::int64_t{1} << bit) + d);
        }
    for (std::uint32_t bits = 2; bits <= 43; ++bits) {
        Tape coder;
        const Scale scale{bits, bits};
        for (const std::int64_t r : residuals) code_residual(coder, scale, r);
        coder.reading = true;
        for (const std::int64_t r : residuals) CHECK(code_residual(coder, scale, 0) == r);
        CHECK(coder.at == coder.tape.size());
    }
}

TEST_CASE("the scale of a residual follows those around and the axes before") {
    ResidualSizes sizes;
    Stencil stencil;
    stencil.configuration = Configuration::triangle;
    const auto vertex = [&](std::uint64_t magnitude) {
        sizes.begin(stencil);
        for (std::size_t axis = 0; axis < 3; ++axis) sizes.coded(axis, magnitude);
        sizes.push();
    };
    for (int i = 0; i < 3; ++i) vertex(1000);
    for (int i = 0; i < 3; ++i) vertex(1);
    const auto scale_at = [&](Id first) {
        stencil.at = {first, first + 1, first + 2};
        for (std::size_t i = 3; i < kStencilSize; ++i) stencil.at[i] = kNone;
        sizes.begin(stencil);
        return sizes.scale(0, 0);
    };
    CHECK(scale_at(0).bits > scale_at(3).bits + 4);
    CHECK(scale_at(0).context > scale_at(3).context + 8);
    scale_at(0);
    const std::uint32_t before = sizes.scale(1, 1).bits;
    sizes.coded(0, 100000);
    CHECK(sizes.scale(1, 1).bits > before);
    // Whatever comes, a scale has a context.
    for (int i = 0; i < 20; ++i) vertex(~std::uint64_t{0});
    sizes.begin(stencil);
    CHECK(sizes.scale(0, 0).context < kScales);
}

TEST_CASE("seeds tell seeds alone, and first ones nobody") {
    const auto seed = [](std::uint8_t variant, Id before) {
        Stencil stencil = stencil_of(Configuration::seed, {before});
        stencil.variant = variant;
        return stencil;
    };
    ResidualSizes sizes;
    const auto code = [&](const Stencil& stencil, std::int64_t r) {
        sizes.begin(stencil);
        for (std::size_t axis = 0; axis < 3; ++axis) sizes.coded_residual(axis, r);
        sizes.push();
    };
    const auto expected_of = [&](const Stencil& stencil) {
        sizes.begin(stencil);
        return sizes.scale(0, 0).context;
    };
    const Stencil alone = stencil_of(Configuration::polygon, {});
    const std::uint32_t usually = expected_of(alone), of_seeds = expected_of(seed(2, kNone));
    code(seed(0, kNone), 1 << 20);
    code(seed(1, 0), 1 << 10);
    CHECK(expected_of(stencil_of(Configuration::polygon, {0})) == usually);
    CHECK(expected_of(stencil_of(Configuration::polygon, {1})) == usually);
    CHECK(expected_of(seed(2, 0)) == of_seeds);
    CHECK(expected_of(seed(2, 1)) > of_seeds);
    CHECK(expected_of(seed(0, 1)) == expected_of(seed(0, kNone)));
    code(alone, 1 << 10);
    CHECK(expected_of(stencil_of(Configuration::polygon, {2})) > usually);
    CHECK(expected_of(stencil_of(Configuration::polygon, {0, 1, 2})) ==
          expected_of(stencil_of(Configuration::polygon, {2})));
}

TEST_CASE("grid coordinates are origin and steps, rounded to the mesh's floats") {
    const Grid grid{{0.1, -5, 0}, 0.25};
    CHECK(coordinate_of(grid, 1, 4, Scalar::f64) == -4);
    CHECK(coordinate_of(grid, 0, 0, Scalar::f32) == static_cast<double>(0.1f));
    CHECK(coordinate_of(grid, 0, 0, Scalar::f64) == 0.1);
}

TEST_CASE("places of any floats are integers within the grid of places") {
    PositionFormat format;
    format.has_stand_ins = true;
    for (const double scale : {1.0, 0x1p16, 1e300, 1e-300, Limits::quiet_NaN(), -1.0})
        for (const double x : ascending_doubles()) {
            format.place_scale = scale;
            for (const double p : place_of(format, {x, x, x})) {
                CHECK(p >= 0);
                CHECK(p <= 0x1p20);
                CHECK(p == std::floor(p));
            }
        }
}

TEST_CASE("the index of vertices finds the nearest one within half a cube, dense or not") {
    const int spread = GENERATE(20, 200);
    const int count = spread == 20 ? 20000 : 4000;  // 2.5 in a small cube, 0.26 in a large one
    std::mt19937 random(7);
    std::vector<Point3> points;
    VertexIndex index(3, static_cast<std::size_t>(count));
    const auto place = [&](unsigned parts) {
        Point3 p;
        for (double& x : p)
            x = static_cast<double>(random() % (static_cast<unsigned>(spread) * parts)) / parts -
                spread / 2.0;
        return p;
    };
    for (int i = 0; i < count; ++i) {
        points.push_back(place(1));
        index.insert(points.back());
        points.push_back({0, 0, 0});
        index.skip();
    }
    for (int i = 0; i < 2000; ++i) {
        const Point3 p = place(10);
        double least = 4;
        for (std::size_t j = 0; j < points.size(); j += 2) {
            const Point3& q = points[j];
            least = std::min(least,
                             std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]));
        }
        const auto near = index.nearest(p, points);
        // In dense places what is found in small cubes is all that must not be missed.
        if (least < (spread == 20 ? 0.5 : 4)) {
            REQUIRE(near.vertex != kNone);
            CHECK(near.distance == least);
        }
        if (near.vertex != kNone) CHECK(near.vertex % 2 == 0);
    }
}

TEST_CASE("an echo leads back to where it came from") {
    Echo echo;
    echo.mirrored = {true, false, true};
    echo.offset = {10, 0, -4};
    const Point3 p = echo.back({3, 5, 1});
    CHECK(p == Point3{7, 5, -5});
    CHECK(echo.back(p)[0] == 3);
}
