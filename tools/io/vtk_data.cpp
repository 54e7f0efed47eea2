#include "io/vtk_data.h"

#include <algorithm>

#include "io/attributes.h"
#include "io/gmsh_types.h"
#include "io/typed_values.h"
#include "io/vtk_cells.h"

namespace ravel::io {

namespace {

Array presence(std::span<const Index> index) {
    Array mask = make_array(Scalar::u8, 1, index.size());
    for (std::size_t e = 0; e < index.size(); ++e) {
        mask.bytes[e] = std::byte{index[e] != kNoIndex};
    }
    return mask;
}

// Keeps only the tuples that the mask marks, if the field data has a fitting mask of this name.
std::vector<Index> apply_presence(const VtkData& data, const std::string& prefix,
                                  NamedArray& array) {
    const auto mask = std::find_if(data.field.begin(), data.field.end(), [&](const NamedArray& f) {
        return f.name == prefix + array.name && f.values.scalar == Scalar::u8 &&
               f.values.arity == 1 && f.values.count() == array.values.count();
    });
    std::vector<Index> index;
    if (mask == data.field.end()) return index;
    const std::size_t stride = array.values.stride();
    std::vector<std::byte> kept;
    Index present = 0;
    for (std::size_t e = 0; e < mask->values.bytes.size(); ++e) {
        if (mask->values.bytes[e] == std::byte{0}) {
            index.push_back(kNoIndex);
            continue;
        }
        const auto from = array.values.bytes.begin() + static_cast<std::ptrdiff_t>(e * stride);
        kept.insert(kept.end(), from, from + static_cast<std::ptrdiff_t>(stride));
        index.push_back(present++);
    }
    array.values.bytes = std::move(kept);
    return index;
}

bool is_presence(const NamedArray& array) {
    return array.name.starts_with(kPresentOnPoints) || array.name.starts_with(kPresentOnCells);
}

Array text_array(const std::string& text) {
    return array_of(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), 1);
}

// Notes about VTK files are written where VTK has them; the version of a Gmsh file matters to none.
bool is_about_files(const std::string& key) {
    return key.starts_with("vtk:") || key == "gmsh:version";
}

void gather_words(const Mesh& mesh, LeftOut& left_out, std::vector<NamedArray>& field) {
    for (const Note& note : mesh.notes) {
        left_out.take_notes(note.key);
        if (is_about_files(note.key)) continue;
        field.push_back({kNoteArray + note.key, text_array(note.text)});
    }
    for (const TagName& tag : mesh.tag_names) {
        left_out.take_tag_names(tag.attribute);
        field.push_back({kTagArray + std::to_string(tag.dimension) + ':' +
                             std::to_string(tag.value) + ':' + tag.attribute,
                         text_array(tag.name)});
    }
}

// Takes a field array that is words; false where it is numbers.
bool take_words(const NamedArray& array, Mesh& mesh) {
    if (array.values.scalar != Scalar::u8 || array.values.arity != 1) return false;
    const std::string text(reinterpret_cast<const char*>(array.values.bytes.data()),
                           array.values.bytes.size());
    const std::string_view name = array.name;
    if (name.starts_with(kNoteArray)) {
        const std::size_t prefix = std::string_view(kNoteArray).size();
        mesh.notes.push_back({std::string(name.substr(prefix)), text});
        return true;
    }
    if (!name.starts_with(kTagArray)) return false;
    const std::string_view rest = name.substr(std::string_view(kTagArray).size());
    const std::size_t first = rest.find(':');
    const std::size_t second = first == rest.npos ? rest.npos : rest.find(':', first + 1);
    TagName tag;
    if (second == rest.npos || !parse_integer(rest.substr(0, first), tag.dimension) ||
        tag.dimension < -1 || tag.dimension > 3 ||
        !parse_integer(rest.substr(first + 1, second - first - 1), tag.value)) {
        return false;
    }
    tag.attribute = rest.substr(second + 1);
    tag.name = text;
    mesh.tag_names.push_back(std::move(tag));
    return true;
}

}  // namespace

VtkData gather_vtk_data(const Mesh& mesh, LeftOut& left_out) {
    VtkData data;
    for (const Attribute& attribute : mesh.attributes) {
        if (attribute.place == Place::mesh) {
            data.field.push_back({attribute.name, attribute.values});
            left_out.take(&attribute);
        } else if (attribute.place == Place::point) {
            data.points.push_back({attribute.name, expand(attribute.values, attribute.index)});
            left_out.take(&attribute);
            if (!attribute.index.empty()) {
                data.field.push_back(
                    {kPresentOnPoints + attribute.name, presence(attribute.index)});
            }
        }
    }
    for (const CellData& joined : join_cell_data(mesh)) {
        data.cells.push_back({joined.name, expand(joined.values, joined.index)});
        left_out.take(joined.on_cells);
        left_out.take(joined.on_companions);
        if (!joined.index.empty()) {
            data.field.push_back({kPresentOnCells + joined.name, presence(joined.index)});
        }
    }
    gather_words(mesh, left_out, data.field);
    return data;
}

void attach_vtk_data(const CellList& cells, VtkData data, Mesh& mesh) {
    for (NamedArray& array : data.points) {
        std::vector<Index> index = apply_presence(data, kPresentOnPoints, array);
        add_attribute(mesh, array.name, Place::point, std::move(array.values), std::move(index));
    }
    std::vector<CellData> on_cells;
    for (NamedArray& array : data.cells) {
        std::vector<Index> index = apply_presence(data, kPresentOnCells, array);
        on_cells.push_back({array.name, std::move(array.values), std::move(index)});
    }
    split_cells(cells, std::move(on_cells), mesh);
    for (NamedArray& array : data.field) {
        if (is_presence(array) || take_words(array, mesh)) continue;
        add_attribute(mesh, array.name, Place::mesh, std::move(array.values));
    }
}

Result<Array> as_positions(Array values) {
    if (is_float(values.scalar)) return values;
    constexpr std::int64_t kExact = std::int64_t{1} << 53;
    Array positions = make_array(Scalar::f64, values.arity, values.count());
    const std::span<double> reals = positions.as<double>();
    for (std::size_t i = 0; i < reals.size(); ++i) {
        std::int64_t whole = 0;
        if (!integer_at(values, i, whole) || whole > kExact || whole < -kExact) {
            return Error{Code::unreadable, i,
                         "coordinate " + std::to_string(i) + " is too large an integer"};
        }
        reals[i] = static_cast<double>(whole);
    }
    return positions;
}

std::optional<std::string> vtk_fault(const CellList& cells, const Mesh& mesh) {
    const bool gmsh_order = find_note(mesh, kGmshNodeOrder) != nullptr;
    for (Index c = 0; c < cells.count(); ++c) {
        if (gmsh_order && !same_order_in_gmsh(cells.types[c])) {
            return "higher-order cells whose nodes are in Gmsh's order can't be written";
        }
        if (auto fault = cell_fault(cells.types[c], cells.cell(c).size())) return fault;
    }
    return std::nullopt;
}

}  // namespace ravel::io
