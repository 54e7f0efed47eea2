// Polygon file format: which columns a mesh becomes.
#include <algorithm>
#include <cstring>
#include <limits>

#include "io/attributes.h"
#include "io/decimals.h"
#include "io/formats.h"
#include "io/left_out.h"
#include "io/ply_file.h"

namespace ravel::io {

namespace {

constexpr std::uint16_t kLine = 3;
constexpr std::string_view kPrefix = "ply:";
constexpr char kCounts = '#';

bool is_word(std::string_view name) {
    return !name.empty() && name.find_first_of(" \t\r\n\v\f") == std::string_view::npos;
}

PlyProperty column(std::string name, Array values) {
    PlyProperty property;
    property.name = std::move(name);
    property.type = values.scalar;
    property.values = std::move(values);
    return property;
}

Array narrow_indices(std::span<const Index> indices, Index points) {
    if (points > static_cast<Index>(std::numeric_limits<std::int32_t>::max()))
        return array_of(indices, 1);
    std::vector<std::int32_t> narrow(indices.size());
    std::transform(indices.begin(), indices.end(), narrow.begin(),
                   [](Index i) { return static_cast<std::int32_t>(i); });
    return array_of(narrow, 1);
}

void add_list(PlyElement& element, std::string name, Array values, std::vector<Index> begin) {
    PlyProperty property = column(std::move(name), std::move(values));
    property.is_list = true;
    Index longest = 0;
    for (std::size_t r = 1; r < begin.size(); ++r)
        longest = std::max(longest, begin[r] - begin[r - 1]);
    property.count_type = longest <= 255          ? Scalar::u8
                          : longest <= 2147483647 ? Scalar::i32
                                                  : Scalar::u64;
    property.begin = std::move(begin);
    if (property.begin.empty()) property.begin = {0};
    element.properties.push_back(std::move(property));
}

// Component `k` of the tuples of the given elements, one number each.
Array component(const Attribute& attribute, std::span<const Index> elements, std::uint32_t k) {
    const std::size_t size = size_of(attribute.values.scalar);
    Array numbers = make_array(attribute.values.scalar, 1, elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i)
        std::memcpy(numbers.bytes.data() + i * size,
                    attribute.values.bytes.data() +
                        (tuple_of(attribute, elements[i]) * attribute.values.arity + k) * size,
                    size);
    return numbers;
}

bool every_element_has_one(const Attribute& attribute) {
    return std::find(attribute.index.begin(), attribute.index.end(), kNoIndex) ==
           attribute.index.end();
}

// Attributes of one place become columns; a tuple becomes several, called name.0, name.1 and so on.
void add_columns(PlyElement& element, const Mesh& mesh, Place place,
                 std::span<const Index> elements, LeftOut& left_out) {
    for (const Attribute& attribute : mesh.attributes) {
        if (attribute.place != place || !is_word(attribute.name)) continue;
        if (!every_element_has_one(attribute)) continue;
        if (element.find(attribute.name, false)) continue;
        left_out.take(&attribute);
        for (std::uint32_t k = 0; k < attribute.values.arity; ++k) {
            std::string name = attribute.name;
            if (attribute.values.arity > 1) {
                name += '.';
                append_number(name, k);
            }
            element.properties.push_back(
                column(std::move(name), component(attribute, elements, k)));
        }
    }
}

// Lists hold the tuples of all corners of a face, or of none of them.
void add_corner_list(PlyElement& faces, const Mesh& mesh, const Attribute& attribute,
                     LeftOut& left_out) {
    std::string name = attribute.name;
    if (name.starts_with(kPrefix)) name = name.substr(kPrefix.size());
    if (!is_word(name)) return;
    const std::size_t stride = attribute.values.stride();
    Array values{attribute.values.scalar, 1, {}};
    std::vector<Index> begin{0};
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        std::size_t with = 0;
        const Index first = mesh.corner_begin[c], last = mesh.corner_begin[c + 1];
        for (Index corner = first; corner < last; ++corner) {
            const Index tuple = tuple_of(attribute, corner);
            if (tuple == kNoIndex) continue;
            ++with;
            const auto from =
                attribute.values.bytes.begin() + static_cast<std::ptrdiff_t>(tuple * stride);
            values.bytes.insert(values.bytes.end(), from,
                                from + static_cast<std::ptrdiff_t>(stride));
        }
        if (with != 0 && with != last - first) return;
        begin.push_back(values.count());
    }
    left_out.take(&attribute);
    add_list(faces, std::move(name), std::move(values), std::move(begin));
}

// What `read_ply` kept of elements and lists it did not know, by names "ply:element:property".
void add_kept(PlyFile& file, const Mesh& mesh, LeftOut& left_out) {
    for (const Attribute& attribute : mesh.attributes) {
        const std::size_t colon = attribute.name.find(':', kPrefix.size());
        if (attribute.place != Place::mesh || !attribute.name.starts_with(kPrefix) ||
            colon == std::string::npos || attribute.name.back() == kCounts ||
            attribute.values.arity != 1)
            continue;
        const std::string element_name =
            attribute.name.substr(kPrefix.size(), colon - kPrefix.size());
        std::string name = attribute.name.substr(colon + 1);
        if (!is_word(element_name) || !is_word(name)) continue;

        const Attribute* counts = find_attribute(mesh, Place::mesh, attribute.name + kCounts);
        std::vector<Index> begin{0};
        if (counts) {
            for (std::size_t r = 0; r < counts->values.count(); ++r) {
                std::int64_t count = 0;
                integer_at(counts->values, r, count);
                begin.push_back(begin.back() +
                                static_cast<Index>(std::max<std::int64_t>(count, 0)));
            }
            if (begin.back() != attribute.values.count()) continue;
        }
        const Index rows = counts ? begin.size() - 1 : attribute.values.count();
        auto element = std::find_if(file.elements.begin(), file.elements.end(),
                                    [&](const PlyElement& e) { return e.name == element_name; });
        if (element == file.elements.end())
            element = file.elements.insert(file.elements.end(), {element_name, rows, {}});
        if (element->count != rows) continue;
        left_out.take(&attribute);
        left_out.take(counts);
        if (counts) {
            add_list(*element, std::move(name), attribute.values, std::move(begin));
        } else {
            element->properties.push_back(column(std::move(name), attribute.values));
        }
    }
}

std::vector<Index> all_elements(Index count) {
    std::vector<Index> elements(count);
    for (Index i = 0; i < count; ++i) elements[i] = i;
    return elements;
}

void add_edges(PlyFile& file, const Mesh& mesh, LeftOut& left_out) {
    std::vector<Index> lines;  // among all companions
    std::vector<Index> ends[2];
    Index first = 0;
    bool any = false;
    for (std::size_t b = 0; b < mesh.companions.size(); ++b) {
        const CompanionBlock& block = mesh.companions[b];
        if (block.vtk_type == kLine && block.nodes_per_cell == 2) {
            any = true;
            left_out.take_block(b);
            for (Index c = 0; c < block.cell_count; ++c) {
                lines.push_back(first + c);
                ends[0].push_back(block.nodes[2 * c]);
                ends[1].push_back(block.nodes[2 * c + 1]);
            }
        }
        first += block.cell_count;
    }
    if (!any) return;
    PlyElement edges{"edge", lines.size(), {}};
    edges.properties.push_back(column("vertex1", narrow_indices(ends[0], mesh.point_count())));
    edges.properties.push_back(column("vertex2", narrow_indices(ends[1], mesh.point_count())));
    add_columns(edges, mesh, Place::companion, lines, left_out);
    file.elements.push_back(std::move(edges));
}

}  // namespace

Status write_ply(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                 Sentences* left_out_sentences) {
    if (mesh.kind != CellKind::polygon && mesh.cell_count() != 0)
        return cannot_hold(path, "PLY holds polygons, not tetrahedra");
    LeftOut left_out(mesh, "PLY");
    PlyFile file;
    for (const Note& note : mesh.notes)
        if (note.key == "ply:comment" || note.key == "ply:obj_info") file.notes.push_back(note);
    left_out.take_notes("ply:comment");
    left_out.take_notes("ply:obj_info");

    PlyElement vertices{"vertex", mesh.point_count(), {}};
    const Attribute positions{"", Place::point, mesh.positions, {}, {}};
    const std::vector<Index> points = all_elements(mesh.point_count());
    for (std::uint32_t k = 0; k < 3; ++k)
        vertices.properties.push_back(
            column(std::string(1, "xyz"[k]), component(positions, points, k)));
    add_columns(vertices, mesh, Place::point, points, left_out);

    PlyElement faces{"face", mesh.cell_count(), {}};
    add_list(faces, "vertex_indices", narrow_indices(mesh.corners, mesh.point_count()),
             mesh.corner_begin);
    add_columns(faces, mesh, Place::cell, all_elements(mesh.cell_count()), left_out);
    for (const Attribute& attribute : mesh.attributes)
        if (attribute.place == Place::corner && !mesh.corners.empty())
            add_corner_list(faces, mesh, attribute, left_out);

    file.elements.push_back(std::move(vertices));
    file.elements.push_back(std::move(faces));
    add_edges(file, mesh, left_out);
    add_kept(file, mesh, left_out);
    left_out.report(left_out_sentences);
    return write_ply_file(file, path, options.binary);
}

}  // namespace ravel::io
