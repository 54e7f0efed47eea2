// Point, cell and field data as VTK files have them (one tuple per point or cell, under a name),
// and how they map on the attributes of a Mesh. Legacy VTK and VTU share it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/cell_list.h"
#include "io/left_out.h"
#include "ravel/mesh.h"

namespace ravel::io {

struct NamedArray {
    std::string name;
    Array values;
};

struct VtkData {
    std::vector<NamedArray> points;
    std::vector<NamedArray> cells;
    std::vector<NamedArray> field;
};

// VTK has a value for every point and cell. Where an attribute has none the writer puts zeros, and
// a field array of this name tells by 1 and 0 where the values are real; readers take it back.
inline constexpr const char* kPresentOnPoints = "ravel:present:point:";
inline constexpr const char* kPresentOnCells = "ravel:present:cell:";

// Notes and names of tags have no place of their own in VTK; they go as field arrays of bytes,
// "ravel:note:KEY" and "ravel:tag:DIMENSION:VALUE:ATTRIBUTE".
inline constexpr const char* kNoteArray = "ravel:note:";
inline constexpr const char* kTagArray = "ravel:tag:";

// The arrays to write for the mesh's attributes; what VTK has no place for stays in `left_out`.
VtkData gather_vtk_data(const Mesh& mesh, LeftOut& left_out);

// Splits the cells, adds the arrays as attributes, and notes and names. Arrays must have the right
// tuple counts.
void attach_vtk_data(const CellList& cells, VtkData data, Mesh& mesh);

// Positions from any scalar type; the error tells which of the numbers float64 can't hold.
Result<Array> as_positions(Array values);

// Why the cells can't go to a VTK file as they are; nothing where they can.
std::optional<std::string> vtk_fault(const CellList& cells, const Mesh& mesh);

}  // namespace ravel::io
