#include <catch2/catch.hpp>

#include <set>

#include "mesh/complex.h"
#include "mesh/exit_rule.h"
#include "strip/build.h"
#include "strip/check.h"
#include "support/small_meshes.h"

using namespace ravel;

namespace {

Complex complex_of(const Mesh& mesh) {
    Result<Complex> complex = build_complex(mesh);
    REQUIRE(complex.ok());
    return *complex;
}

}  // namespace

TEST_CASE("every mesh gets exactly one strip per component, by either method") {
    for (const auto& [name, mesh, clean] : test::small_meshes()) {
        INFO(name);
        const Complex complex = complex_of(mesh);
        for (const FactorMethod method : {FactorMethod::steered, FactorMethod::euler}) {
            const Strip strip = build_strip(complex, method);
            const Status status = check_strip(complex, strip);
            INFO((status.ok() ? "" : status.error().detail));
            CHECK(status.ok());
            CHECK(strip.counts.strips == strip.counts.components);
            CHECK(strip.roots.size() == strip.counts.components);
        }
    }
}

TEST_CASE("the same complex gives the same strip") {
    for (const auto& [name, mesh, clean] : test::small_meshes()) {
        INFO(name);
        const Complex complex = complex_of(mesh);
        const Strip a = build_strip(complex), b = build_strip(complex);
        CHECK(a.role == b.role);
        CHECK(a.roots == b.roots);
    }
}

TEST_CASE("closed quad surfaces and grids need no link") {
    for (const Mesh& mesh : {test::quad_torus(12, 9), test::quad_grid(10, 10),
                             test::quad_grid(9, 9), test::quad_grid(1, 1)})
        CHECK(build_strip(complex_of(mesh)).counts.links == 0);
}

TEST_CASE("two cells that share one facet are an open strip") {
    const Strip strip = build_strip(complex_of(test::quad_grid(2, 1)));
    CHECK(strip.counts.open_strips == 1);
    CHECK(strip.counts.links == 0);
}

TEST_CASE("a strip with a broken role, link or root is not one") {
    const Complex complex = complex_of(test::tet_box(3, 3, 3));
    const Strip strip = build_strip(complex);
    for (Id f = 0; f < strip.role.size(); ++f) {
        if (complex.twin[f] == kNone) continue;
        for (const FacetRole role : {FacetRole::none, FacetRole::strip, FacetRole::link}) {
            if (role == strip.role[f]) continue;
            Strip broken = strip;
            broken.role[f] = role;
            CHECK_FALSE(check_strip(complex, broken).ok());
            // Of both twins at once only strip -> none, on a closed strip, gives a strip again: an
            // open one.
            broken.role[complex.twin[f]] = role;
            if (role != FacetRole::none || strip.role[f] == FacetRole::link)
                CHECK_FALSE(check_strip(complex, broken).ok());
        }
    }
    Strip broken = strip;
    broken.roots.clear();
    CHECK_FALSE(check_strip(complex, broken).ok());
    broken.roots = {complex.cell_count()};
    CHECK_FALSE(check_strip(complex, broken).ok());
}

TEST_CASE("the exit order lists every facet of the cell but the entry once, leftmost first") {
    std::vector<Id> order;
    for (const auto& [name, mesh, clean] : test::small_meshes()) {
        INFO(name);
        const Complex complex = complex_of(mesh);
        for (Id entry = 0; entry < complex.twin.size(); ++entry) {
            exit_order(complex, entry, order);
            CHECK(order.size() + 1 == complex.degree(complex.cell_of[entry]));
            CHECK(std::set<Id>(order.begin(), order.end()).size() == order.size());
            for (const Id f : order)
                CHECK((f != entry && complex.cell_of[f] == complex.cell_of[entry]));
            if (complex.kind == CellKind::polygon && !order.empty())
                CHECK(order.front() == complex.prev_in_cell(entry));
        }
    }
}

TEST_CASE("large meshes full of holes get one strip per component, too") {
    for (const Mesh& mesh :
         {test::with_holes(test::quad_grid(120, 120), 3, 1),
          test::with_holes(test::tet_box(12, 12, 12), 20, 2),
          test::with_holes(test::honeycomb(60, 60), 30, 3), test::triangle_fan(5000)}) {
        const Complex complex = complex_of(mesh);
        for (const StripOptions options : {StripOptions{0}, StripOptions{3}, StripOptions{}})
            CHECK(check_strip(complex, build_strip(complex, FactorMethod::steered, options)).ok());
    }
}
