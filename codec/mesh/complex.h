// The mesh as strip and walker see it: cells glued facet to facet, everything else cut.
// A facet is glued to at most one other, glued facets run in opposite directions, no cell is glued
// to itself or meets the same vertex twice, and the cells around a vertex hang together by facets.
// What of the mesh breaks that (non-manifold facets and vertices, Moebius seams, repeated corners)
// is cut: facets become borders, points become several vertices, cells are flipped; `point` and
// `flipped` undo it.
#pragma once

#include <cstdint>
#include <vector>

#include "ravel/mesh.h"

namespace ravel {

using Id = std::uint32_t;  // cells, facets and vertices of one block
inline constexpr Id kNone = ~Id{0};

// Corners and facets share their numbers: cell c owns [first[c], first[c + 1]).
// Polygon: facet i is the side from corner i to the next corner of its cell (counter-clockwise).
// Tet: facet i lies opposite corner i.
struct Complex {
    CellKind kind = CellKind::polygon;
    std::vector<Id> first;    // cells + 1
    std::vector<Id> cell_of;  // facet -> cell
    std::vector<Id> twin;     // facet -> the facet glued to it, or kNone at a border
    std::vector<Id> vertex;   // corner -> vertex
    std::vector<Id> point;    // vertex -> point of the mesh
    std::vector<std::uint8_t>
        flipped;  // cell -> 1 where its orientation is the reverse of the mesh's

    Id cell_count() const { return first.empty() ? 0 : static_cast<Id>(first.size() - 1); }
    Id degree(Id cell) const { return first[cell + 1] - first[cell]; }
    Id next_in_cell(Id facet) const {
        const Id cell = cell_of[facet];
        return facet + 1 == first[cell + 1] ? first[cell] : facet + 1;
    }
    Id prev_in_cell(Id facet) const {
        const Id cell = cell_of[facet];
        return facet == first[cell] ? first[cell + 1] - 1 : facet - 1;
    }
};

// A flipped polygon keeps its first corner and lists the others backwards; a flipped tet swaps its
// last two corners. Within a component the orientation that flips fewer cells is taken.
// Near-linear. Fails with limit_exceeded where points and corners together reach 2^32 - 2, or tets
// 357913941: more than a block counts in 32 bits.
Result<Complex> build_complex(const Mesh& mesh);

}  // namespace ravel
