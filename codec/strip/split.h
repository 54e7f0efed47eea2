// The evolving mesh in which links become real splits. Used by `materialise` only.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "mesh/complex.h"
#include "strip/strip.h"

namespace ravel {

// Cells are only added; a cell that was split is dead and its outer facets have moved to its
// pieces.
struct SplitMesh {
    CellKind kind = CellKind::polygon;
    std::vector<Id> first;        // cells + 1
    std::vector<Id> cell_of;      // facet -> cell
    std::vector<Id> twin;         // facet -> facet or kNone
    std::vector<Id> vertex;       // corner -> vertex; those of the complex come first
    std::vector<FacetRole> role;  // per facet
    std::vector<Id> origin;       // facet -> facet of the complex it lies on, or kNone
    std::vector<Id> parent;       // cell -> cell of the complex
    std::vector<Id> now;          // facet of the complex -> the live facet on it
    std::vector<Id> piece;        // cell of the complex -> a live piece of it

    // New vertex i is the blend of vertex blend[j] with weight[j], j in [blend_first[i],
    // blend_first[i + 1]).
    std::vector<Id> blend_first{0};
    std::vector<Id> blend;
    std::vector<double> weight;
    Id old_vertices = 0;

    Id degree(Id cell) const { return first[cell + 1] - first[cell]; }
    Id size() const { return static_cast<Id>(first.size() - 1); }
};

struct Blend {
    Id vertex;
    double weight;
};

Id add_vertex(SplitMesh& mesh, std::span<const Blend> parts);
Id add_cell(SplitMesh& mesh, std::span<const Id> vertices, Id parent);
void glue(SplitMesh& mesh, Id facet, Id twin);

// `fresh` takes the place of `old`: its neighbour, role and origin.
void take_over(SplitMesh& mesh, Id old, Id fresh);

// Gives a glued facet and its twin a role.
void set_role(SplitMesh& mesh, Id facet, FacetRole role);

// Splits the two cells at a link facet and joins their strips there, as the paper does
// [DiazGopi2005, 3.2 and 3.3]. False where a cell has no room for it (polygons of one corner).
bool split_polygons(SplitMesh& mesh, Id link);
bool split_tets(SplitMesh& mesh, Id link);

}  // namespace ravel
