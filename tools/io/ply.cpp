// Polygon file format: which columns are points, faces and edges. Every other column becomes an
// attribute of the same name and type, one number per element.
#include <algorithm>
#include <iterator>

#include "io/attributes.h"
#include "io/formats.h"
#include "io/ply_file.h"

namespace ravel::io {

namespace {

constexpr std::uint16_t kLine = 3;
constexpr std::string_view kPrefix = "ply:", kCounts = "#";

std::vector<Index> indices_of(const Array& values) {
    std::vector<Index> indices(values.count());
    with_values(values, [&](auto numbers) {
        std::transform(numbers.begin(), numbers.end(), indices.begin(),
                       [](auto number) { return static_cast<Index>(number); });
    });
    return indices;
}

// x, y and z side by side, in their own type; the smallest float type that holds all, if they
// differ.
Result<Array> positions_of(const PlyElement& vertices, const std::string& path) {
    const PlyProperty* axes[3] = {vertices.find("x", false), vertices.find("y", false),
                                  vertices.find("z", false)};
    Scalar scalar = Scalar::f32;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!axes[k])
            return Error{Code::unreadable, 0,
                         path + ": element vertex has no property " + std::string(1, "xyz"[k])};
        if (axes[k]->type != Scalar::f32 && size_of(axes[k]->type) >= 4) scalar = Scalar::f64;
    }
    Array positions = make_array(scalar, 3, vertices.count);
    for (std::size_t k = 0; k < 3; ++k)
        with_values(axes[k]->values, [&](auto numbers) {
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                if (scalar == Scalar::f32)
                    positions.as<float>()[3 * i + k] = static_cast<float>(numbers[i]);
                else
                    positions.as<double>()[3 * i + k] = static_cast<double>(numbers[i]);
            }
        });
    return positions;
}

// Lists that no corner has a place for: their lengths and their numbers, of the mesh as a whole.
void keep_list(std::vector<Attribute>& kept, const PlyElement& element, PlyProperty& property) {
    const std::string name = std::string(kPrefix) + element.name + ":" + property.name;
    std::vector<std::uint32_t> counts(element.count);
    for (Index r = 0; r < element.count; ++r)
        counts[r] = static_cast<std::uint32_t>(property.begin[r + 1] - property.begin[r]);
    kept.push_back({name + std::string(kCounts), Place::mesh, array_of(counts, 1), {}, {}});
    kept.push_back({name, Place::mesh, std::move(property.values), {}, {}});
}

// A list with the same number of values for each corner of its face, or none, such as texcoord.
bool take_corner_list(Mesh& mesh, PlyProperty& property) {
    Index arity = 0;
    bool some_without = false;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const Index degree = mesh.cell(c).size();
        const Index count = property.begin[c + 1] - property.begin[c];
        if (degree == 0 ? count != 0 : count % degree != 0) return false;
        if (count == 0) {
            some_without = some_without || degree != 0;
            continue;
        }
        if (arity != 0 && count / degree != arity) return false;
        arity = count / degree;
    }
    constexpr Index kLargestArity = 65535;
    if (arity == 0 || arity > kLargestArity) return false;
    std::vector<Index> index;
    if (some_without) {
        index.reserve(mesh.corners.size());
        Index next = 0;
        for (Index c = 0; c < mesh.cell_count(); ++c) {
            const bool has = property.begin[c + 1] != property.begin[c];
            for (std::size_t k = 0; k < mesh.cell(c).size(); ++k)
                index.push_back(has ? next++ : kNoIndex);
        }
    }
    property.values.arity = static_cast<std::uint32_t>(arity);
    add_attribute(mesh, std::string(kPrefix) + property.name, Place::corner,
                  std::move(property.values), std::move(index));
    return true;
}

// Scalars first, then lists of corners, then the rest, so that writing does not change the order.
void take_columns(Mesh& mesh, PlyElement& element, Place place,
                  std::initializer_list<std::string_view> taken, std::vector<Attribute>& kept) {
    const auto is_taken = [&](const PlyProperty& property) {
        return std::find(taken.begin(), taken.end(), property.name) != taken.end();
    };
    for (PlyProperty& property : element.properties)
        if (!property.is_list && !is_taken(property))
            add_attribute(mesh, property.name, place, std::move(property.values));
    for (PlyProperty& property : element.properties)
        if (property.is_list && !is_taken(property) &&
            (place != Place::cell || !take_corner_list(mesh, property)))
            keep_list(kept, element, property);
}

// An element that is neither points, faces nor edges.
void keep_element(PlyElement& element, std::vector<Attribute>& kept) {
    for (PlyProperty& property : element.properties) {
        if (property.is_list) {
            keep_list(kept, element, property);
        } else {
            kept.push_back({std::string(kPrefix) + element.name + ":" + property.name,
                            Place::mesh,
                            std::move(property.values),
                            {},
                            {}});
        }
    }
}

Status take_faces(Mesh& mesh, PlyElement& element, const std::string& path,
                  std::vector<Attribute>& kept) {
    const PlyProperty* corners = element.find("vertex_indices", true);
    if (!corners) corners = element.find("vertex_index", true);
    if (!corners || !corners->names_points)
        return Error{Code::unreadable, 0,
                     path + ": element face has no integer list vertex_indices"};
    mesh.corner_begin = corners->begin;
    mesh.corners = indices_of(corners->values);
    take_columns(mesh, element, Place::cell, {corners->name}, kept);
    return Done{};
}

bool take_edges(Mesh& mesh, PlyElement& element, std::vector<Attribute>& kept) {
    const PlyProperty* from = element.find("vertex1", false);
    const PlyProperty* to = element.find("vertex2", false);
    if (!from || !to || !from->names_points || !to->names_points) return false;
    CompanionBlock block{kLine, 2, element.count, {}, {}};
    const std::vector<Index> ends[2] = {indices_of(from->values), indices_of(to->values)};
    for (Index e = 0; e < element.count; ++e)
        block.nodes.insert(block.nodes.end(), {ends[0][e], ends[1][e]});
    mesh.companions.push_back(std::move(block));
    take_columns(mesh, element, Place::companion, {"vertex1", "vertex2"}, kept);
    return true;
}

}  // namespace

Result<Mesh> read_ply(const std::string& path) {
    Result<PlyFile> file = read_ply_file(path);
    if (!file) return file.error();
    Mesh mesh;
    mesh.corner_begin = {0};
    mesh.notes = std::move(file->notes);
    const PlyElement* vertices = file->find("vertex");
    if (!vertices) return Error{Code::unreadable, 0, path + ": the file has no element vertex"};
    if (!file->find("face") && file->find("tristrips"))
        return Error{Code::unreadable, 0,
                     path +
                         ": its triangles are strips (element tristrips), which are not read; "
                         "expected an element face"};
    for (std::size_t i = 0; i < file->elements.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (file->elements[i].name == file->elements[j].name)
                return Error{Code::unreadable, 0,
                             path + ": element " + file->elements[i].name + " comes twice"};
    Result<Array> positions = positions_of(*vertices, path);
    if (!positions) return positions.error();
    mesh.positions = std::move(*positions);
    // Whatever the order of the file, this is the order in which a mesh is written.
    std::vector<Attribute> kept;
    const auto order = [](const PlyElement& element) {
        return element.name == "vertex" ? 0
               : element.name == "face" ? 1
               : element.name == "edge" ? 2
                                        : 3;
    };
    std::stable_sort(file->elements.begin(), file->elements.end(),
                     [&](const PlyElement& a, const PlyElement& b) { return order(a) < order(b); });
    for (PlyElement& element : file->elements) {
        if (element.name == "vertex") {
            take_columns(mesh, element, Place::point, {"x", "y", "z"}, kept);
        } else if (element.name == "face") {
            if (Status status = take_faces(mesh, element, path, kept); !status)
                return status.error();
        } else if (element.name != "edge" || !take_edges(mesh, element, kept)) {
            keep_element(element, kept);
        }
    }
    std::move(kept.begin(), kept.end(), std::back_inserter(mesh.attributes));
    return mesh;
}

}  // namespace ravel::io
