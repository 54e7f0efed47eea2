// Gmsh's element types and the VTK cell types they are.
#pragma once

#include <cstdint>
#include <span>

namespace ravel::io {

struct GmshType {
    std::int32_t gmsh;
    std::uint16_t vtk;
    std::uint8_t nodes;
    std::int8_t dimension;
    // Node i of the VTK cell is node order[i] of the Gmsh element; empty where they agree.
    std::span<const std::uint8_t> order;
};

// Present where a mesh has Lagrange cells of VTK types 70 to 74 whose nodes are in Gmsh's order,
// which is not VTK's: then only a Gmsh file can hold them.
inline constexpr const char* kGmshNodeOrder = "gmsh:node_order";

// nullptr for types that are not supported.
const GmshType* find_gmsh_type(std::int64_t gmsh);
const GmshType* gmsh_type_of(std::uint16_t vtk, std::size_t nodes);

}  // namespace ravel::io
