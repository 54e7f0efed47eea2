// What a Gmsh MSH file holds, the same for versions 2.2 and 4.1 and for text and binary: readers
// fill it, writers empty it, and it maps on a Mesh.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/cell_list.h"
#include "io/left_out.h"
#include "ravel/mesh.h"

namespace ravel::io {

// A geometric entity of version 4.1.
struct MshEntity {
    std::int32_t tag = 0;
    std::array<double, 6> box{};  // a point has only its three coordinates
    std::vector<std::int32_t> physical;
    std::vector<std::int32_t> bounds;  // entities of the next lower dimension, signed
};
using MshEntities = std::array<std::vector<MshEntity>, 4>;  // by dimension

// $NodeData or $ElementData.
struct MshData {
    Place place = Place::point;  // or cell, which then means all elements
    std::string name;
    std::string header;       // the other string, real and integer tags; see `default_header`
    std::vector<Index> tags;  // of nodes or elements
    Array values;
};

struct MshSection {
    std::string name;
    std::string text;  // as it is between the lines $Name and $EndName
    bool binary = false;
};

// The type an array had, where the numbers in the file alone would be taken for another.
struct MshType {
    std::string section;  // "Nodes", "NodeData" or "ElementData"
    Scalar scalar = Scalar::f64;
    std::string name;
};

struct MshFile {
    bool version_4 = true;
    bool binary = false;

    Array positions{Scalar::f64, 3, {}};  // f64 when read, whatever the mesh has when written
    std::vector<Index> node_tags;
    std::vector<std::int32_t> node_dimensions, node_entities;  // version 4
    std::vector<double> parametric;                            // three per node that has them
    std::vector<Index> parametric_index;                       // per node, kNoIndex for most

    CellList cells;
    std::vector<Index> element_tags;
    std::vector<CellData> element_columns;  // version 2: the tags, i32; version 4: see msh_to_mesh
    std::vector<std::int32_t> element_dimensions, element_entities;  // version 4
    bool gmsh_order = false;  // higher-order nodes are in Gmsh's order

    bool has_entities = false;
    MshEntities entities;
    std::vector<TagName> names;
    std::vector<MshData> data;
    std::vector<MshSection> sections;  // kept as they are
    std::vector<MshType> types;
};

// Is the section one of Gmsh's, whose content in binary files is not text?
bool has_binary_form(const std::string& section);
// Would a section of this name and text be read as one that was kept? Notes may be anyone's.
bool can_be_section(const std::string& name, const std::string& text, bool binary);

// Names of what a Mesh keeps of a Gmsh file.
inline constexpr const char* kGmshVersion = "gmsh:version";  // a note; absent means 4.1
inline constexpr const char* kGmshEntities = "gmsh:entities";
inline constexpr const char* kGmshSection = "gmsh:section:";
inline constexpr const char* kGmshBinarySection = "gmsh:binary_section:";
inline constexpr const char* kGmshNodeData = "gmsh:NodeData:";
inline constexpr const char* kGmshElementData = "gmsh:ElementData:";
inline constexpr const char* kGmshNode = "gmsh:node";
inline constexpr const char* kGmshElement = "gmsh:element";
// Which corner of its element each corner was, where $ElementNodeData has values for them in order.
inline constexpr const char* kGmshCorner = "gmsh:corner";
inline constexpr const char* kCornerSection = "ElementNodeData";
inline constexpr const char* kGmshPhysical = "gmsh:physical";
inline constexpr const char* kGmshGeometrical = "gmsh:geometrical";
inline constexpr const char* kGmshElementDimension = "gmsh:element_dim";
inline constexpr const char* kGmshEntityDimension = "gmsh:entity_dim";
inline constexpr const char* kGmshEntityTag = "gmsh:entity_tag";
inline constexpr const char* kGmshParametric = "gmsh:parametric";
// Foreign readers skip sections they don't know; ours finds types of arrays in this one.
inline constexpr const char* kTypesSection = "ArrayTypes";

// The name of tag number `slot` of version 2: physical, geometrical, then partitions.
std::string gmsh_tag_name(std::size_t slot);
// Nodes and elements that name no entity are in this one, of the mesh's own dimension.
inline constexpr std::int32_t kDefaultEntity = 1;
inline std::int32_t dimension_of(CellKind kind) {
    return kind == CellKind::tet ? 3 : 2;
}

// The scalar type of values read back from a file that is text or binary.
Scalar type_when_read(const Array& values, bool binary);
// The values in another type if that holds all of them exactly, else the array as it is.
Array in_type(Array values, Scalar scalar);

// The error names the array with a wrong tag.
Result<Mesh> msh_to_mesh(MshFile file, const std::string& path);
Result<MshFile> mesh_to_msh(const Mesh& mesh, const std::string& path, bool binary,
                            LeftOut& left_out);

}  // namespace ravel::io
