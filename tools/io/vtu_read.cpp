// VTU files (VTK's XML unstructured grids): text, base64 and appended data, compressed or not.
// The pieces of a file become one mesh.
#include <algorithm>
#include <cstring>
#include <pugixml.hpp>

#include "io/attributes.h"
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/typed_values.h"
#include "io/vtk_cells.h"
#include "io/vtk_data.h"
#include "io/vtu_bytes.h"
#include "io/vtu_types.h"

namespace ravel::io {

namespace {

struct VtuFile {
    std::string path;
    std::string_view bytes;
    std::string_view appended;  // what follows the '_'
    bool appended_base64 = false;
    VtuCoding coding;
};

// What the pieces have in common, filled piece by piece.
struct Grid {
    Index points = 0;
    std::vector<Array> positions;
    CellList cells;
    VtkData data;
};

Error error_at(const VtuFile& file, const pugi::xml_node& node, const std::string& sentence) {
    const std::ptrdiff_t offset = node.offset_debug();
    TextReader text(file.bytes, file.path, {'\0', false});
    text.seek(offset < 0 ? 0 : std::min(static_cast<std::size_t>(offset), file.bytes.size()));
    return text.error(sentence);
}

std::string name_of_array(const pugi::xml_node& array) {
    return "'" + std::string(array.attribute("Name").value()) + "'";
}

// A count in an attribute; absent is `otherwise`.
Result<Index> read_count(const VtuFile& file, const pugi::xml_node& node, const char* name,
                         Index otherwise) {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute) return otherwise;
    Index count = 0;
    TextReader word(attribute.value(), file.path);
    if (!word.read(count)) {
        return error_at(file, node,
                        std::string(name) + "=\"" + attribute.value() + "\" is no count");
    }
    return count;
}

// The text between the tags, as a place in the file, so that errors can name its line.
Result<std::string_view> text_of(const VtuFile& file, const pugi::xml_node& array,
                                 std::size_t& start) {
    const pugi::xml_node text = array.first_child();
    if (!text) return std::string_view{};
    const std::ptrdiff_t offset = text.offset_debug();
    if (offset < 0 || static_cast<std::size_t>(offset) > file.bytes.size()) {
        return error_at(file, array, "only UTF-8 files are supported");
    }
    start = static_cast<std::size_t>(offset);
    const std::size_t end = std::min(file.bytes.find('<', start), file.bytes.size());
    return file.bytes.substr(start, end - start);
}

Result<Array> read_text_array(const VtuFile& file, const pugi::xml_node& node, Scalar scalar,
                              std::uint32_t arity) {
    std::size_t start = 0;
    const Result<std::string_view> inside = text_of(file, node, start);
    if (!inside) return inside.error();
    TextReader counter(*inside, file.path, {'\0', false});
    Index words = 0;
    while (!counter.word().empty()) ++words;
    if (words % arity != 0) {
        return error_at(file, node,
                        "array " + name_of_array(node) + " has " + std::to_string(words) +
                            " values, no multiple of its " + std::to_string(arity) + " components");
    }
    TextReader text(file.bytes.substr(0, start + inside->size()), file.path, {'\0', false});
    text.seek(start);
    return read_values(text, scalar, arity, words / arity, name_of_array(node));
}

Result<Array> read_binary_array(const VtuFile& file, const pugi::xml_node& node, Scalar scalar,
                                std::uint32_t arity, bool appended) {
    std::size_t start = 0;
    std::string_view place;
    if (appended) {
        const Result<Index> offset = read_count(file, node, "offset", kNoIndex);
        if (!offset) return offset.error();
        if (*offset > file.appended.size()) {
            return error_at(file, node,
                            "the offset of array " + name_of_array(node) +
                                " is missing or beyond the appended data");
        }
        place = file.appended.substr(*offset);
    } else {
        const Result<std::string_view> inside = text_of(file, node, start);
        if (!inside) return inside.error();
        place = *inside;
    }
    const bool base64 = !appended || file.appended_base64;
    Result<std::string> bytes = read_vtu_bytes(VtuSource(place, base64), file.coding);
    if (!bytes) {
        const std::string sentence = "array " + name_of_array(node) + ": " + bytes.error().detail;
        if (!appended) return error_at(file, node, sentence);
        return byte_error(file.path, static_cast<std::size_t>(place.data() - file.bytes.data()),
                          sentence);
    }
    Array array{scalar, arity, {}};
    if (bytes->size() % array.stride() != 0) {
        return error_at(file, node,
                        "array " + name_of_array(node) + " has " + std::to_string(bytes->size()) +
                            " bytes, no multiple of its tuples' " + std::to_string(array.stride()));
    }
    array.bytes.resize(bytes->size());
    if (!bytes->empty()) std::memcpy(array.bytes.data(), bytes->data(), bytes->size());
    if (file.coding.big_endian) swap_bytes(array.bytes, size_of(scalar));
    return array;
}

Result<Array> read_array(const VtuFile& file, const pugi::xml_node& node) {
    const std::optional<Scalar> scalar = vtu_scalar(node.attribute("type").value());
    if (!scalar) {
        return error_at(file, node,
                        "array " + name_of_array(node) + " is of type '" +
                            node.attribute("type").value() + "', which is not supported");
    }
    const Result<Index> arity = read_count(file, node, "NumberOfComponents", 1);
    if (!arity) return arity.error();
    if (*arity == 0 || *arity > 1U << 20) {
        return error_at(file, node, "NumberOfComponents must be from 1 to 1048576");
    }
    const auto components = static_cast<std::uint32_t>(*arity);
    const std::string_view format = node.attribute("format").as_string("ascii");
    if (format == "ascii") return read_text_array(file, node, *scalar, components);
    if (format == "binary" || format == "appended") {
        return read_binary_array(file, node, *scalar, components, format == "appended");
    }
    return error_at(file, node, "format \"" + std::string(format) + "\" is unknown");
}

// All arrays of a PointData, CellData or FieldData element; `tuples` is what they must have.
Result<std::vector<NamedArray>> read_arrays(const VtuFile& file, const pugi::xml_node& parent,
                                            std::optional<Index> tuples) {
    std::vector<NamedArray> arrays;
    for (const pugi::xml_node& node : parent.children()) {
        const std::string_view element = node.name();
        if (node.type() != pugi::node_element) continue;
        if (element != "DataArray" && element != "Array") {
            return error_at(file, node, "<" + std::string(element) + "> is not expected here");
        }
        Result<Array> array = read_array(file, node);
        if (!array) return array.error();
        if (tuples && array->count() != *tuples) {
            return error_at(file, node,
                            "array " + name_of_array(node) + " has " +
                                std::to_string(array->count()) + " tuples where " +
                                std::to_string(*tuples) + " are needed");
        }
        arrays.push_back({node.attribute("Name").value(), std::move(*array)});
    }
    return arrays;
}

// Appends the arrays of a further piece to those of the first, which must be the same.
Status join_arrays(const VtuFile& file, const pugi::xml_node& node, bool first,
                   std::vector<NamedArray>& all, std::vector<NamedArray> more) {
    if (first) {
        all = std::move(more);
        return Done{};
    }
    bool same = all.size() == more.size();
    for (std::size_t i = 0; same && i < all.size(); ++i) {
        const Array& a = all[i].values;
        const Array& b = more[i].values;
        same = all[i].name == more[i].name && a.scalar == b.scalar && a.arity == b.arity;
        if (!same) break;
        all[i].values.bytes.insert(all[i].values.bytes.end(), b.bytes.begin(), b.bytes.end());
    }
    if (!same) return error_at(file, node, "the arrays of this piece are not those of the first");
    return Done{};
}

Result<std::vector<Index>> read_indices(const VtuFile& file, const pugi::xml_node& cells,
                                        const char* name, std::optional<Index> count) {
    const pugi::xml_node node = cells.find_child_by_attribute("DataArray", "Name", name);
    if (!node) {
        if (count == Index{0} || !count) return std::vector<Index>{};
        return error_at(file, cells, "the cells have no array '" + std::string(name) + "'");
    }
    const Result<Array> array = read_array(file, node);
    if (!array) return array.error();
    Result<std::vector<Index>> indices = as_indices(*array);
    if (!indices) {
        return error_at(file, node, "array '" + std::string(name) + "': " + indices.error().detail);
    }
    if (count && indices->size() != *count) {
        return error_at(file, node,
                        "array '" + std::string(name) + "' has " + std::to_string(indices->size()) +
                            " values where " + std::to_string(*count) + " are needed");
    }
    return indices;
}

Status read_cells(const VtuFile& file, const pugi::xml_node& piece, Index points, Index count,
                  Grid& grid) {
    const pugi::xml_node cells = piece.child("Cells");
    const Result<std::vector<Index>> ends = read_indices(file, cells, "offsets", count);
    if (!ends) return ends.error();
    const Result<std::vector<Index>> types = read_indices(file, cells, "types", count);
    if (!types) return types.error();
    Result<std::vector<Index>> nodes = read_indices(file, cells, "connectivity", std::nullopt);
    if (!nodes) return nodes.error();
    for (Index& node : *nodes) {
        if (node >= points) {
            return error_at(file, cells,
                            "a cell uses point " + std::to_string(node) +
                                ", but the piece has only " + std::to_string(points));
        }
        node += grid.points;
    }
    Index begin = 0;
    for (Index c = 0; c < count; ++c) {
        const Index end = (*ends)[c];
        if (end < begin || end > nodes->size()) {
            return error_at(file, cells,
                            "the offsets of the cells must ascend and stay within " +
                                std::to_string(nodes->size()) + " nodes; that of cell " +
                                std::to_string(c) + " is " + std::to_string(end));
        }
        if (const auto fault = cell_fault((*types)[c], end - begin)) {
            return error_at(file, cells, *fault + " (cell " + std::to_string(c) + ")");
        }
        grid.cells.add(static_cast<std::uint16_t>((*types)[c]),
                       std::span(*nodes).subspan(begin, end - begin));
        begin = end;
    }
    if (begin != nodes->size()) {
        return error_at(file, cells, "there are more nodes than the cells use");
    }
    return Done{};
}

Status read_piece(const VtuFile& file, const pugi::xml_node& piece, bool first, Grid& grid) {
    const Result<Index> points = read_count(file, piece, "NumberOfPoints", 0);
    if (!points) return points.error();
    const Result<Index> cells = read_count(file, piece, "NumberOfCells", 0);
    if (!cells) return cells.error();
    const pugi::xml_node node = piece.child("Points").child("DataArray");
    if (node) {
        Result<Array> array = read_array(file, node);
        if (!array) return array.error();
        if (array->arity != 3 || array->count() != *points) {
            return error_at(file, node,
                            "the points are not " + std::to_string(*points) + " tuples of 3");
        }
        Result<Array> positions = as_positions(std::move(*array));
        if (!positions) return error_at(file, node, positions.error().detail);
        grid.positions.push_back(std::move(*positions));
    } else if (*points != 0) {
        return error_at(file, piece, "the piece has no array of points");
    }
    if (Status status = read_cells(file, piece, *points, *cells, grid); !status) return status;
    const pugi::xml_node on_points = piece.child("PointData");
    Result<std::vector<NamedArray>> arrays = read_arrays(file, on_points, *points);
    if (!arrays) return arrays.error();
    Status joined = join_arrays(file, piece, first, grid.data.points, std::move(*arrays));
    if (!joined) return joined;
    arrays = read_arrays(file, piece.child("CellData"), *cells);
    if (!arrays) return arrays.error();
    joined = join_arrays(file, piece, first, grid.data.cells, std::move(*arrays));
    if (!joined) return joined;
    grid.points += *points;
    return Done{};
}

// float64 if any piece has it; float32 values are float64 values, too.
Array join_positions(const std::vector<Array>& parts) {
    const bool wide = std::any_of(parts.begin(), parts.end(),
                                  [](const Array& part) { return part.scalar == Scalar::f64; });
    Array joined{wide ? Scalar::f64 : Scalar::f32, 3, {}};
    for (const Array& part : parts) {
        if (part.scalar == joined.scalar) {
            joined.bytes.insert(joined.bytes.end(), part.bytes.begin(), part.bytes.end());
            continue;
        }
        const std::span<const float> narrow = part.as<float>();
        const Array wider = array_of(std::vector<double>(narrow.begin(), narrow.end()), 3);
        joined.bytes.insert(joined.bytes.end(), wider.bytes.begin(), wider.bytes.end());
    }
    return joined;
}

// The attributes of <VTKFile>: byte order, header type and compressor.
Status read_coding(VtuFile& file, const pugi::xml_node& root) {
    const std::string_view order = root.attribute("byte_order").as_string("LittleEndian");
    if (order != "LittleEndian" && order != "BigEndian") {
        return error_at(file, root, "byte_order \"" + std::string(order) + "\" is unknown");
    }
    file.coding.big_endian = order == "BigEndian";
    const std::string_view header = root.attribute("header_type").as_string("UInt32");
    if (header != "UInt32" && header != "UInt64") {
        return error_at(file, root, "header_type \"" + std::string(header) + "\" is unknown");
    }
    file.coding.header_64 = header == "UInt64";
    const std::string_view compressor = root.attribute("compressor").as_string("");
    if (compressor == "vtkZLibDataCompressor")
        file.coding.compressor = VtuCompressor::zlib;
    else if (compressor == "vtkLZ4DataCompressor")
        file.coding.compressor = VtuCompressor::lz4;
    else if (compressor == "vtkLZMADataCompressor")
        file.coding.compressor = VtuCompressor::lzma;
    else if (!compressor.empty()) {
        return error_at(file, root, "compressor \"" + std::string(compressor) + "\" is unknown");
    }
    return Done{};
}

// Cuts the appended data off, for it may be no XML; the cut file gets its end back.
Result<std::string> cut_appended(VtuFile& file) {
    const std::size_t tag = file.bytes.find("<AppendedData");
    if (tag == std::string_view::npos) return std::string(file.bytes);
    const std::size_t close = file.bytes.find('>', tag);
    const std::size_t mark = close == std::string_view::npos ? close : file.bytes.find('_', close);
    if (mark == std::string_view::npos) {
        return byte_error(file.path, tag, "<AppendedData> has no '_' that begins the data");
    }
    const std::string_view attributes = file.bytes.substr(tag, close - tag);
    file.appended_base64 = attributes.find("base64") != std::string_view::npos;
    file.appended = file.bytes.substr(mark + 1);
    return std::string(file.bytes.substr(0, tag)) + "</VTKFile>";
}

}  // namespace

Result<Mesh> read_vtu(const std::string& path) {
    const Result<std::string> bytes = read_file(path);
    if (!bytes) return bytes.error();
    VtuFile file{path, *bytes, {}, false, {}};
    if (file.bytes.starts_with("\xEF\xBB\xBF")) file.bytes.remove_prefix(3);
    const Result<std::string> xml = cut_appended(file);
    if (!xml) return xml.error();
    pugi::xml_document document;
    const pugi::xml_parse_result parsed =
        document.load_buffer(xml->data(), xml->size(), pugi::parse_default, pugi::encoding_utf8);
    if (!parsed) {
        TextReader text(file.bytes, path, {'\0', false});
        text.seek(std::min(static_cast<std::size_t>(parsed.offset), file.bytes.size()));
        return text.error(std::string("the XML is broken: ") + parsed.description());
    }
    const pugi::xml_node root = document.child("VTKFile");
    if (!root) return error_at(file, document, "this is no VTK XML file");
    if (Status status = read_coding(file, root); !status) return status.error();
    const pugi::xml_node unstructured = root.child("UnstructuredGrid");
    if (!unstructured) {
        return error_at(file, root,
                        "a VTK XML file of type \"" + std::string(root.attribute("type").value()) +
                            "\" is not supported; UnstructuredGrid is");
    }
    Grid grid;
    Result<std::vector<NamedArray>> field =
        read_arrays(file, unstructured.child("FieldData"), std::nullopt);
    if (!field) return field.error();
    grid.data.field = std::move(*field);
    bool first = true;
    for (const pugi::xml_node& piece : unstructured.children("Piece")) {
        if (Status status = read_piece(file, piece, first, grid); !status) return status.error();
        first = false;
    }
    Mesh mesh;
    mesh.positions = join_positions(grid.positions);
    attach_vtk_data(grid.cells, std::move(grid.data), mesh);
    return mesh;
}

}  // namespace ravel::io
