// The order a walk gives to points and cells, seen from both sides, and what it does to corners.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ravel/mesh.h"

namespace ravel {

// New is the strip's order, old the order of the mesh that was encoded.
struct Reorder {
    std::vector<Index> old_point;  // new point -> old point
    std::vector<Index> old_cell;   // new cell -> old cell
    std::vector<std::uint32_t>
        turn;  // new cell -> polygons: the old corner it starts with; tets: its
               // permutation, the number of (old corner of new corner 0, 1, 2, 3)
    std::vector<Index> old_companion;  // new companion -> old one, of the same block
    std::vector<std::uint32_t>
        companion_turn;  // new companion -> the old node it starts with; the others follow
    // Per attribute, of pools that elements have an index into: new tuple -> old tuple.
    std::vector<std::vector<Index>> old_tuple;
};

// Permutations of 0 1 2 3 in lexicographic order.
std::array<std::uint8_t, 4> tet_turn(std::uint32_t number);
std::uint32_t number_of_tet_turn(const std::array<std::uint8_t, 4>& permutation);

// Old corner (within its cell of `degree` corners) that is new corner `i`.
inline std::uint32_t old_corner(CellKind kind, std::uint32_t turn, std::uint32_t degree,
                                std::uint32_t i) {
    if (kind == CellKind::tet) return tet_turn(turn)[i];
    const std::uint64_t j = std::uint64_t{turn} + i;
    return static_cast<std::uint32_t>(j < degree ? j : j - degree);
}

// from[new] = old turned round; `count` is the size of the old side.
std::vector<Index> inverse_of(const std::vector<Index>& from, Index count);

// Renumbers the elements that `attribute` refers to: number n of a point becomes point[n], of a
// cell cell[n]; what names no element stays.
void renumber(Attribute& attribute, const std::vector<Index>& point,
              const std::vector<Index>& cell);

// The corners at the ends of a tet's edges, in VTK's order.
inline constexpr std::uint8_t kTetEdges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};

// Puts the nodes of a block of quadratic tets' edge nodes (VTK order) where a turn of their tet has
// them: `turn_of(host)` is the number of the permutation. Back again with `back`. Other blocks
// stay.
template <class TurnOf>
void turn_edge_nodes(CompanionBlock& block, bool back, TurnOf turn_of) {
    constexpr std::uint8_t kEdge[4][4] = {{0, 0, 2, 3}, {0, 0, 1, 4}, {2, 1, 0, 5}, {3, 4, 5, 0}};
    if (block.vtk_type != 24 || block.nodes_per_cell != 6) return;
    for (std::size_t i = 0; i < block.hosts.size(); ++i) {
        const std::array<std::uint8_t, 4> t = tet_turn(turn_of(block.hosts[i]));
        Index* const six = block.nodes.data() + 6 * i;
        Index given[6];
        for (std::size_t k = 0; k < 6; ++k) given[k] = six[k];
        for (std::size_t k = 0; k < 6; ++k) {
            const std::size_t old = kEdge[t[kTetEdges[k][0]]][t[kTetEdges[k][1]]];
            six[back ? old : k] = given[back ? k : old];
        }
    }
}

// Tuple i of the result is tuple from[i] of `array`.
Array gather(const Array& array, const std::vector<Index>& from);

}  // namespace ravel
