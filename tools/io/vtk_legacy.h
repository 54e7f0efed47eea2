// What the parts of the legacy VTK reader share: the file, its mode, and arrays in it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/text_reader.h"
#include "io/vtk_data.h"

namespace ravel::io {

// What is written for meshes without notes; files that have them get no notes.
inline constexpr const char* kVtkVersion = "4.2";
inline constexpr const char* kVtkTitle = "mesh";

struct VtkLegacy {
    TextReader text;
    bool binary = false;
    bool has_offsets = false;  // from version 5 on cells are offsets and connectivity
};

// An array of the file and where it began, to tell the place of a wrong number later.
struct VtkArray {
    Array values;
    std::size_t start = 0;
    std::size_t scalar_size = 0;
};

struct VtkScalar {
    Scalar scalar = Scalar::f64;
    bool narrow_id = false;  // a vtkIdType: 64-bit in memory, 32-bit in binary files
};

// The scalar of VTK's names ("unsigned_char", "vtktypeint64", ...); nothing for "bit" and "string".
std::optional<VtkScalar> vtk_scalar(std::string_view name);
// The name to write. Version 5 has a name for 64-bit integers that means them on every machine.
const char* vtk_scalar_name(Scalar scalar, bool version_5);

// Reads a type name and then, from the next line on, the array.
Result<VtkArray> read_vtk_array(VtkLegacy& file, std::string_view type, std::uint32_t arity,
                                Index tuples, const std::string& what);
// "FILE:LINE: sentence" or "FILE: byte N: sentence" at a number of an array.
Error error_at(VtkLegacy& file, const VtkArray& array, Index number, const std::string& sentence);

// Reads everything after the geometry: POINT_DATA, CELL_DATA, FIELD and what is in them.
Status read_vtk_field(VtkLegacy& file, std::vector<NamedArray>& into, std::optional<Index> tuples);
Status read_vtk_attributes(VtkLegacy& file, Index points, Index cells, VtkData& data);
// Skips a METADATA block: it ends with an empty line.
void skip_vtk_metadata(VtkLegacy& file);

// Names have no blanks in legacy files: those, quotes and '%' are written as %XX.
std::string encode_vtk_name(std::string_view name);
std::string decode_vtk_name(std::string_view name);

}  // namespace ravel::io
