// Quadratic tets cost little more than their corners: the nodes follow from the edges, and lie
// near their middles. Whatever does not fit comes back all the same.
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <numeric>

#include "make/make_mesh.h"
#include "make/random.h"
#include "ravel/ravel.h"

using namespace ravel;

namespace {

constexpr std::size_t kEnds[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};

Mesh made(const char* recipe) {
    Result<Mesh> mesh = make::make_mesh(recipe);
    REQUIRE(mesh.ok());
    return std::move(*mesh);
}

// The mesh with a point of its own for every edge, in the middle but for `jitter`; nodes and tets
// in any order, and a smooth field at the points.
Mesh quadratic(Mesh mesh, std::uint64_t seed, double jitter = 0) {
    make::Random random{seed};
    mesh.attributes.clear();
    mesh.companions.clear();
    std::map<std::pair<Index, Index>, Index> node_of;
    for (Index c = 0; c < mesh.cell_count(); ++c)
        for (const auto& end : kEnds)
            node_of.insert({std::minmax(mesh.cell(c)[end[0]], mesh.cell(c)[end[1]]), 0});
    const Index corners = mesh.point_count();
    std::vector<Index> number(node_of.size());
    std::iota(number.begin(), number.end(), corners);
    for (std::size_t i = number.size(); i > 1; --i)
        std::swap(number[i - 1], number[random.below(i)]);
    Array positions = make_array(Scalar::f64, 3, corners + node_of.size());
    const auto x = positions.as<double>();
    for (std::size_t i = 0; i < 3 * corners; ++i)
        x[i] = mesh.positions.scalar == Scalar::f64
                   ? mesh.positions.as<double>()[i]
                   : static_cast<double>(mesh.positions.as<float>()[i]) / 3;
    std::size_t e = 0;
    for (auto& [ends, node] : node_of) {
        node = number[e++];
        for (std::size_t k = 0; k < 3; ++k)
            x[3 * node + k] = (x[3 * ends.first + k] + x[3 * ends.second + k]) / 2 +
                              jitter * (static_cast<double>(random.below(2001)) / 1000 - 1);
    }
    mesh.positions = std::move(positions);
    std::vector<Index> hosts(mesh.cell_count());
    std::iota(hosts.begin(), hosts.end(), Index{0});
    for (std::size_t i = hosts.size(); i > 1; --i) std::swap(hosts[i - 1], hosts[random.below(i)]);
    CompanionBlock block{24, 6, mesh.cell_count(), {}, hosts};
    for (const Index host : hosts)
        for (const auto& end : kEnds)
            block.nodes.push_back(
                node_of.at(std::minmax(mesh.cell(host)[end[0]], mesh.cell(host)[end[1]])));
    mesh.companions.push_back(std::move(block));
    Attribute field{"field", Place::point, make_array(Scalar::f32, 1, mesh.point_count()), {}, {}};
    for (Index p = 0; p < mesh.point_count(); ++p)
        field.values.as<float>()[p] =
            static_cast<float>(mesh.positions.as<double>()[3 * p] * 4 + 1);
    Attribute number_of{
        "number", Place::companion, make_array(Scalar::u32, 1, mesh.cell_count()), {}, {}};
    for (Index c = 0; c < mesh.cell_count(); ++c)
        number_of.values.as<std::uint32_t>()[c] = static_cast<std::uint32_t>(c);
    mesh.attributes = {std::move(field), std::move(number_of)};
    return mesh;
}

Mesh bare(Mesh mesh) {
    mesh.attributes.clear();
    return mesh;
}

// The corners alone.
Mesh linear(Mesh mesh) {
    Index corners = 0;
    for (const Index p : mesh.corners) corners = std::max(corners, p + 1);
    mesh.positions.bytes.resize(corners * mesh.positions.stride());
    mesh.companions.clear();
    mesh.attributes.clear();
    return mesh;
}

std::size_t size_of(const Mesh& mesh, const EncodeOptions& options = {}) {
    const auto packed = encode(mesh, options);
    REQUIRE(packed.ok());
    return packed->bytes.size();
}

void comes_back(const Mesh& mesh) {
    for (const bool keep_order : {false, true})
        for (const bool lossless : {false, true}) {
            EncodeOptions options;
            options.keep_order = keep_order;
            if (!lossless) options.position_bits = 12;
            const auto packed = encode(mesh, options);
            REQUIRE(packed.ok());
            const auto again = decode(packed->bytes);
            REQUIRE(again.ok());
            CHECK(compare_meshes(mesh, again->mesh, packed->order, packed->position_bound).equal);
            if (keep_order) {
                CHECK(again->mesh.companions[0].nodes == mesh.companions[0].nodes);
                CHECK(again->mesh.companions[0].hosts == mesh.companions[0].hosts);
                CHECK(again->mesh.corners == mesh.corners);
            }
            // What was decoded has the strip's order, and keeps it.
            const auto second = encode(again->mesh, options);
            REQUIRE(second.ok());
            const auto third = decode(second->bytes);
            REQUIRE(third.ok());
            CHECK(compare_meshes(again->mesh, third->mesh, second->order, second->position_bound)
                      .equal);
        }
}

}  // namespace

TEST_CASE("quadratic tets come back, whatever their order", "[codec]") {
    for (const char* recipe :
         {"tiny:tet", "tiny:two-tets", "tiny:tets-on-one-face", "tets:box=3x2x2,jitter=0.2,seed=5",
          "tets:ball=3,jitter=0.1,shuffle", "tets:shell=3,shuffle", "soup:tets=30,seed=4"})
        for (const double jitter : {0.0, 0.01}) {
            INFO(recipe << " " << jitter);
            comes_back(quadratic(made(recipe), 7, jitter));
        }
}

TEST_CASE("middles of edges cost next to nothing", "[codec]") {
    for (const char* recipe : {"tets:box=8,jitter=0.2,seed=5", "tets:ball=8,jitter=0.1"}) {
        const Mesh mesh = bare(quadratic(made(recipe), 3));
        const auto nodes = static_cast<double>(mesh.point_count());
        const double more =
            static_cast<double>(size_of(mesh)) - static_cast<double>(size_of(linear(mesh)));
        INFO(recipe << ": " << more << " bytes for " << nodes << " points");
        CHECK(more < 40 + nodes * 3 * 0.02 / 8);
        // On a grid only what rounding makes unsure.
        EncodeOptions grid;
        grid.position_bits = 14;
        CHECK(static_cast<double>(size_of(mesh, grid)) <
              static_cast<double>(size_of(linear(mesh), grid)) + 40 + nodes * 3 * 1.5 / 8);
    }
}

TEST_CASE("fields at quadratic nodes follow from the ends of their edges", "[codec]") {
    const Mesh with = quadratic(made("tets:box=8,jitter=0.2,seed=5"), 3);
    Mesh rough = with;
    make::Random random{1};
    for (float& x : rough.attributes[0].values.as<float>())
        x = static_cast<float>(random.below(1 << 22)) / 256;
    CHECK(2 * size_of(with) < size_of(rough) + size_of(bare(with)));
}

TEST_CASE("quadratic tets that lack a node, or share one, come back", "[codec]") {
    const Mesh mesh = quadratic(made("tets:box=2x2x1,jitter=0.2,seed=5"), 9);
    CompanionBlock& whole = const_cast<Mesh&>(mesh).companions[0];
    SECTION("a node that is a corner") {
        Mesh bad = mesh;
        bad.companions[0].nodes[8] = bad.corners[0];
        comes_back(bad);
    }
    SECTION("a node that two edges have") {
        Mesh bad = mesh;
        bad.companions[0].nodes[8] = bad.companions[0].nodes[9];
        comes_back(bad);
    }
    SECTION("two nodes of an edge changed with each other in one tet") {
        Mesh bad = mesh;
        std::swap(bad.companions[0].nodes[0], bad.companions[0].nodes[1]);
        comes_back(bad);
    }
    SECTION("a host twice") {
        Mesh bad = mesh;
        bad.companions[0].hosts[1] = bad.companions[0].hosts[0];
        comes_back(bad);
    }
    SECTION("a tet that is no host") {
        Mesh bad = bare(mesh);
        bad.companions[0].hosts.pop_back();
        bad.companions[0].nodes.resize(6 * --bad.companions[0].cell_count);
        comes_back(bad);
    }
    SECTION("the same block twice, and triangles on the nodes before it") {
        Mesh more = bare(mesh);
        CompanionBlock triangles{22, 6, 1, {}, {}};
        triangles.nodes.assign(whole.nodes.begin(), whole.nodes.begin() + 6);
        more.companions = {whole, whole, triangles};
        comes_back(more);
    }
    SECTION("points that nothing has") {
        Mesh more = bare(mesh);
        more.positions.bytes.resize(more.positions.bytes.size() + 5 * more.positions.stride());
        comes_back(more);
    }
}
