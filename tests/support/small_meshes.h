// Small meshes with known oddities, made in memory.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "ravel/mesh.h"

namespace ravel::test {

struct NamedMesh {
    std::string name;
    Mesh mesh;
    bool clean = true;  // oriented manifold, perhaps with border; cells are convex
};

using Point = std::array<double, 3>;

Mesh polygon_mesh(const std::vector<Point>& points, const std::vector<std::vector<Index>>& cells);
Mesh tet_mesh(const std::vector<Point>& points, const std::vector<std::array<Index, 4>>& cells);

Mesh quad_grid(Index columns, Index rows);
Mesh quad_torus(Index columns, Index rows);
Mesh moebius_band(Index length);
Mesh triangle_fan(Index triangles);
Mesh honeycomb(Index columns, Index rows);
Mesh tet_box(Index nx, Index ny, Index nz);  // six Kuhn tets per cube

// Polygons or tets over random points: duplicates, non-manifold facets, repeated corners, n-gons of
// one to seven corners. The same on every machine.
Mesh random_soup(CellKind kind, Index points, Index cells, std::uint32_t seed);

// A clean mesh with random cells taken out: borders, pinched vertices, several components.
Mesh with_holes(const Mesh& mesh, std::uint32_t percent, std::uint32_t seed);

// All of the above in small sizes, and single cells, platonic and archimedean solids, pinched
// vertices, non-manifold edges, two cells that share several facets.
std::vector<NamedMesh> small_meshes();

}  // namespace ravel::test
