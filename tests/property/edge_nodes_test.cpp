#include <catch2/catch.hpp>

#include <algorithm>

#include "make/make_mesh.h"
#include "ravel/ravel.h"

namespace {

using ravel::Index;
using ravel::Mesh;

constexpr std::size_t kEnds[6][2] = {{0, 1}, {1, 2}, {2, 0},
                                     {0, 3}, {1, 3}, {2, 3}};  // VTK's order

std::array<double, 3> point_of(const Mesh& mesh, Index p) {
    std::array<double, 3> x{};
    for (std::size_t k = 0; k < 3; ++k)
        x[k] = mesh.positions.scalar == ravel::Scalar::f32
                   ? static_cast<double>(mesh.positions.as<float>()[3 * p + k])
                   : mesh.positions.as<double>()[3 * p + k];
    return x;
}

// Quadratic tets: an own point in the middle of every edge of every tet.
Mesh with_edge_nodes(Mesh mesh) {
    ravel::CompanionBlock block{24, 6, mesh.cell_count(), {}, {}};
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        block.hosts.push_back(c);
        for (const auto& ends : kEnds) {
            const auto a = point_of(mesh, mesh.cell(c)[ends[0]]),
                       b = point_of(mesh, mesh.cell(c)[ends[1]]);
            block.nodes.push_back(mesh.point_count());
            mesh.positions.bytes.resize(mesh.positions.bytes.size() + mesh.positions.stride());
            for (std::size_t k = 0; k < 3; ++k)
                mesh.positions.as<double>()[3 * (mesh.point_count() - 1) + k] = (a[k] + b[k]) / 2;
        }
    }
    mesh.companions.push_back(block);
    return mesh;
}

double farthest_from_middle(const Mesh& mesh) {
    double farthest = 0;
    const ravel::CompanionBlock& block = mesh.companions.at(0);
    for (std::size_t i = 0; i < block.hosts.size(); ++i)
        for (std::size_t e = 0; e < 6; ++e) {
            const auto cell = mesh.cell(block.hosts[i]);
            const auto a = point_of(mesh, cell[kEnds[e][0]]), b = point_of(mesh, cell[kEnds[e][1]]);
            const auto x = point_of(mesh, block.nodes[6 * i + e]);
            for (std::size_t k = 0; k < 3; ++k)
                farthest = std::max(farthest, std::abs(x[k] - (a[k] + b[k]) / 2));
        }
    return farthest;
}

}  // namespace

TEST_CASE("edge nodes of quadratic tets stay on their edges when tets are turned", "[codec]") {
    auto made = ravel::make::make_mesh("tets:box=4x3x2,jitter=0.2,seed=5,double");
    REQUIRE(made);
    const Mesh mesh = with_edge_nodes(*made);
    REQUIRE(farthest_from_middle(mesh) == 0);
    for (const bool keep_order : {false, true}) {
        ravel::EncodeOptions options;
        options.keep_order = keep_order;
        const auto packed = ravel::encode(mesh, options);
        REQUIRE(packed);
        const auto again = ravel::decode(packed->bytes);
        REQUIRE(again);
        CHECK(farthest_from_middle(again->mesh) == 0);
        CHECK(ravel::compare_meshes(mesh, again->mesh, packed->order, 0).equal);
        // The comparison sees a node on the wrong edge.
        Mesh tampered = again->mesh;
        std::swap(tampered.companions[0].nodes[0], tampered.companions[0].nodes[1]);
        CHECK_FALSE(ravel::compare_meshes(mesh, tampered, packed->order, 0).equal);
    }
}
