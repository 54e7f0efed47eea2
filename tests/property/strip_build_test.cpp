#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <set>

#include "graph/matching.h"
#include "graph/template_factor.h"
#include "graph/two_pass.h"
#include "mesh/complex.h"
#include "mesh/exit_rule.h"
#include "strip/build.h"
#include "strip/check.h"
#include "strip/dual.h"
#include "support/small_meshes.h"

using namespace ravel;

namespace {

Complex complex_of(const Mesh& mesh) {
    Result<Complex> complex = build_complex(mesh);
    REQUIRE(complex.ok());
    return *complex;
}

constexpr std::array kMethods{FactorMethod::steered, FactorMethod::euler, FactorMethod::two_pass,
                              FactorMethod::template_substitution};

bool has_two_factor(const StripCounts& counts) {
    return counts.paths + counts.singletons == 0;
}

// Weights that have nothing to do with the mesh, equal on twins.
std::vector<std::uint32_t> arbitrary_weights(const Complex& complex) {
    std::vector<std::uint32_t> weights(complex.twin.size());
    for (Id f = 0; f < weights.size(); ++f) {
        const Id least = complex.twin[f] == kNone ? f : std::min(f, complex.twin[f]);
        weights[f] = least * 2654435761u >> 28;
    }
    return weights;
}

}  // namespace

TEST_CASE("every mesh gets exactly one strip per component, by each method") {
    for (const auto& [name, mesh, clean] : test::small_meshes()) {
        INFO(name);
        const Complex complex = complex_of(mesh);
        for (const FactorMethod method : kMethods) {
            for (const Reading reading : {Reading::matched, Reading::unmatched}) {
                const Strip strip = build_strip(complex, method, {6, reading});
                const Status status = check_strip(complex, strip);
                INFO((status.ok() ? "" : status.error().detail));
                CHECK(status.ok());
                CHECK(strip.counts.strips == strip.counts.components);
                CHECK(strip.roots.size() == strip.counts.components);
            }
        }
    }
}

TEST_CASE("the strips are a 2-factor wherever the matching proves that there is one") {
    for (const auto& [name, mesh, clean] : test::small_meshes()) {
        INFO(name);
        const Complex complex = complex_of(mesh);
        const Graph graph = make_dual(complex).graph;
        const Graph inflated = inflate(graph);
        const Matching matching = inflated_matching(graph, inflated);
        REQUIRE(proves_maximum(inflated, matching));
        const bool exists = template_factor(graph, matching).two_factor;
        const auto found = [&](FactorMethod method) {
            return has_two_factor(build_strip(complex, method).counts);
        };
        CHECK(found(FactorMethod::template_substitution) == exists);
        CHECK(found(FactorMethod::two_pass) == two_pass(graph).two_factor());
        CHECK(found(FactorMethod::steered) == exists);
        CHECK(found(FactorMethod::euler) == exists);
    }
}

TEST_CASE("a mesh with an odd number of quads gets a 2-factor, but not by two-pass") {
    for (const Mesh& mesh : {test::quad_torus(3, 3), test::quad_torus(9, 7)}) {
        const Complex complex = complex_of(mesh);
        CHECK_FALSE(has_two_factor(build_strip(complex, FactorMethod::two_pass).counts));
        for (const FactorMethod method :
             {FactorMethod::steered, FactorMethod::euler, FactorMethod::template_substitution})
            CHECK(has_two_factor(build_strip(complex, method).counts));
        for (const FactorMethod method : kMethods) {
            const Strip strip = build_strip(complex, method);
            CHECK(check_strip(complex, strip).ok());
            CHECK(strip.counts.links == 0);
            CHECK(strip.counts.open_strips == 0);
        }
    }
}

TEST_CASE("whatever the weights, the strip is one, and equal weights change nothing") {
    for (const auto& [name, mesh, clean] : test::small_meshes()) {
        INFO(name);
        const Complex complex = complex_of(mesh);
        const std::vector<std::uint32_t> some = arbitrary_weights(complex);
        StripOptions options;
        options.weights = some;
        CHECK(check_strip(complex, build_strip(complex, FactorMethod::steered, options)).ok());
        const std::vector<std::uint32_t> equal(complex.twin.size(), 7);
        options.weights = equal;
        CHECK(build_strip(complex, FactorMethod::steered, options).role ==
              build_strip(complex).role);
    }
}

TEST_CASE("steps across light facets alone make straight strips") {
    // Sides 0 and 2 of every quad lead along the columns of the torus.
    const Complex complex = complex_of(test::quad_torus(12, 10));
    std::vector<std::uint32_t> weights(complex.twin.size());
    for (Id f = 0; f < weights.size(); ++f) weights[f] = f % 2;
    StripOptions options;
    options.weights = weights;
    const Strip strip = build_strip(complex, FactorMethod::steered, options);
    Id light = 0, heavy = 0;
    for (Id f = 0; f < weights.size(); ++f)
        if (strip.role[f] == FacetRole::strip) ++(weights[f] == 0 ? light : heavy);
    CHECK(light > 4 * heavy);
}

TEST_CASE("the same complex gives the same strip") {
    for (const auto& [name, mesh, clean] : test::small_meshes()) {
        INFO(name);
        const Complex complex = complex_of(mesh);
        for (const FactorMethod method : kMethods) {
            const Strip a = build_strip(complex, method), b = build_strip(complex, method);
            CHECK(a.role == b.role);
            CHECK(a.roots == b.roots);
        }
    }
}

TEST_CASE("closed quad surfaces and grids need no link") {
    for (const Mesh& mesh : {test::quad_torus(12, 9), test::quad_grid(10, 10),
                             test::quad_grid(9, 9), test::quad_grid(1, 1)})
        CHECK(build_strip(complex_of(mesh)).counts.links == 0);
}

TEST_CASE("a regular torus needs no link by any method") {
    const Complex complex = complex_of(test::quad_torus(120, 90));
    for (const FactorMethod method : kMethods) {
        const Strip strip = build_strip(complex, method);
        CHECK(strip.counts.links == 0);
        CHECK(strip.counts.open_strips == 0);
    }
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
