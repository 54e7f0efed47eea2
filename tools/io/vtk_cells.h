// VTK's cell types: how many nodes each has. The numbers are those of Mesh's companions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace ravel::io {

inline constexpr std::uint16_t kVtkVertex = 1, kVtkPolyVertex = 2, kVtkLine = 3, kVtkPolyLine = 4,
                               kVtkTriangle = 5, kVtkStrip = 6, kVtkPolygon = 7, kVtkPixel = 8,
                               kVtkQuad = 9, kVtkTet = 10, kVtkQuadraticTet = 24,
                               kVtkPolyhedron = 42;

// Why a cell of this type with this many nodes can't be held; nothing where it can.
std::optional<std::string> cell_fault(std::uint64_t type, std::uint64_t node_count);

// Are the nodes of Lagrange cells of this type ordered alike in VTK and Gmsh files?
bool same_order_in_gmsh(std::uint16_t type);

}  // namespace ravel::io
