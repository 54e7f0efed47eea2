// Tets that repeat, and places that many vertices share, cost next to nothing, and round borders
// less than others; what does not fit a mesh's numbers costs itself and nothing else.
#include <catch2/catch.hpp>

#include <cmath>
#include <string>

#include "make/make_mesh.h"
#include "ravel/ravel.h"
#include "support/mesh_from_bytes.h"

using namespace ravel;

namespace {

Mesh made(const std::string& recipe) {
    auto mesh = make::make_mesh(recipe);
    REQUIRE(mesh.ok());
    return std::move(*mesh);
}

struct Cost {
    double bits_per_cell = 0;
    double connectivity = 0;  // bits per cell
};

Cost cost_of(const Mesh& mesh, std::optional<int> bits, bool fast = false) {
    EncodeOptions options;
    options.position_bits = bits;
    options.fast = fast;
    CHECK(test::trouble(mesh, options) == "");
    const Result<Encoded> packed = encode(mesh, options);
    REQUIRE(packed.ok());
    const auto cells = static_cast<double>(mesh.cell_count());
    return {8 * static_cast<double>(packed->bytes.size()) / cells,
            8 * packed->connectivity_ideal_bytes / cells};
}

}  // namespace

TEST_CASE("cubes that are cut alike cost next to nothing") {
    for (const char* recipe : {"tets:box=14", "tets:box=14,five", "tets:box=14,double,shuffle",
                               "tets:box=20x10x12,copies=3"})
        for (const std::optional<int> bits : {std::optional<int>{}, std::optional<int>{14}})
            for (const bool fast : {false, true}) {
                INFO(recipe << ", " << bits.value_or(0) << " bits, fast " << fast);
                const Cost cost = cost_of(made(recipe), bits, fast);
                CHECK(cost.connectivity < 0.1);
                CHECK(cost.bits_per_cell < 0.25);
            }
}

TEST_CASE("cubes that are cut alike and bent cost little more") {
    struct Bent {
        const char* recipe;
        double connectivity, all;  // bits per cell, at most
    };
    for (const Bent& bent :
         {Bent{"tets:box=40x8x8,bend=90", 0.09, 0.6}, Bent{"tets:box=40x8x8,twist=90", 0.12, 1.4},
          Bent{"tets:box=24x10x10,bend=60,five,shuffle", 0.2, 0.9},
          Bent{"tets:box=40x8x8,bend=200,twist=30,double", 0.2, 3}}) {
        INFO(bent.recipe);
        const Cost cost = cost_of(made(bent.recipe), 14);
        CHECK(cost.connectivity < bent.connectivity);
        CHECK(cost.bits_per_cell < bent.all);
        CHECK(cost_of(made(bent.recipe), 14, true).connectivity < 1.1 * bent.connectivity);
        cost_of(made(bent.recipe), {});
    }
}

TEST_CASE("rough tets by folds take a few bits, and so does what folds cannot walk") {
    for (const char* recipe : {"tets:ball=9,jitter=0.3", "tets:shell=9,jitter=0.3,double,shuffle"})
        for (const std::optional<int> bits : {std::optional<int>{}, std::optional<int>{14}}) {
            INFO(recipe << ", " << bits.value_or(0) << " bits");
            CHECK(cost_of(made(recipe), bits, true).connectivity < 3);
        }
    // In the last one facets have the same vertices and do not meet.
    for (const char* recipe :
         {"tiny:tets-on-one-face", "soup:tets=200,seed=5", "soup:tets=1000,seed=1"})
        cost_of(made(recipe), 9, true);
}

TEST_CASE("a ball of cubes costs less than one whose points are astray") {
    const Cost even = cost_of(made("tets:ball=9"), 14);
    const Cost rough = cost_of(made("tets:ball=9,jitter=0.3"), 14);
    CHECK(even.connectivity < 0.8 * rough.connectivity);
    CHECK(even.bits_per_cell < 0.6 * rough.bits_per_cell);
}

TEST_CASE("cubes whose points are astray still lead each other") {
    // Without leaders 0.7 to 1 bit a tet.
    CHECK(cost_of(made("tets:box=14,jitter=0.05"), 14).connectivity < 0.25);
    CHECK(cost_of(made("tets:box=14,jitter=0.2,five"), 14).connectivity < 0.35);
    // Hardly two shapes are alike; but points have as many tets around as others.
    CHECK(cost_of(made("tets:ball=16,jitter=0.2"), 14).connectivity < 1.65);
}

TEST_CASE("rough tets pay nothing for leaders that some shapes might have") {
    // Half of it repeats, half does not.
    Mesh mesh = made("tets:box=20x8x8,jitter=0.001,double");
    const Cost even = cost_of(mesh, 14);
    auto x = mesh.positions.as<double>();
    for (std::size_t i = 0; i < x.size() / 2; ++i)
        x[i] += 0.3 * (static_cast<double>(i * 7919 % 997) / 997 - 0.5);
    const Cost half = cost_of(mesh, 14), rough = cost_of(made("tets:box=20x8x8,jitter=0.3"), 14);
    CHECK(even.connectivity < 0.3);
    CHECK(half.connectivity < 0.5 * (even.connectivity + rough.connectivity) + 0.1);
}

TEST_CASE("a lattice with holes, and one beside rough tets, come back") {
    Mesh mesh = made("tets:box=8,companions,attributes");
    // Every seventh tet goes.
    std::vector<Index> corners;
    for (Index c = 0; c < mesh.cell_count(); ++c)
        if (c % 7 != 3)
            corners.insert(corners.end(), mesh.corners.begin() + static_cast<std::ptrdiff_t>(4 * c),
                           mesh.corners.begin() + static_cast<std::ptrdiff_t>(4 * c + 4));
    Mesh holes;
    holes.kind = CellKind::tet;
    holes.positions = mesh.positions;
    holes.corners = corners;
    for (const bool order : {false, true}) {
        EncodeOptions options;
        options.keep_order = order;
        options.position_bits = 12;
        CHECK(test::trouble(holes, options) == "");
        options.position_bits = {};
        CHECK(test::trouble(holes, options) == "");
        CHECK(test::trouble(mesh, options) == "");
    }
    auto x = holes.positions.as<float>();
    for (std::size_t i = 0; i < x.size() / 2; ++i) x[i] += 0.01f * static_cast<float>(i * i % 17);
    CHECK(test::trouble(holes, {}) == "");
}

TEST_CASE("levels of a grid cost once, whether neighbours have them or not") {
    // Steps of a 14-bit grid do not divide the sheet: each line is rounded in its own way.
    CHECK(cost_of(made("grid:size=60x60,triangles"), 14).bits_per_cell < 0.3);
    CHECK(cost_of(made("grid:size=60x60"), 14).bits_per_cell < 0.25);
}

TEST_CASE("a coordinate that is no number of the mesh costs itself alone") {
    Mesh mesh = made("tets:box=8,jitter=0.2,double");
    auto x = mesh.positions.as<double>();
    for (double& c : x) c = std::nearbyint(1000 * c) / 1000;
    const Cost before = cost_of(mesh, {});
    // One coordinate in thirty has another last bit, as after some arithmetic.
    std::size_t few = 0;
    for (std::size_t i = 0; i < x.size(); i += 31, ++few) x[i] = std::nextafter(x[i], 100.0);
    const Cost after = cost_of(mesh, {});
    const double each = (after.bits_per_cell - before.bits_per_cell) *
                        static_cast<double>(mesh.cell_count()) / static_cast<double>(few);
    CHECK(each < 100);
    CHECK(after.connectivity < 1.2 * before.connectivity);
}

TEST_CASE("a border on a round face costs less than one near it") {
    for (const std::string recipe :
         {"tets:ball=9,slide=0.5", "tets:box=30x6x6,round,slide=0.5", "tets:shell=9,slide=0.5",
          "tets:box=30x6x6,round,bend=90,slide=0.5", "tets:box=60x5x5,round,bend=340,slide=0.5"})
        for (const std::optional<int> bits : {std::optional<int>{}, std::optional<int>{14}}) {
            INFO(recipe << ", " << bits.value_or(0) << " bits");
            const Cost on = cost_of(made(recipe), bits);
            const Cost near = cost_of(made(recipe + ",jitter=0.05"), bits);
            CHECK(on.bits_per_cell < 0.97 * near.bits_per_cell);
        }
}
