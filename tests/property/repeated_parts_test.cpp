// Parts that repeat, moved, turned, mirrored or in the same place, come back, and cost little after
// the first.
#include <catch2/catch.hpp>

#include <array>
#include <functional>
#include <random>
#include <string>

#include "ravel/ravel.h"
#include "support/mesh_from_bytes.h"

using namespace ravel;

namespace {

constexpr Index kSide = 9;  // points along a side of a part
using Point = std::array<double, 3>;
using Placed = std::function<Point(Point, int)>;

// `parts` crumpled sheets of quads; coordinates are decimals of three places.
Mesh sheets(int parts, const Placed& place, bool mirrored, bool decimals) {
    std::mt19937 random(5);
    std::vector<Point> sheet;
    for (Index i = 0; i < kSide * kSide; ++i)
        sheet.push_back({static_cast<double>(i % kSide * 100 + random() % 60),
                         static_cast<double>(i / kSide * 100 + random() % 60),
                         static_cast<double>(random() % 90)});
    Mesh mesh;
    mesh.positions = make_array(Scalar::f64, 3, static_cast<std::size_t>(parts) * sheet.size());
    mesh.corner_begin = {0};
    std::size_t at = 0;
    for (int part = 0; part < parts; ++part) {
        const Index first = static_cast<Index>(part) * kSide * kSide;
        for (const Point& p : sheet)
            for (const double x : place(p, part))
                mesh.positions.as<double>()[at++] = decimals ? std::nearbyint(x) / 1000 : x / 1000;
        for (Index y = 0; y + 1 < kSide; ++y)
            for (Index x = 0; x + 1 < kSide; ++x) {
                const Index a = first + y * kSide + x, b = a + 1, c = b + kSide, d = a + kSide;
                if (mirrored && part % 2 == 1)
                    mesh.corners.insert(mesh.corners.end(), {a, d, c, b});
                else
                    mesh.corners.insert(mesh.corners.end(), {a, b, c, d});
                mesh.corner_begin.push_back(mesh.corners.size());
            }
    }
    return mesh;
}

double bytes_per_part(const Placed& place, int parts, bool mirrored, bool decimals,
                      std::optional<int> bits) {
    EncodeOptions options;
    options.position_bits = bits;
    const Mesh mesh = sheets(parts, place, mirrored, decimals);
    CHECK(test::trouble(mesh, options) == "");
    const Result<Encoded> packed = encode(mesh, options);
    REQUIRE(packed.ok());
    return static_cast<double>(packed->bytes.size()) / parts;
}

// What a part costs among many, of what it costs where all are different.
double share(const Placed& place, bool mirrored, bool decimals, std::optional<int> bits) {
    const int parts = 40;
    std::mt19937 random(9);
    const Placed crumpled = [&](Point p, int part) {
        Point q = place(p, part);
        for (double& x : q) x += static_cast<double>(random() % 60) - 30;
        return q;
    };
    return bytes_per_part(place, parts, mirrored, decimals, bits) /
           bytes_per_part(crumpled, parts, mirrored, decimals, bits);
}

}  // namespace

TEST_CASE("parts in the same place cost little") {
    const Placed place = [](Point p, int) { return p; };
    CHECK(share(place, false, true, {}) < 0.25);
    CHECK(share(place, false, false, {}) < 0.25);
    CHECK(share(place, false, true, 14) < 0.25);
}

TEST_CASE("parts that are moved cost little") {
    const Placed place = [](Point p, int part) {
        return Point{p[0] + 997 * part, p[1] + 31 * (part % 7), p[2] - 12 * part};
    };
    CHECK(share(place, false, true, {}) < 0.35);
    CHECK(share(place, false, true, 16) < 0.5);
}

TEST_CASE("parts of two or three shapes that take turns cost little, too") {
    for (const int shapes : {2, 3}) {
        const Placed place = [=](Point p, int part) {
            // Each shape has the points elsewhere, and each point in its own way.
            const auto rough = static_cast<int>(p[0] * 7 + p[1] * 13 + p[2] * 29);
            const int off = rough * (part % shapes) % 61;
            return Point{p[0] + 997 * part + off, p[1] + 31 * (part % 7) - off, p[2] + off % 17};
        };
        INFO(shapes << " shapes");
        CHECK(share(place, false, true, {}) < 0.2);
        CHECK(share(place, false, true, 16) < 0.3);
    }
}

TEST_CASE("parts of a few shapes in any order cost little, for each is told which leads it") {
    const Placed place = [](Point p, int part) {
        const auto rough = static_cast<int>(p[0] * 7 + p[1] * 13 + p[2] * 29);
        const int shape = part * part * 7 % 11 % 4;  // 0 3 2 0 ..: no turn that comes again soon
        const int off = rough * shape % 61;
        return Point{p[0] + 997 * part + off, p[1] + 31 * (part % 7) - off, p[2] + off % 17};
    };
    CHECK(share(place, false, true, {}) < 0.25);
    CHECK(share(place, false, true, 16) < 0.35);
}

TEST_CASE("parts that are turned and stretched cost less") {
    const Placed place = [](Point p, int part) {
        const double c = 0.8 + 0.01 * part, s = 0.6 - 0.013 * part;
        return Point{c * p[0] - s * p[1] + 2000 * part, s * p[0] + c * p[1], p[2]};
    };
    CHECK(share(place, false, true, {}) < 0.8);
    CHECK(share(place, false, false, 16) < 0.8);
}

TEST_CASE("mirror images cost half") {
    const Placed place = [](Point p, int part) {
        const Point q{p[0] + 5, p[1] + 1000 * (part / 2), p[2]};
        return part % 2 == 1 ? Point{-q[0], q[1], q[2]} : q;
    };
    CHECK(share(place, true, true, {}) < 0.75);
    CHECK(share(place, true, true, 14) < 0.8);
}

TEST_CASE("escaped coordinates and zeros of both signs among repeated parts come back") {
    Mesh mesh = sheets(
        6,
        [](Point p, int part) {
            return Point{p[0], p[1] + 900 * part, p[2]};
        },
        false, true);
    auto x = mesh.positions.as<double>();
    x[7] = std::numeric_limits<double>::quiet_NaN();
    x[300] = -std::numeric_limits<double>::infinity();
    x[301] = 1e300;
    x[302] = -0.0;
    x[500] = 0.0;
    x[501] = 5e-324;
    x[502] = 1e22;
    for (const bool narrow : {false, true})
        for (const std::optional<int> bits : {std::optional<int>{}, std::optional<int>{14}}) {
            EncodeOptions options;
            options.position_bits = bits;
            options.float32 = narrow;
            CHECK(test::trouble(mesh, options) == "");
        }
}
