// A certificate of what Complex promises, on clean meshes and on soups.
#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <string>

#include "make/make_mesh.h"
#include "mesh/complex.h"
#include "support/small_meshes.h"

using namespace ravel;

namespace {

// The points of a facet in the complex's own orientation, starting with the smallest.
std::vector<Id> facet_points(const Complex& c, Id facet) {
    static constexpr int kOutside[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    std::vector<Id> points;
    if (c.kind == CellKind::tet) {
        for (const int i : kOutside[facet & 3])
            points.push_back(c.point[c.vertex[(facet & ~Id{3}) + static_cast<Id>(i)]]);
    } else {
        points = {c.point[c.vertex[facet]], c.point[c.vertex[c.next_in_cell(facet)]]};
    }
    return points;
}

std::vector<Id> from_smallest(std::vector<Id> cycle) {
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    return cycle;
}

std::vector<Id> backwards(std::vector<Id> cycle) {
    std::reverse(cycle.begin(), cycle.end());
    return cycle;
}

// Corners of equal vertex that hang together by facets.
std::vector<Id> groups_of(const Complex& c) {
    std::vector<Id> group(c.vertex.size());
    for (Id i = 0; i < group.size(); ++i) group[i] = i;
    const auto root = [&](Id i) {
        while (group[i] != i) i = group[i];
        return i;
    };
    for (Id f = 0; f < c.twin.size(); ++f) {
        const Id g = c.twin[f];
        if (g == kNone) continue;
        const Id a = c.cell_of[f], b = c.cell_of[g];
        for (Id i = c.first[a]; i < c.first[a + 1]; ++i)
            for (Id j = c.first[b]; j < c.first[b + 1]; ++j) {
                const auto on = [&](Id corner, Id facet) {
                    return c.kind == CellKind::tet
                               ? corner != facet
                               : corner == facet || corner == c.next_in_cell(facet);
                };
                if (c.vertex[i] == c.vertex[j] && on(i, f) && on(j, g))
                    group[std::max(root(i), root(j))] = std::min(root(i), root(j));
            }
    }
    for (Id i = 0; i < group.size(); ++i) group[i] = root(i);
    return group;
}

// Empty, or the first promise that is broken.
std::string broken_promise(const Mesh& mesh, const Complex& c) {
    if (c.cell_count() != mesh.cell_count() || c.twin.size() != mesh.corners.size()) return "sizes";
    for (Id f = 0; f < c.twin.size(); ++f) {
        const Id g = c.twin[f];
        if (g == kNone) continue;
        if (g >= c.twin.size() || c.twin[g] != f) return "twins are not symmetric";
        if (c.cell_of[f] == c.cell_of[g]) return "a cell is glued to itself";
        const auto there = facet_points(c, f), back = facet_points(c, g);
        if (from_smallest(there) != from_smallest(backwards(back)))
            return "glued facets do not run opposite";
    }
    for (Id cell = 0; cell < c.cell_count(); ++cell) {
        std::set<Id> met;
        for (Id i = c.first[cell]; i < c.first[cell + 1]; ++i)
            if (!met.insert(c.vertex[i]).second) return "a cell meets a vertex twice";
        // Flips undone, these are the mesh's own cells.
        std::vector<Id> points;
        for (Id i = c.first[cell]; i < c.first[cell + 1]; ++i)
            points.push_back(c.point[c.vertex[i]]);
        if (c.flipped[cell] != 0 && !points.empty()) {
            if (c.kind == CellKind::tet)
                std::swap(points[2], points[3]);
            else
                std::reverse(points.begin() + 1, points.end());
        }
        if (!std::equal(points.begin(), points.end(), mesh.cell(cell).begin(),
                        mesh.cell(cell).end()))
            return "a cell is not the mesh's";
    }
    const std::vector<Id> group = groups_of(c);
    std::vector<Id> group_of(c.point.size(), kNone);
    for (Id i = 0; i < group.size(); ++i) {
        Id& known = group_of[c.vertex[i]];
        if (known == kNone) known = group[i];
        if (known != group[i]) return "the corners of a vertex do not hang together";
    }
    if (std::find(group_of.begin(), group_of.end(), kNone) != group_of.end())
        return "a vertex without corners";
    return {};
}

std::string verdict(const Mesh& mesh) {
    const Result<Complex> complex = build_complex(mesh);
    return complex ? broken_promise(mesh, *complex) : complex.error().detail;
}

Mesh made(const std::string& recipe) {
    Result<Mesh> mesh = make::make_mesh(recipe);
    REQUIRE(mesh.ok());
    return std::move(*mesh);
}

}  // namespace

TEST_CASE("every small mesh becomes what a complex promises to be") {
    for (const auto& [name, mesh, clean] : test::small_meshes()) {
        INFO(name);
        CHECK(verdict(mesh) == "");
    }
}

TEST_CASE("clean meshes are neither cut nor flipped") {
    for (const auto& [name, mesh, clean] : test::small_meshes()) {
        if (!clean) continue;
        INFO(name);
        const Result<Complex> c = build_complex(mesh);
        REQUIRE(c.ok());
        CHECK(std::count(c->flipped.begin(), c->flipped.end(), 1) == 0);
        CHECK(std::set<Id>(c->point.begin(), c->point.end()).size() == c->point.size());
    }
}

TEST_CASE("soups of polygons become what a complex promises to be") {
    for (int seed = 1; seed <= 200; ++seed) {
        INFO(seed);
        CHECK(verdict(made("soup:polygons=" + std::to_string(3 + seed % 70) +
                           ",seed=" + std::to_string(seed))) == "");
        CHECK(verdict(test::random_soup(CellKind::polygon, 4 + static_cast<Index>(seed) % 9,
                                        static_cast<Index>(seed) % 60,
                                        static_cast<std::uint32_t>(seed))) == "");
    }
}

TEST_CASE("soups of tets become what a complex promises to be") {
    for (int seed = 1; seed <= 200; ++seed) {
        INFO(seed);
        CHECK(verdict(made("soup:tets=" + std::to_string(3 + seed % 70) +
                           ",seed=" + std::to_string(seed))) == "");
        CHECK(verdict(test::random_soup(CellKind::tet, 4 + static_cast<Index>(seed) % 9,
                                        static_cast<Index>(seed) % 60,
                                        static_cast<std::uint32_t>(seed))) == "");
    }
}

TEST_CASE("a consistently turned mesh is not flipped, a single turned cell is") {
    Mesh mesh = test::quad_grid(4, 4);
    std::reverse(mesh.corners.begin() + 4 * 5, mesh.corners.begin() + 4 * 6);
    const Result<Complex> c = build_complex(mesh);
    REQUIRE(c.ok());
    CHECK(std::count(c->flipped.begin(), c->flipped.end(), 1) == 1);
    CHECK(c->flipped[5] == 1);
    CHECK(c->point.size() == mesh.point_count());
}
