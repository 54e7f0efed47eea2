#include "io/gmsh_types.h"

#include <array>

namespace ravel::io {

namespace {

// The first triangle of VTK's wedge looks outward, that of Gmsh's prism inward.
constexpr std::array<std::uint8_t, 6> kWedge6 = {0, 2, 1, 3, 5, 4};
constexpr std::array<std::uint8_t, 10> kTet10 = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
constexpr std::array<std::uint8_t, 20> kHex20 = {0,  1, 2,  3,  4,  5,  6,  7,  8,  11,
                                                 13, 9, 16, 18, 19, 17, 10, 12, 14, 15};
constexpr std::array<std::uint8_t, 27> kHex27 = {0,  1,  2,  3,  4,  5,  6,  7,  8,
                                                 11, 13, 9,  16, 18, 19, 17, 10, 12,
                                                 14, 15, 22, 23, 21, 24, 20, 25, 26};
constexpr std::array<std::uint8_t, 15> kWedge15 = {0, 1,  2,  3,  4, 5,  6, 9,
                                                   7, 12, 14, 13, 8, 10, 11};
constexpr std::array<std::uint8_t, 18> kWedge18 = {0,  1,  2,  3, 4,  5,  6,  9,  7,
                                                   12, 14, 13, 8, 10, 11, 15, 17, 16};
constexpr std::array<std::uint8_t, 13> kPyramid13 = {0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12};

// Elements without a VTK type of their own are VTK's Lagrange cells (68 curve, 69 triangle, 70
// quad, 71 tet, 72 hexahedron, 74 pyramid) of the same node count.
constexpr std::array kTypes = {
    GmshType{1, 3, 2, 1, {}},
    GmshType{2, 5, 3, 2, {}},
    GmshType{3, 9, 4, 2, {}},
    GmshType{4, 10, 4, 3, {}},
    GmshType{5, 12, 8, 3, {}},
    GmshType{6, 13, 6, 3, kWedge6},
    GmshType{7, 14, 5, 3, {}},
    GmshType{8, 21, 3, 1, {}},
    GmshType{9, 22, 6, 2, {}},
    GmshType{10, 28, 9, 2, {}},
    GmshType{11, 24, 10, 3, kTet10},
    GmshType{12, 29, 27, 3, kHex27},
    GmshType{13, 32, 18, 3, kWedge18},
    GmshType{14, 74, 14, 3, {}},
    GmshType{15, 1, 1, 0, {}},
    GmshType{16, 23, 8, 2, {}},
    GmshType{17, 25, 20, 3, kHex20},
    GmshType{18, 26, 15, 3, kWedge15},
    GmshType{19, 27, 13, 3, kPyramid13},
    GmshType{21, 69, 10, 2, {}},
    GmshType{23, 69, 15, 2, {}},
    GmshType{25, 69, 21, 2, {}},
    GmshType{26, 68, 4, 1, {}},
    GmshType{27, 68, 5, 1, {}},
    GmshType{28, 68, 6, 1, {}},
    GmshType{29, 71, 20, 3, {}},
    GmshType{30, 71, 35, 3, {}},
    GmshType{31, 71, 56, 3, {}},
    GmshType{36, 70, 16, 2, {}},
    GmshType{37, 70, 25, 2, {}},
    GmshType{38, 70, 36, 2, {}},
    GmshType{92, 72, 64, 3, {}},
    GmshType{93, 72, 125, 3, {}},
};

}  // namespace

const GmshType* find_gmsh_type(std::int64_t gmsh) {
    for (const GmshType& type : kTypes) {
        if (type.gmsh == gmsh) return &type;
    }
    return nullptr;
}

const GmshType* gmsh_type_of(std::uint16_t vtk, std::size_t nodes) {
    for (const GmshType& type : kTypes) {
        if (type.vtk == vtk && type.nodes == nodes) return &type;
    }
    return nullptr;
}

}  // namespace ravel::io
