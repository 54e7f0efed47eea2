#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "mesh/complex.h"
#include "strip/build.h"
#include "strip/dual.h"
#include "strip/links.h"
#include "strip/materialise.h"
#include "support/small_meshes.h"

using namespace ravel;

namespace {

// Signed area above the xy plane of a polygon, or signed volume of a tet.
double measure(const Mesh& mesh, Index cell) {
    const auto p = mesh.positions.as<double>();
    const auto q = mesh.cell(cell);
    if (mesh.kind == CellKind::polygon) {
        double area = 0;
        for (std::size_t i = 0; i < q.size(); ++i) {
            const Index a = q[i], b = q[(i + 1) % q.size()];
            area += (p[3 * a] * p[3 * b + 1] - p[3 * a + 1] * p[3 * b]) / 2;
        }
        return area;
    }
    std::array<std::array<double, 3>, 3> e{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) e[i][k] = p[3 * q[i + 1] + k] - p[3 * q[0] + k];
    return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
            e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
            e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
           6;
}

bool is_convex(const Mesh& mesh, Index cell) {
    const auto p = mesh.positions.as<double>();
    const auto q = mesh.cell(cell);
    for (std::size_t i = 0; i < q.size(); ++i) {
        const Index a = q[i], b = q[(i + 1) % q.size()], c = q[(i + 2) % q.size()];
        const double turn = (p[3 * b] - p[3 * a]) * (p[3 * c + 1] - p[3 * b + 1]) -
                            (p[3 * b + 1] - p[3 * a + 1]) * (p[3 * c] - p[3 * b]);
        if (turn < -1e-9) return false;
    }
    return true;
}

// A worst case for links: no strip but singletons, so that every cell is linked, most of them
// often.
Strip singletons_only(const Complex& complex) {
    const Dual dual = make_dual(complex);
    EdgeSet none(dual.graph.edge_count(), 0);
    StripJoiner joiner(dual.graph, none);
    return link_strips(complex, dual, joiner);
}

std::vector<Strip> strips_of(const Complex& complex) {
    return {build_strip(complex), build_strip(complex, FactorMethod::euler),
            build_strip(complex, FactorMethod::two_pass, {0}),
            build_strip(complex, FactorMethod::template_substitution, {0, Reading::unmatched}),
            singletons_only(complex)};
}

}  // namespace

TEST_CASE("a materialised strip visits every cell of the subdivided mesh once") {
    for (const auto& [name, mesh, clean] : test::small_meshes()) {
        INFO(name);
        const Complex complex = *build_complex(mesh);
        for (const Strip& strip : strips_of(complex)) {
            const Result<Materialised> made = materialise(mesh, complex, strip);
            REQUIRE(made.ok());
            const Status status = check_materialised(mesh, *made);
            INFO((status.ok() ? "" : status.error().detail));
            CHECK(status.ok());
            Index open = 0;
            for (std::size_t k = 0; k < made->closed.size(); ++k)
                open += made->closed[k] == 0 && made->first[k + 1] - made->first[k] > 1;
            CHECK(open == strip.counts.open_strips);
        }
    }
}

TEST_CASE("a materialised clean mesh is clean and has as many components") {
    for (const auto& [name, mesh, clean] : test::small_meshes()) {
        if (!clean) continue;
        INFO(name);
        const Complex complex = *build_complex(mesh);
        for (const Strip& strip : strips_of(complex)) {
            const Materialised made = *materialise(mesh, complex, strip);
            const Complex fine = *build_complex(made.mesh);
            CHECK(build_strip(fine).counts.components == strip.counts.components);
            CHECK(std::set<Id>(fine.point.begin(), fine.point.end()).size() == fine.point.size());
            for (const auto flipped : fine.flipped) CHECK(flipped == 0);
        }
    }
}

TEST_CASE("splitting keeps areas and volumes, and no piece is turned over") {
    for (const Mesh& mesh : {test::quad_grid(6, 5), test::honeycomb(5, 5), test::triangle_fan(7),
                             test::tet_box(3, 2, 2)}) {
        const Complex complex = *build_complex(mesh);
        for (const Strip& strip : strips_of(complex)) {
            const Materialised made = *materialise(mesh, complex, strip);
            std::vector<double> whole(mesh.cell_count(), 0);
            for (Index c = 0; c < made.mesh.cell_count(); ++c) {
                CHECK(measure(made.mesh, c) > 0);
                if (mesh.kind == CellKind::polygon) CHECK(is_convex(made.mesh, c));
                whole[made.parent[c]] += measure(made.mesh, c);
            }
            for (Index c = 0; c < mesh.cell_count(); ++c)
                CHECK(whole[c] == Approx(measure(mesh, c)).epsilon(1e-9));
        }
    }
}

TEST_CASE("a link adds two cells to each tet and n - 1 to each n-gon") {
    const Mesh box = test::tet_box(3, 3, 2);
    const Complex tets = *build_complex(box);
    for (const Strip& strip : strips_of(tets)) {
        const Materialised made = *materialise(box, tets, strip);
        CHECK(made.added_cells == 4 * strip.counts.links);
        CHECK(made.added_points == strip.counts.links);
    }
    const Mesh grid = test::quad_grid(6, 6);
    const Complex quads = *build_complex(grid);
    for (const Strip& strip : strips_of(quads)) {
        const Materialised made = *materialise(grid, quads, strip);
        CHECK(made.added_cells == 6 * strip.counts.links);
        CHECK(made.added_points == 6 * strip.counts.links);
    }
}

TEST_CASE("cell attributes follow their cells into the pieces and point attributes are blended") {
    Mesh mesh = test::quad_grid(4, 4);
    Attribute region{"region", Place::cell, make_array(Scalar::i32, 1, mesh.cell_count()), {}, {}};
    for (Index c = 0; c < mesh.cell_count(); ++c)
        region.values.as<std::int32_t>()[c] = static_cast<std::int32_t>(100 + c);
    Attribute height{"x", Place::point, make_array(Scalar::f64, 1, mesh.point_count()), {}, {}};
    for (Index p = 0; p < mesh.point_count(); ++p)
        height.values.as<double>()[p] = mesh.positions.as<double>()[3 * p];
    mesh.attributes = {region, height};
    const Complex complex = *build_complex(mesh);
    const Materialised made = *materialise(mesh, complex, singletons_only(complex));
    REQUIRE(check_mesh(made.mesh).ok());
    for (Index c = 0; c < made.mesh.cell_count(); ++c)
        CHECK(made.mesh.attributes[0].values.as<std::int32_t>()[c] ==
              static_cast<std::int32_t>(100 + made.parent[c]));
    for (Index p = 0; p < made.mesh.point_count(); ++p)
        CHECK(made.mesh.attributes[1].values.as<double>()[p] ==
              Approx(made.mesh.positions.as<double>()[3 * p]));
}
