// Every mesh comes back: small meshes and recipes under every kind of option, and meshes from
// random bytes.
#include <catch2/catch.hpp>

#include <string>

#include "make/make_mesh.h"
#include "make/random.h"
#include "support/mesh_from_bytes.h"
#include "support/small_meshes.h"

using namespace ravel;

namespace {

struct NamedOptions {
    std::string name;
    EncodeOptions options;
};

std::vector<NamedOptions> all_options() {
    std::vector<NamedOptions> all;
    const auto add = [&](const std::string& name, auto change) {
        EncodeOptions options;
        options.level = 1;
        change(options);
        all.push_back({name, options});
        options.keep_order = true;
        all.push_back({name + ", order kept", options});
    };
    add("lossless", [](EncodeOptions&) {});
    add("float32", [](EncodeOptions& o) { o.float32 = true; });
    for (const int bits : {1, 8, 14, 30})
        add(std::to_string(bits) + " bits", [&](EncodeOptions& o) { o.position_bits = bits; });
    for (const double error : {1e-6, 0.01, 0.3, 1e6, 1e299})
        add("error " + std::to_string(error), [&](EncodeOptions& o) { o.max_error = error; });
    add("float32 of 12 bits", [](EncodeOptions& o) { o.float32 = true, o.position_bits = 12; });
    add("no links", [](EncodeOptions& o) { o.strip_budget = 0; });
    add("any links", [](EncodeOptions& o) { o.strip_budget = 1e9; });
    return all;
}

void check(const std::string& name, const Mesh& mesh) {
    for (const auto& [options_name, options] : all_options()) {
        INFO(name << ", " << options_name);
        CHECK(test::trouble(mesh, options) == "");
    }
}

Mesh as_float32(const Mesh& mesh) {
    Mesh out = mesh;
    out.positions = make_array(Scalar::f32, 3, mesh.point_count());
    for (std::size_t i = 0; i < 3 * mesh.point_count(); ++i)
        out.positions.as<float>()[i] = static_cast<float>(mesh.positions.as<double>()[i]);
    return out;
}

}  // namespace

TEST_CASE("every small mesh comes back under every option") {
    for (const auto& [name, mesh, clean] : test::small_meshes()) check(name, mesh);
}

TEST_CASE("every small mesh of float32 comes back") {
    for (const auto& [name, mesh, clean] : test::small_meshes()) {
        if (mesh.positions.scalar != Scalar::f64) continue;
        const Mesh narrow = as_float32(mesh);
        for (const bool order : {false, true}) {
            EncodeOptions options;
            options.level = 1;
            options.keep_order = order;
            INFO(name);
            CHECK(test::trouble(narrow, options) == "");
            options.position_bits = 14;
            CHECK(test::trouble(narrow, options) == "");
        }
    }
}

TEST_CASE("made meshes come back under every option") {
    for (const char* recipe :
         {"tiny:empty", "tiny:empty-tets", "tiny:points", "tiny:tet-points", "tiny:degrees-0-1-2",
          "tiny:bow-tie", "tiny:point-cell", "tiny:flat-tet", "tiny:tets-twice",
          "polygons:mixed,size=12x12,attributes,shuffle", "terrain:size=20x20,holes=5,double",
          "polygons:cap,size=30", "tets:box=3,five,jitter=0.3,double",
          "tets:shell=4,attributes,companions,shuffle", "tets:ball=4,copies=2"}) {
        const Result<Mesh> mesh = make::make_mesh(recipe);
        REQUIRE(mesh.ok());
        check(recipe, *mesh);
    }
}

TEST_CASE("soups come back, each under some option") {
    const auto options = all_options();
    for (std::size_t seed = 1; seed <= 400; ++seed) {
        const std::string recipe =
            std::string(seed % 2 == 0 ? "soup:tets=" : "soup:polygons=") +
            std::to_string(seed * 13 % 150) + ",seed=" + std::to_string(seed) +
            (seed % 3 == 0 ? ",double" : "") + (seed % 4 == 0 ? ",attributes" : "") +
            (seed % 8 == 0 ? ",companions" : "");
        const Result<Mesh> mesh = make::make_mesh(recipe);
        REQUIRE(mesh.ok());
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& [name, chosen] = options[(seed * 7 + i * 11) % options.size()];
            INFO(recipe << ", " << name);
            CHECK(test::trouble(*mesh, chosen) == "");
        }
    }
}

TEST_CASE("meshes from random bytes come back") {
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        make::Random random{seed};
        std::vector<std::byte> bytes(random.below(700));
        for (std::byte& b : bytes) b = static_cast<std::byte>(random.next() >> 20);
        const test::MeshCase made = test::mesh_from_bytes(bytes);
        INFO("seed " << seed);
        REQUIRE(test::trouble(made.mesh, made.options) == "");
    }
}
