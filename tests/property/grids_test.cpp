// Grids: tiles on a lattice meet bit for bit, bounds hold, one far point does not spoil the grid of
// all others, and what was decoded packs to the same bytes again.
#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <set>

#include "make/make_mesh.h"
#include "support/mesh_from_bytes.h"
#include "support/small_meshes.h"

using namespace ravel;

namespace {

Mesh made(const char* recipe) {
    const Result<Mesh> mesh = make::make_mesh(recipe);
    REQUIRE(mesh.ok());
    return *mesh;
}

Mesh moved(Mesh mesh, double dx, double dy) {
    for (Index p = 0; p < mesh.point_count(); ++p) {
        mesh.positions.as<double>()[3 * p] += dx;
        mesh.positions.as<double>()[3 * p + 1] += dy;
    }
    return mesh;
}

Mesh comes_back(const Mesh& mesh, const EncodeOptions& options) {
    const Result<Encoded> packed = encode(mesh, options);
    REQUIRE(packed.ok());
    Result<Decoded> decoded = decode(packed->bytes);
    REQUIRE(decoded.ok());
    return std::move(decoded->mesh);
}

std::set<std::array<double, 3>> points_of(const Mesh& mesh) {
    std::set<std::array<double, 3>> points;
    const auto p = mesh.positions.as<double>();
    for (Index i = 0; i < mesh.point_count(); ++i)
        points.insert({p[3 * i], p[3 * i + 1], p[3 * i + 2]});
    return points;
}

double diagonal(const Mesh& mesh) {
    double square = 0;
    const auto p = mesh.positions.as<double>();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double low = p[axis], high = p[axis];
        for (Index i = 0; i < mesh.point_count(); ++i) {
            low = std::min(low, p[3 * i + axis]);
            high = std::max(high, p[3 * i + axis]);
        }
        square += (high - low) * (high - low);
    }
    return std::sqrt(square);
}

}  // namespace

TEST_CASE("tiles packed one by one on a lattice share their seam bit for bit") {
    EncodeOptions options;
    options.lattice = 0x1p-9;
    const Mesh tile = made("terrain:size=12x9,double");
    const double width = 12.3, height = 7.1;
    // The same points, once as a tile's own and once as part of a larger mesh of another box.
    for (const auto& [dx, dy] : {std::pair{0.0, 0.0}, {width, 0.0}, {-height, 1e4}}) {
        const Mesh here = moved(tile, dx, dy);
        Mesh more = here;
        more.positions = make_array(Scalar::f64, 3, here.point_count() + 1);
        std::copy_n(here.positions.as<double>().begin(), 3 * here.point_count(),
                    more.positions.as<double>().begin());
        for (std::size_t axis = 0; axis < 3; ++axis)
            more.positions.as<double>()[3 * here.point_count() + axis] = -77.77;
        const auto alone = points_of(comes_back(here, options));
        const auto among = points_of(comes_back(more, options));
        REQUIRE(alone.size() + 1 == among.size());
        for (const auto& point : alone) {
            REQUIRE(among.contains(point));
            for (const double x : point)
                CHECK(x / *options.lattice == std::floor(x / *options.lattice));
        }
    }
}

TEST_CASE("the bound asked for holds, in units and in diagonals") {
    for (const char* recipe :
         {"terrain:size=30x20,double", "tets:box=4,jitter=0.3,double", "torus:quads=400"})
        for (const double error : {0.1, 1e-3, 1e-6}) {
            const Mesh mesh = made(recipe);
            EncodeOptions options;
            options.max_error = error;
            INFO(recipe << ", " << error);
            CHECK(test::trouble(mesh, options) == "");
            if (mesh.positions.scalar != Scalar::f64) continue;
            options = {};
            options.max_error_relative = error;
            CHECK(test::trouble(mesh, options) == "");
            const Result<Encoded> packed = encode(mesh, options);
            REQUIRE(packed.ok());
            CHECK(packed->position_error <= error * diagonal(mesh));
        }
}

TEST_CASE("one far point is escaped and leaves the grid as it was") {
    EncodeOptions options;
    options.position_bits = 10;
    for (const double far : {1e38, -1e30, 1e300}) {
        Mesh mesh = made("terrain:size=20x20,double");
        const Result<Encoded> before = encode(mesh, options);
        mesh.positions.as<double>()[3 * 57 + 1] = far;
        const Result<Encoded> after = encode(mesh, options);
        REQUIRE((before.ok() && after.ok()));
        INFO(far);
        CHECK(after->position_bound <= before->position_bound * 1.01);
        CHECK(test::trouble(mesh, options) == "");
    }
}

TEST_CASE("what is mirrored about the middle of its box is mirrored on its grid, small or large") {
    EncodeOptions options;
    options.position_bits = 12;
    constexpr double kStep = 2000.0 / 4096, kMiddle = 75852.25 * kStep;
    for (const char* recipe : {"grid:size=20x20,double", "grid:size=140x120,double"}) {
        Mesh mesh = made(recipe);
        const auto p = mesh.positions.as<double>();
        double width = 0;
        for (Index i = 0; i < mesh.point_count(); ++i) width = std::max(width, p[3 * i]);
        for (Index i = 0; i < mesh.point_count(); ++i) {
            // Uneven columns, the same on either side. A grid from a multiple of the step would
            // round half of them otherwise than their images.
            const double x = 2 * p[3 * i] / width - 1;
            p[3 * i] = kMiddle + 1000 * std::copysign(std::pow(std::abs(x), 1.3), x);
        }
        std::vector<double> x;
        for (const std::array<double, 3>& point : points_of(comes_back(mesh, options)))
            x.push_back(point[0]);
        std::sort(x.begin(), x.end());
        std::size_t matches = 0;  // but for few, which lie between two steps
        for (std::size_t i = 0; i < x.size(); ++i)
            matches += std::abs(x[i] + x[x.size() - 1 - i] - 2 * kMiddle) < kStep / 2;
        INFO(recipe);
        CHECK(matches >= x.size() * 9 / 10);
    }
}

TEST_CASE("a mesh that lies on a grid of its own keeps it, and takes fewer bytes") {
    for (const double unit : {1.0 / 128, 0.01, 0.25, 5.0}) {
        Mesh mesh = made("terrain:size=30x20,double,seed=4");
        const Mesh rough = mesh;
        double longest = 0;
        for (const double x : mesh.positions.as<double>()) longest = std::max(longest, x);
        for (double& x : mesh.positions.as<double>())
            x = std::nearbyint(x / longest * 900) * unit + 3 * unit;
        for (const int bits : {10, 14, 17}) {
            EncodeOptions options;
            options.position_bits = bits;
            INFO(unit << ", " << bits << " bits");
            const Result<Encoded> packed = encode(mesh, options);
            const Result<Encoded> other = encode(rough, options);
            REQUIRE((packed.ok() && other.ok()));
            CHECK(packed->position_error < 1e-4 * unit);
            if (bits > 10) CHECK(packed->bytes.size() < other->bytes.size() * 8 / 10);
            CHECK(test::trouble(mesh, options) == "");
        }
        // Where that grid is finer than what was asked for, it is none.
        EncodeOptions coarse;
        coarse.position_bits = 8;
        const Result<Encoded> packed = encode(mesh, coarse);
        REQUIRE(packed.ok());
        CHECK(packed->position_error > 0.1 * unit);
    }
}

TEST_CASE("what was put on a grid stays there when it is packed again") {
    for (const char* recipe : {"torus:quads=900,bumps=0.2", "terrain:size=30x20,double",
                               "polygons:mixed,size=14x14", "tets:ball=5,jitter=0.2"})
        for (const int bits : {9, 12, 15}) {
            EncodeOptions options;
            options.position_bits = bits;
            INFO(recipe << ", " << bits << " bits");
            const Mesh once = comes_back(made(recipe), options);
            const Result<Encoded> packed = encode(once, options);
            REQUIRE(packed.ok());
            CHECK(packed->position_error < 0.1 * packed->position_bound);
        }
}

TEST_CASE("options for grids that make no sense are refused") {
    const Mesh mesh = test::quad_grid(2, 2);
    const auto code = [&](auto set) {
        EncodeOptions options;
        set(options);
        const Result<Encoded> packed = encode(mesh, options);
        return packed.ok() ? std::string("packed") : name_of(packed.error().code);
    };
    const std::string bad = name_of(Code::bad_option);
    CHECK(code([](EncodeOptions& o) { o.lattice = 0.3; }) == bad);
    CHECK(code([](EncodeOptions& o) { o.lattice = -1; }) == bad);
    CHECK(code([](EncodeOptions& o) { o.lattice = std::nan(""); }) == bad);
    CHECK(code([](EncodeOptions& o) { o.lattice = 0x1p-60; }) == bad);
    CHECK(code([](EncodeOptions& o) {
              o.lattice = 1;
              o.position_bits = 9;
          }) == bad);
    CHECK(code([](EncodeOptions& o) { o.max_error_relative = 2; }) == bad);
    CHECK(code([](EncodeOptions& o) { o.max_error_relative = 0; }) == bad);
    CHECK(code([](EncodeOptions& o) {
              o.max_error_relative = 0.1;
              o.max_error = 0.1;
          }) == bad);
    CHECK(code([](EncodeOptions& o) { o.lattice = 0.25; }) == "packed");
}

TEST_CASE("what was decoded packs to the same bytes again") {
    for (const char* recipe :
         {"torus:quads=900", "polygons:mixed,size=14x14,shuffle", "terrain:size=30x20,holes=4",
          "tets:box=5,five,jitter=0.3,shuffle", "tets:ball=5,copies=2", "polygons:cap,size=30",
          "tets:box=7,shuffle", "tets:box=6x5x7,five,shuffle", "tets:ball=6,shuffle"}) {
        const Mesh mesh = made(recipe);
        const Result<Encoded> first = encode(mesh, {});
        REQUIRE(first.ok());
        const Result<Decoded> decoded = decode(first->bytes);
        REQUIRE(decoded.ok());
        const Result<Encoded> again = encode(decoded->mesh, {});
        REQUIRE(again.ok());
        INFO(recipe);
        CHECK(first->bytes == again->bytes);
    }
}

TEST_CASE("decimals whose last digits differ are told apart") {
    // 6.000000000000002 and 6.000000000000003 are the same double in units of 1e-14.
    std::mt19937_64 random(1);
    Mesh mesh = made("grid:size=15x15,double");
    auto x = mesh.positions.as<double>();
    for (std::size_t i = 0; i < x.size(); ++i) {
        const auto digits = static_cast<double>(random() % 1000000000000000);
        x[i] = i % 3 == 2 ? (random() % 2 ? 6.000000000000002 : 6.000000000000003)
               : i < 48   ? 9.5 + digits / 1e16
                          : 6 + digits / 1e15;
    }
    EncodeOptions options;
    CHECK(test::trouble(mesh, options) == "");
    options.fast = true;
    CHECK(test::trouble(mesh, options) == "");
}

TEST_CASE("numbers are chosen whatever the order of the points") {
    std::mt19937_64 random(1);
    Mesh mesh = made("grid:size=270x270,double,shuffle");
    auto x = mesh.positions.as<double>();
    for (double& c : x) {
        c = std::nearbyint(c * 1000) / 1000 + static_cast<double>(random() % 100) / 1000;
        if (random() % 8 == 0) c += static_cast<double>(random() % 1000000) * 1e-16;
    }
    const Result<Encoded> first = encode(mesh);
    REQUIRE(first.ok());
    const Result<Decoded> decoded = decode(first->bytes);
    REQUIRE(decoded.ok());
    const Result<Encoded> second = encode(decoded->mesh);
    REQUIRE(second.ok());
    CHECK(first->bytes == second->bytes);
}
