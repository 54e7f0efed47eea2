// Companions that are parts of the mesh come back, in the order of the walk or as they were, and
// cost next to nothing.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include "make/make_mesh.h"
#include "make/random.h"
#include "support/mesh_from_bytes.h"

using namespace ravel;

namespace {

constexpr std::size_t kFacets[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

// Facets of tets (sides of polygons), how often each.
std::map<std::vector<Index>, std::pair<int, std::vector<Index>>> parts_of(const Mesh& mesh) {
    std::map<std::vector<Index>, std::pair<int, std::vector<Index>>> parts;
    const auto add = [&](std::vector<Index> nodes) {
        auto key = nodes;
        std::sort(key.begin(), key.end());
        auto& part = parts[key];
        ++part.first;
        part.second = std::move(nodes);
    };
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const auto cell = mesh.cell(c);
        if (mesh.kind == CellKind::tet)
            for (const auto& f : kFacets) add({cell[f[0]], cell[f[1]], cell[f[2]]});
        else
            for (std::size_t i = 0; i < cell.size(); ++i)
                add({cell[i], cell[(i + 1) % cell.size()]});
    }
    return parts;
}

Mesh made(const char* recipe) {
    Result<Mesh> mesh = make::make_mesh(recipe);
    REQUIRE(mesh.ok());
    return std::move(*mesh);
}

// The parts for which `chosen` (times it occurs) says so, each turned anyhow, in any order.
template <class Chosen>
CompanionBlock block_of(const Mesh& mesh, make::Random& random, const Chosen& chosen) {
    const auto nodes = static_cast<std::uint32_t>(mesh.kind == CellKind::tet ? 3 : 2);
    CompanionBlock block{static_cast<std::uint16_t>(nodes == 3 ? 5 : 3), nodes, 0, {}, {}};
    std::vector<std::vector<Index>> cells;
    for (const auto& [key, part] : parts_of(mesh))
        if (chosen(part.first)) cells.push_back(part.second);
    for (std::size_t i = cells.size(); i > 1; --i) std::swap(cells[i - 1], cells[random.below(i)]);
    for (auto& cell : cells) {
        std::rotate(cell.begin(), cell.begin() + static_cast<std::ptrdiff_t>(random.below(nodes)),
                    cell.end());
        block.nodes.insert(block.nodes.end(), cell.begin(), cell.end());
        ++block.cell_count;
    }
    return block;
}

void check(const Mesh& mesh) {
    for (const bool order : {false, true}) {
        EncodeOptions options;
        options.level = 1;
        options.keep_order = order;
        INFO((order ? "order kept" : "order of the walk"));
        CHECK(test::trouble(mesh, options) == "");
        if (!order) continue;
        const auto again = decode(encode(mesh, options)->bytes);
        REQUIRE(again.ok());
        for (std::size_t b = 0; b < mesh.companions.size(); ++b) {
            CHECK(again->mesh.companions[b].nodes == mesh.companions[b].nodes);
            CHECK(again->mesh.companions[b].hosts == mesh.companions[b].hosts);
        }
        for (std::size_t a = 0; a < mesh.attributes.size(); ++a)
            CHECK(again->mesh.attributes[a].values.bytes == mesh.attributes[a].values.bytes);
    }
}

std::size_t section_bytes(const Mesh& mesh, const std::string& name) {
    const auto info = inspect(encode(mesh)->bytes);
    for (const SectionInfo& section : info->sections)
        if (section.name == name) return section.bytes;
    return 0;
}

constexpr const char* kRecipes[] = {"tets:box=3,jitter=0.3,shuffle",
                                    "tets:shell=3,companions",
                                    "tets:ball=4,copies=2",
                                    "soup:tets=60,seed=5",
                                    "polygons:mixed,size=6x6,shuffle",
                                    "terrain:size=7x7,holes=3",
                                    "soup:polygons=50,seed=2",
                                    "tiny:tets-on-one-face"};

}  // namespace

TEST_CASE("borders, inner parts, all parts and parts twice come back as companions") {
    for (const char* recipe : kRecipes)
        for (int which = 0; which < 4; ++which) {
            Mesh mesh = made(recipe);
            mesh.attributes.clear();
            make::Random random{static_cast<std::uint64_t>(which)};
            mesh.companions.push_back(block_of(mesh, random, [&](int times) {
                return which == 0   ? times == 1
                       : which == 1 ? times > 1
                                    : which == 2 || random.one_in(3);
            }));
            if (which == 3) mesh.companions.push_back(mesh.companions.back());
            INFO(recipe << ", choice " << which);
            check(mesh);
        }
}

TEST_CASE("parts among others that are none, with values, come back") {
    for (const char* recipe : kRecipes) {
        Mesh mesh = made(recipe);
        mesh.attributes.clear();
        make::Random random{7};
        mesh.companions.push_back(block_of(mesh, random, [&](int times) { return times == 1; }));
        CompanionBlock& block = mesh.companions.back();
        for (std::size_t i = 0; i < block.nodes.size(); i += 5)
            block.nodes[i] = random.below(mesh.point_count());
        CompanionBlock points{1, 1, 0, {}, {}}, lines{3, 2, 0, {}, {}};
        for (Index p = 0; p < mesh.point_count(); p += 1 + random.below(4))
            points.nodes.push_back(p), ++points.cell_count;
        for (Index c = 0; c < mesh.cell_count(); ++c) {
            const auto cell = mesh.cell(c);
            if (cell.size() < 2 || random.one_in(2)) continue;
            lines.nodes.insert(lines.nodes.end(), {cell[1], cell[0]});
            ++lines.cell_count;
        }
        mesh.companions.push_back(points);
        mesh.companions.push_back(lines);
        mesh.companions.push_back({13, 6, 0, {}, {}});
        Attribute tag;
        tag.name = "tag";
        tag.place = Place::companion;
        tag.values = make_array(Scalar::i32, 1, mesh.companion_count());
        for (Index i = 0; i < mesh.companion_count(); ++i)
            tag.values.as<std::int32_t>()[i] = static_cast<std::int32_t>(i / 11 % 4);
        mesh.attributes.push_back(tag);
        REQUIRE(check_mesh(mesh).ok());
        INFO(recipe);
        check(mesh);
    }
}

TEST_CASE("a border that is wholly tagged costs less than 1.5 bits per triangle") {
    for (const char* recipe : {"tets:box=9,jitter=0.2,shuffle", "tets:ball=9", "tets:shell=8"}) {
        Mesh mesh = made(recipe);
        mesh.companions.clear();
        mesh.attributes.clear();
        make::Random random{3};
        mesh.companions.push_back(block_of(mesh, random, [](int times) { return times == 1; }));
        const CompanionBlock& block = mesh.companions.back();
        // Patches by which way the triangle looks.
        Attribute tag;
        tag.place = Place::companion;
        tag.values = make_array(Scalar::i32, 1, block.cell_count);
        const bool narrow = mesh.positions.scalar == Scalar::f32;
        for (Index i = 0; i < block.cell_count; ++i) {
            double sum[3] = {0, 0, 0};
            for (Index k = 0; k < 9; ++k) {
                const Index at = 3 * block.nodes[3 * i + k / 3] + k % 3;
                sum[k % 3] += narrow ? static_cast<double>(mesh.positions.as<float>()[at])
                                     : mesh.positions.as<double>()[at];
            }
            int patch = 0;
            for (int k = 1; k < 3; ++k)
                if (std::abs(sum[k]) > std::abs(sum[patch])) patch = k;
            tag.values.as<std::int32_t>()[i] = 10 * patch + (sum[patch] > 0);
        }
        mesh.attributes.push_back(tag);
        const double bits = 8.0 * static_cast<double>(section_bytes(mesh, "companions") +
                                                      section_bytes(mesh, "attributes"));
        INFO(recipe << ": " << block.cell_count << " triangles");
        CHECK(bits < 1.5 * static_cast<double>(block.cell_count));
        // Marked alone it is nearly free.
        CHECK(8.0 * static_cast<double>(section_bytes(mesh, "companions")) <
              0.5 * static_cast<double>(block.cell_count));
    }
}

TEST_CASE("a comparison sees companions moved or turned otherwise than the maps say") {
    Mesh mesh = made("tets:box=2");
    make::Random random{1};
    mesh.companions.assign(1, block_of(mesh, random, [](int times) { return times == 1; }));
    const auto packed = encode(mesh);
    const auto again = decode(packed->bytes);
    REQUIRE(compare_meshes(mesh, again->mesh, packed->order, 0).equal);
    OrderMaps maps = packed->order;
    std::swap(maps.companion[0], maps.companion[1]);
    CHECK_FALSE(compare_meshes(mesh, again->mesh, maps, 0).equal);
    maps = packed->order;
    maps.companion_turn[3] = (maps.companion_turn[3] + 1) % 3;
    CHECK_FALSE(compare_meshes(mesh, again->mesh, maps, 0).equal);
    maps = packed->order;
    maps.companion.clear();
    CHECK_FALSE(compare_meshes(mesh, again->mesh, maps, 0).equal);
}
