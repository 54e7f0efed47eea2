#include "io/vtk_cells.h"

namespace ravel::io {

namespace {

constexpr int kAnyCount = -1;
constexpr int kUnknown = -2;

int node_count_of(std::uint64_t type) {
    switch (type) {
        case 0:
            return 0;
        case kVtkVertex:
            return 1;
        case kVtkLine:
            return 2;
        case kVtkTriangle:
            return 3;
        case kVtkPixel:
        case kVtkQuad:
        case kVtkTet:
            return 4;
        case 11:  // voxel
        case 12:
            return 8;  // hexahedron
        case 13:
            return 6;  // wedge
        case 14:
            return 5;  // pyramid
        case 15:
            return 10;  // pentagonal prism
        case 16:
            return 12;  // hexagonal prism
        case 21:
            return 3;  // quadratic edge, and so on
        case 22:
            return 6;
        case 23:
            return 8;
        case kVtkQuadraticTet:
            return 10;
        case 25:
            return 20;
        case 26:
            return 15;
        case 27:
            return 13;
        case 28:
            return 9;  // biquadratic quad
        case 29:
            return 27;  // triquadratic hexahedron
        case 30:
            return 6;  // quadratic linear quad
        case 31:
            return 12;  // quadratic linear wedge
        case 32:
            return 18;  // biquadratic quadratic wedge
        case 33:
            return 24;  // biquadratic quadratic hexahedron
        case 34:
            return 7;  // biquadratic triangle
        case 35:
            return 4;  // cubic line
        case 37:
            return 19;  // triquadratic pyramid
        case kVtkPolyVertex:
        case kVtkPolyLine:
        case kVtkStrip:
        case kVtkPolygon:
        case 36:  // quadratic polygon
        case 41:
            return kAnyCount;  // convex point set
        default:
            break;
    }
    // Higher-order, Lagrange and Bezier cells have as many nodes as their order asks for.
    return type >= 60 && type <= 81 ? kAnyCount : kUnknown;
}

}  // namespace

std::optional<std::string> cell_fault(std::uint64_t type, std::uint64_t node_count) {
    if (type == kVtkPolyhedron) return "polyhedra (VTK cell type 42) are not supported";
    const int expected = node_count_of(type);
    if (expected == kUnknown) return "unknown VTK cell type " + std::to_string(type);
    if (expected != kAnyCount && node_count != static_cast<std::uint64_t>(expected)) {
        return "a cell of VTK type " + std::to_string(type) + " has " + std::to_string(expected) +
               " nodes, not " + std::to_string(node_count);
    }
    return std::nullopt;
}

bool same_order_in_gmsh(std::uint16_t type) {
    return type < 70 || type > 74;
}

}  // namespace ravel::io
