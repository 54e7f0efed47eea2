// Meshes through the codec and back, in memory: every recipe, and some hundred soups.
#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "make/make_mesh.h"
#include "ravel/ravel.h"

namespace {

std::vector<ravel::EncodeOptions> option_rows() {
    std::vector<ravel::EncodeOptions> rows(6);
    rows[1].position_bits = 10;
    rows[2].keep_order = true;
    rows[3].max_error = 0.01;
    rows[4].strip_budget = 0;
    rows[4].float32 = true;
    rows[5].position_bits = 12;
    rows[5].fast = true;
    for (ravel::EncodeOptions& row : rows) row.level = 3;
    return rows;
}

void round_positions(ravel::Mesh& mesh) {
    if (mesh.positions.scalar == ravel::Scalar::f32) return;
    ravel::Array rounded = ravel::make_array(ravel::Scalar::f32, 3, mesh.point_count());
    for (std::size_t i = 0; i < rounded.as<float>().size(); ++i)
        rounded.as<float>()[i] = static_cast<float>(mesh.positions.as<double>()[i]);
    mesh.positions = std::move(rounded);
}

// Empty, or what went wrong.
std::string trouble(const ravel::Mesh& mesh, const ravel::EncodeOptions& options) {
    const auto packed = ravel::encode(mesh, options);
    // A small error on a huge mesh is more than any grid can promise, and is said so.
    if (!packed && options.max_error && packed.error().code == ravel::Code::bad_option) return {};
    if (!packed) return "encode: " + packed.error().detail;
    ravel::DecodeOptions all;
    all.steps = true;
    const auto again = ravel::decode(packed->bytes, all);
    if (!again) return "decode: " + again.error().detail;
    if (const auto status = ravel::check_mesh(again->mesh); !status) return status.error().detail;
    if (again->steps.size() != mesh.cell_count()) return "not one step per cell";
    ravel::Mesh expected = mesh;
    if (options.float32) round_positions(expected);
    const auto found =
        ravel::compare_meshes(expected, again->mesh, packed->order, packed->position_bound);
    if (!found.equal) return "differs: " + found.difference;
    if (options.keep_order && !found.order_kept) return "the order was not kept";
    if (options.max_error && found.max_error > *options.max_error) return "the bound was not kept";
    const auto twice = ravel::encode(mesh, options);
    if (!twice || twice->bytes != packed->bytes) return "encoding twice gives other bytes";
    return {};
}

void check(const std::string& recipe) {
    const auto mesh = ravel::make::make_mesh(recipe);
    REQUIRE(mesh.ok());
    int row = 0;
    for (const ravel::EncodeOptions& options : option_rows()) {
        INFO(recipe << ", option row " << row++);
        CHECK(trouble(*mesh, options) == "");
    }
}

}  // namespace

TEST_CASE("soups of polygons come back", "[roundtrip][soup]") {
    for (int seed = 1; seed <= 250; ++seed)
        check("soup:polygons=" + std::to_string(5 + seed * 7 % 90) +
              ",seed=" + std::to_string(seed) + (seed % 3 == 0 ? ",double" : "") +
              (seed % 5 == 0 ? ",attributes" : ""));
}

TEST_CASE("soups of tets come back", "[roundtrip][soup]") {
    for (int seed = 1; seed <= 250; ++seed)
        check("soup:tets=" + std::to_string(5 + seed * 7 % 90) + ",seed=" + std::to_string(seed) +
              (seed % 3 == 0 ? ",double" : "") + (seed % 5 == 0 ? ",attributes,companions" : ""));
}

TEST_CASE("large soups come back", "[roundtrip][soup]") {
    check("soup:polygons=20000,seed=1");
    check("soup:tets=20000,seed=2");
}

TEST_CASE("the smallest meshes come back", "[roundtrip]") {
    for (const auto& help : ravel::make::recipe_help()) {
        if (help.pattern != "tiny:NAME") continue;
        for (std::size_t at = 0; at < help.says.size();) {
            const std::size_t end = std::min(help.says.find(' ', at), help.says.size());
            check("tiny:" + help.says.substr(at, end - at));
            at = end + 1;
        }
    }
}

TEST_CASE("every family of made meshes comes back", "[roundtrip]") {
    for (const char* recipe : {"grid",
                               "grid:triangles,jitter=0.5",
                               "torus:size=24x12,double",
                               "torus:quads=5000,shuffle",
                               "sphere:subdivide=3",
                               "sphere:subdivide=4,bumps=0.3,double",
                               "moebius",
                               "moebius:size=9x1",
                               "terrain:size=40x40,holes=7,double",
                               "polygons:hex,size=12x12",
                               "polygons:mixed,size=30x30",
                               "polygons:cap,size=200",
                               "polygons:mixed,attributes,shuffle,copies=3",
                               "tets:box=6",
                               "tets:box=5,five,jitter=0.3",
                               "tets:ball=6,double",
                               "tets:shell=8,jitter=0.2",
                               "tets:box=4,copies=3,shuffle,attributes,companions",
                               "grid:size=1x300",
                               "tets:box=1x1x60"})
        check(recipe);
}
