// From a Gmsh file to a Mesh: tags become attributes where they say more than the order does.
#include <cmath>
#include <limits>
#include <map>

#include "io/attributes.h"
#include "io/gmsh_types.h"
#include "io/msh_stream.h"

namespace ravel::io {

namespace {

bool counts_from_one(const std::vector<Index>& tags, const std::vector<Index>& order) {
    for (Index i = 0; i < tags.size(); ++i) {
        if (tags[order.empty() ? i : order[i]] != i + 1) return false;
    }
    return true;
}

Array as_i64(const std::vector<Index>& tags) {
    return array_of(std::vector<std::int64_t>(tags.begin(), tags.end()), 1);
}

bool all_are(const std::vector<std::int32_t>& values, std::int32_t value) {
    return std::all_of(values.begin(), values.end(), [&](std::int32_t v) { return v == value; });
}

// May a section that is kept as it is name nodes or elements by their numbers? Then these have to
// be kept, too, since the order of points and cells may change.
bool names_nodes(const MshSection& section) {
    for (const char* name : {"PartitionedEntities", "GhostElements", "Parametrizations",
                             "ElementNodeData", "InterpolationScheme", "Comments"}) {
        if (section.name == name) return false;
    }
    return true;
}
bool names_elements(const MshSection& section) {
    for (const char* name : {"PartitionedEntities", "Periodic", "Parametrizations",
                             "InterpolationScheme", "Comments"}) {
        if (section.name == name) return false;
    }
    return true;
}

void add_node_attributes(MshFile& file, CellKind kind, Mesh& mesh) {
    if (!counts_from_one(file.node_tags, {}) ||
        std::any_of(file.sections.begin(), file.sections.end(), names_nodes)) {
        add_attribute(mesh, kGmshNode, Place::point, as_i64(file.node_tags));
    }
    if (!all_are(file.node_dimensions, dimension_of(kind)) ||
        !all_are(file.node_entities, kDefaultEntity)) {
        add_attribute(mesh, kGmshEntityDimension, Place::point, array_of(file.node_dimensions, 1));
        add_attribute(mesh, kGmshEntityTag, Place::point, array_of(file.node_entities, 1));
    }
    if (!file.parametric.empty()) {
        if (file.parametric.size() == 3 * file.node_tags.size()) file.parametric_index.clear();
        add_attribute(mesh, kGmshParametric, Place::point, array_of(file.parametric, 3),
                      std::move(file.parametric_index));
    }
}

// Version 4 tells the entity of each element, and of the entities their physical tags.
std::vector<CellData> columns_of_entities(const MshFile& file) {
    std::vector<CellData> columns;
    if (!all_are(file.element_entities, kDefaultEntity)) {
        columns.push_back({kGmshGeometrical, array_of(file.element_entities, 1), {}});
    }
    bool usual = true;
    for (Index c = 0; c < file.cells.count(); ++c) {
        const GmshType* type = gmsh_type_of(file.cells.types[c], file.cells.cell(c).size());
        usual = usual && type && type->dimension == file.element_dimensions[c];
    }
    if (!usual) {
        columns.push_back({kGmshElementDimension, array_of(file.element_dimensions, 1), {}});
    }

    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> physical;
    for (std::int32_t dimension = 0; dimension < 4; ++dimension) {
        for (const MshEntity& entity : file.entities[static_cast<std::size_t>(dimension)]) {
            if (!entity.physical.empty()) {
                physical.emplace(std::pair(dimension, entity.tag), entity.physical.front());
            }
        }
    }
    if (physical.empty()) return columns;
    std::vector<std::int32_t> values;
    std::vector<Index> index;
    for (Index c = 0; c < file.cells.count(); ++c) {
        const auto found = physical.find({file.element_dimensions[c], file.element_entities[c]});
        index.push_back(found == physical.end() ? kNoIndex : values.size());
        if (found != physical.end()) values.push_back(found->second);
    }
    if (values.empty()) return columns;
    if (values.size() == index.size()) index.clear();
    columns.push_back({kGmshPhysical, array_of(values, 1), std::move(index)});
    return columns;
}

// Element numbers matter where they are not the order of the file.
bool keeps_element_tags(const MshFile& file) {
    if (std::any_of(file.sections.begin(), file.sections.end(), names_elements)) return true;
    return !counts_from_one(file.element_tags, mesh_order(file.cells)) &&
           !counts_from_one(file.element_tags, {});
}

// Cells of a mesh may come to begin with another corner; values in a section can't follow.
void add_corner_numbers(const MshFile& file, Mesh& mesh) {
    const auto has_corners = [](const MshSection& s) { return s.name == kCornerSection; };
    if (!std::any_of(file.sections.begin(), file.sections.end(), has_corners)) return;
    std::vector<std::uint8_t> numbers;
    numbers.reserve(mesh.corners.size());
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        for (std::size_t k = 0; k < mesh.cell(c).size(); ++k) {
            numbers.push_back(static_cast<std::uint8_t>(k));
        }
    }
    add_attribute(mesh, kGmshCorner, Place::corner, array_of(numbers, 1));
}

// Rows come in any order and may leave elements out. Gives the index per element.
Result<std::vector<Index>> index_of_rows(const MshData& data, const TagLookup& lookup, Index count,
                                         const std::string& path) {
    const std::string what = path + ": the data '" + data.name + "' have a value of ";
    std::vector<Index> row_of(count, kNoIndex);
    for (Index row = 0; row < data.tags.size(); ++row) {
        const Index element = lookup.find(data.tags[row]);
        if (element == kNoIndex) {
            return Error{Code::unreadable, row,
                         what + std::to_string(data.tags[row]) + ", which is not there"};
        }
        if (row_of[element] != kNoIndex) {
            return Error{Code::unreadable, row, what + std::to_string(data.tags[row]) + " twice"};
        }
        row_of[element] = row;
    }
    return row_of;
}

// Brings the rows into the order of the elements.
void order_rows(MshData& data, std::vector<Index>& index) {
    const std::size_t stride = data.values.stride();
    std::vector<std::byte> ordered;
    ordered.reserve(data.values.bytes.size());
    Index present = 0;
    for (Index& row : index) {
        if (row == kNoIndex) continue;
        const auto from = data.values.bytes.begin() + static_cast<std::ptrdiff_t>(row * stride);
        ordered.insert(ordered.end(), from, from + static_cast<std::ptrdiff_t>(stride));
        row = present++;
    }
    data.values.bytes = std::move(ordered);
    if (present == index.size()) index.clear();
}

// Everything was read as float64. The type is the one noted for the array; without a note text
// files tell it by their decimals.
Array typed(const MshFile& file, std::vector<bool>& used, const std::string& section,
            const std::string& name, Array values) {
    for (std::size_t t = 0; t < file.types.size(); ++t) {
        const MshType& type = file.types[t];
        if (used[t] || type.section != section || type.name != name) continue;
        used[t] = true;
        return in_type(std::move(values), type.scalar);
    }
    return file.binary ? values : floats_from_text(values.as<double>(), values.arity);
}

void apply_types(MshFile& file) {
    std::vector<bool> used(file.types.size());
    file.positions = typed(file, used, "Nodes", "", std::move(file.positions));
    for (MshData& data : file.data) {
        const char* section = data.place == Place::point ? "NodeData" : "ElementData";
        data.values = typed(file, used, section, data.name, std::move(data.values));
    }
}

void add_notes(const MshFile& file, Mesh& mesh) {
    if (!file.version_4) mesh.notes.push_back({kGmshVersion, "2.2"});
    if (file.gmsh_order) mesh.notes.push_back({kGmshNodeOrder, "yes"});
    if (file.has_entities) {
        MshOutput text(false);
        put_entities(text, file.entities);
        mesh.notes.push_back({kGmshEntities, text.out});
    }
    for (const MshData& data : file.data) {
        if (data.header.empty()) continue;
        mesh.notes.push_back(
            {(data.place == Place::point ? kGmshNodeData : kGmshElementData) + data.name,
             data.header});
    }
    for (const MshSection& section : file.sections) {
        mesh.notes.push_back(
            {(section.binary ? kGmshBinarySection : kGmshSection) + section.name, section.text});
    }
}

}  // namespace

std::string gmsh_tag_name(std::size_t slot) {
    if (slot == 0) return kGmshPhysical;
    if (slot == 1) return kGmshGeometrical;
    return "gmsh:tag" + std::to_string(slot + 1);
}

Scalar type_when_read(const Array& values, bool binary) {
    if (binary) return Scalar::f64;
    // Each float32 is written as the shortest decimal that is nearest to it.
    if (values.scalar == Scalar::f32) return Scalar::f32;
    for (std::size_t i = 0; i < values.count() * values.arity; ++i) {
        if (!survives_float32(real_at(values, i))) return Scalar::f64;
    }
    return Scalar::f32;
}

Array in_type(Array values, Scalar scalar) {
    if (values.scalar == scalar) return values;
    Array cast = make_array(scalar, values.arity, values.count());
    bool exact = true;
    with_values(cast, [&]<class T>(std::span<const T>) {
        const std::span<T> out = cast.as<T>();
        for (std::size_t i = 0; i < out.size(); ++i) {
            const double value = real_at(values, i);
            // Casting what is out of range is undefined, so the range is asked first.
            if constexpr (std::is_integral_v<T>) {
                if (!(value >= static_cast<double>(std::numeric_limits<T>::min()) &&
                      value < std::ldexp(1.0, std::numeric_limits<T>::digits))) {
                    exact = false;
                    return;
                }
            }
            out[i] = static_cast<T>(value);
            const auto back = static_cast<double>(out[i]);
            exact = exact && (back == value || (back != back && value != value));
        }
    });
    return exact ? cast : values;
}

Result<Mesh> msh_to_mesh(MshFile file, const std::string& path) {
    apply_types(file);
    Mesh mesh;
    mesh.positions = std::move(file.positions);
    add_node_attributes(file, kind_of(file.cells), mesh);

    TagLookup nodes, elements;
    Index twice = 0;
    nodes.fill(file.node_tags, twice);
    const bool unique = elements.fill(file.element_tags, twice);
    std::vector<CellData> cell_data =
        file.version_4 ? columns_of_entities(file) : std::move(file.element_columns);
    if (keeps_element_tags(file)) {
        cell_data.push_back({kGmshElement, as_i64(file.element_tags), {}});
    }
    for (MshData& data : file.data) {
        const bool on_nodes = data.place == Place::point;
        if (!on_nodes && !unique && !data.tags.empty()) {
            return Error{Code::unreadable, twice,
                         path + ": element " + std::to_string(twice) +
                             " is there twice, so data on elements have no clear place"};
        }
        Result<std::vector<Index>> index =
            index_of_rows(data, on_nodes ? nodes : elements,
                          on_nodes ? file.node_tags.size() : file.cells.count(), path);
        if (!index) return index.error();
        order_rows(data, *index);
        if (on_nodes) {
            add_attribute(mesh, data.name, Place::point, std::move(data.values), std::move(*index));
        } else {
            cell_data.push_back({data.name, std::move(data.values), std::move(*index)});
        }
    }
    split_cells(file.cells, std::move(cell_data), mesh);
    add_corner_numbers(file, mesh);
    mesh.tag_names = std::move(file.names);
    add_notes(file, mesh);
    return mesh;
}

}  // namespace ravel::io
