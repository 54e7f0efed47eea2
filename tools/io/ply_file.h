// A PLY file as it is: elements with columns of scalars and lists, whatever they mean.
#pragma once

#include <string>
#include <vector>

#include "ravel/mesh.h"

namespace ravel::io {

struct PlyProperty {
    std::string name;
    Scalar type = Scalar::f32;
    bool is_list = false;
    Scalar count_type = Scalar::u8;
    Array values;               // arity 1; one number per row, or all lists one after the other
    std::vector<Index> begin;   // lists: row r has values [begin[r], begin[r+1])
    bool names_points = false;  // its values are rows of the element "vertex"
};

struct PlyElement {
    std::string name;
    Index count = 0;
    std::vector<PlyProperty> properties;

    const PlyProperty* find(std::string_view property, bool is_list) const;
};

struct PlyFile {
    std::vector<Note> notes;  // comments and obj_info, in file order
    std::vector<PlyElement> elements;

    const PlyElement* find(std::string_view element) const;
};

// Properties that name points, by their place in the format: lists of faces, ends of edges.
bool ply_names_points(std::string_view element, const PlyProperty& property);

Result<PlyFile> read_ply_file(const std::string& path);
Status write_ply_file(const PlyFile& file, const std::string& path, bool binary);

}  // namespace ravel::io
