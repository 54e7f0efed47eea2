// Legacy VTK files, versions 2.0 to 5.1, text and binary: unstructured grids and polygonal data.
#include <algorithm>

#include "io/attributes.h"
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/typed_values.h"
#include "io/vtk_cells.h"
#include "io/vtk_legacy.h"

namespace ravel::io {

namespace {

// One CELLS (VERTICES, LINES, POLYGONS) section: offsets, and nodes that may be out of range still.
struct Connectivity {
    std::vector<Index> begin{0};
    std::vector<Index> nodes;
    Index count() const { return begin.size() - 1; }
};

struct Geometry {
    Index points = 0;
    bool has_points = false;
    Connectivity cells;
    VtkArray cell_types;
    // Polygonal data: the kinds of cells come in this order whatever the order in the file is.
    Connectivity vertices, lines, polygons, strips;
};

Result<std::vector<Index>> indices_of(VtkLegacy& file, const VtkArray& array,
                                      const std::string& what) {
    Result<std::vector<Index>> indices = as_indices(array.values);
    if (!indices) return error_at(file, array, indices.error().at, what + " is no index");
    return indices;
}

Status check_nodes(VtkLegacy& file, const VtkArray& array, std::span<const Index> nodes,
                   Index first, Index points) {
    for (Index i = 0; i < nodes.size(); ++i) {
        if (nodes[i] >= points) {
            return error_at(file, array, first + i,
                            "a cell uses point " + std::to_string(nodes[i]) +
                                ", but there are only " + std::to_string(points));
        }
    }
    return Done{};
}

// Up to version 4: each cell's node count and then its nodes, all in one array of 32-bit integers.
Status read_counted_cells(VtkLegacy& file, Index count, Index size, Index points,
                          Connectivity& cells) {
    // In text any width is read, for there are writers of large files.
    Result<VtkArray> array =
        read_vtk_array(file, file.binary ? "int" : "vtktypeint64", 1, size, "the cells");
    if (!array) return array.error();
    Result<std::vector<Index>> numbers = indices_of(file, *array, "this number in the cells");
    if (!numbers) return numbers.error();
    Index at = 0;
    for (Index c = 0; c < count; ++c) {
        if (at >= numbers->size() || (*numbers)[at] > numbers->size() - at - 1) {
            return error_at(file, *array, std::min<Index>(at, size == 0 ? 0 : size - 1),
                            "cell " + std::to_string(c) + " reaches beyond the " +
                                std::to_string(size) + " numbers announced");
        }
        const std::span<const Index> nodes = std::span(*numbers).subspan(at + 1, (*numbers)[at]);
        Status inside = check_nodes(file, *array, nodes, at + 1, points);
        if (!inside) return inside;
        cells.nodes.insert(cells.nodes.end(), nodes.begin(), nodes.end());
        cells.begin.push_back(cells.nodes.size());
        at += nodes.size() + 1;
    }
    if (at != numbers->size()) {
        return error_at(file, *array, at, "there are more numbers than the cells need");
    }
    return Done{};
}

Result<VtkArray> read_named_integers(VtkLegacy& file, std::string_view keyword, Index count) {
    if (!same_word(file.text.word(), keyword)) return file.text.expected(std::string(keyword));
    const std::string_view type = file.text.line_word();
    const std::optional<VtkScalar> scalar = vtk_scalar(type);
    if (!scalar || is_float(scalar->scalar)) return file.text.expected("an integer type");
    return read_vtk_array(file, type, 1, count, std::string(keyword));
}

// From version 5 on: an array of offsets and one of nodes.
Status read_offset_cells(VtkLegacy& file, Index offset_count, Index node_count, Index points,
                         Connectivity& cells) {
    Result<VtkArray> offsets = read_named_integers(file, "OFFSETS", offset_count);
    if (!offsets) return offsets.error();
    Result<std::vector<Index>> begin = indices_of(file, *offsets, "this offset");
    if (!begin) return begin.error();
    for (Index i = 0; i < begin->size(); ++i) {
        const Index expected_least = i == 0 ? 0 : (*begin)[i - 1];
        if ((*begin)[i] < expected_least || (i == 0 && (*begin)[0] != 0) ||
            (*begin)[i] > node_count) {
            return error_at(file, *offsets, i, "offsets must ascend from 0 to the number of nodes");
        }
    }
    if (!begin->empty() && begin->back() != node_count) {
        return error_at(file, *offsets, begin->size() - 1,
                        "the last offset is not the number of nodes");
    }
    Result<VtkArray> array = read_named_integers(file, "CONNECTIVITY", node_count);
    if (!array) return array.error();
    Result<std::vector<Index>> nodes = indices_of(file, *array, "this node");
    if (!nodes) return nodes.error();
    Status inside = check_nodes(file, *array, *nodes, 0, points);
    if (!inside) return inside;
    if (begin->empty()) {
        if (node_count != 0) return file.text.error("there are nodes but no offsets");
        return Done{};
    }
    cells.begin = std::move(*begin);
    cells.nodes = std::move(*nodes);
    return Done{};
}

Status read_connectivity(VtkLegacy& file, const Geometry& geometry, Connectivity& cells) {
    Index first = 0, second = 0;
    if (!geometry.has_points) return file.text.error("cells come before POINTS");
    if (cells.count() != 0) return file.text.error("a second section of the same cells");
    if (!file.text.read_in_line(first) || !file.text.read_in_line(second)) {
        return file.text.expected("the number of cells and of numbers");
    }
    return file.has_offsets ? read_offset_cells(file, first, second, geometry.points, cells)
                            : read_counted_cells(file, first, second, geometry.points, cells);
}

Status read_points(VtkLegacy& file, Geometry& geometry, Mesh& mesh) {
    if (geometry.has_points) return file.text.error("a second POINTS section");
    Index count = 0;
    if (!file.text.read_in_line(count)) return file.text.expected("the number of points");
    const std::string_view type = file.text.line_word();
    Result<VtkArray> array = read_vtk_array(file, type, 3, count, "the points");
    if (!array) return array.error();
    Result<Array> positions = as_positions(array->values);
    if (!positions) {
        return error_at(file, *array, positions.error().at, positions.error().detail);
    }
    mesh.positions = std::move(*positions);
    geometry.points = count;
    geometry.has_points = true;
    return Done{};
}

Status read_cell_types(VtkLegacy& file, Geometry& geometry) {
    Index count = 0;
    if (!file.text.read_in_line(count)) return file.text.expected("the number of cell types");
    Result<VtkArray> types = read_vtk_array(file, "int", 1, count, "the cell types");
    if (!types) return types.error();
    geometry.cell_types = std::move(*types);
    return Done{};
}

// Reads the sections up to the first POINT_DATA or CELL_DATA (or the end).
Status read_geometry(VtkLegacy& file, bool polydata, Geometry& geometry, VtkData& data,
                     Mesh& mesh) {
    while (true) {
        const std::size_t here = file.text.offset();
        const std::string_view keyword = file.text.word();
        Status status = Done{};
        if (keyword.empty() || same_word(keyword, "POINT_DATA") ||
            same_word(keyword, "CELL_DATA")) {
            file.text.seek(here);
            return status;
        }
        if (same_word(keyword, "METADATA")) {
            skip_vtk_metadata(file);
        } else if (same_word(keyword, "FIELD")) {
            status = read_vtk_field(file, data.field, std::nullopt);
        } else if (same_word(keyword, "POINTS")) {
            status = read_points(file, geometry, mesh);
        } else if (!polydata && same_word(keyword, "CELLS")) {
            status = read_connectivity(file, geometry, geometry.cells);
        } else if (!polydata && same_word(keyword, "CELL_TYPES")) {
            status = read_cell_types(file, geometry);
        } else if (polydata && same_word(keyword, "VERTICES")) {
            status = read_connectivity(file, geometry, geometry.vertices);
        } else if (polydata && same_word(keyword, "LINES")) {
            status = read_connectivity(file, geometry, geometry.lines);
        } else if (polydata && same_word(keyword, "POLYGONS")) {
            status = read_connectivity(file, geometry, geometry.polygons);
        } else if (polydata && same_word(keyword, "TRIANGLE_STRIPS")) {
            status = read_connectivity(file, geometry, geometry.strips);
        } else {
            return file.text.expected("a section such as POINTS, CELLS or POINT_DATA");
        }
        if (!status) return status;
    }
}

Result<CellList> grid_cells(VtkLegacy& file, const Geometry& geometry) {
    CellList list;
    const Array& types = geometry.cell_types.values;
    if (types.count() != geometry.cells.count()) {
        return file.text.error("there are " + std::to_string(geometry.cells.count()) +
                               " cells, but " + std::to_string(types.count()) + " cell types");
    }
    for (Index c = 0; c < geometry.cells.count(); ++c) {
        const auto nodes = std::span(geometry.cells.nodes)
                               .subspan(geometry.cells.begin[c],
                                        geometry.cells.begin[c + 1] - geometry.cells.begin[c]);
        const auto type = static_cast<std::uint32_t>(types.as<std::int32_t>()[c]);
        if (const auto fault = cell_fault(type, nodes.size())) {
            return error_at(file, geometry.cell_types, c, *fault);
        }
        list.add(static_cast<std::uint16_t>(type), nodes);
    }
    return list;
}

CellList polydata_cells(const Geometry& geometry) {
    CellList list;
    const auto add = [&](const Connectivity& cells, auto type_of) {
        for (Index c = 0; c < cells.count(); ++c) {
            const Index size = cells.begin[c + 1] - cells.begin[c];
            list.add(type_of(size), std::span(cells.nodes).subspan(cells.begin[c], size));
        }
    };
    add(geometry.vertices, [](Index n) { return n == 1 ? kVtkVertex : kVtkPolyVertex; });
    add(geometry.lines, [](Index n) { return n == 2 ? kVtkLine : kVtkPolyLine; });
    add(geometry.polygons, [](Index) { return kVtkPolygon; });
    add(geometry.strips, [](Index) { return kVtkStrip; });
    return list;
}

// The four lines at the top. Sets the mode, the title and version notes; tells if it is polygons.
Result<bool> read_header(VtkLegacy& file, Mesh& mesh) {
    constexpr std::string_view kMagic = "# vtk DataFile Version";
    const std::string_view first = file.text.rest_of_line();
    if (!first.starts_with(kMagic)) return file.text.error("this is no legacy VTK file");
    TextReader version(first.substr(kMagic.size()), file.text.file());
    const std::string number(version.word());
    double value = 0;
    if (!parse_real(number, value) || !(value >= 1.0) || value >= 6.0) {
        return file.text.error("VTK file version '" + number +
                               "' is not supported; 2.0 to 5.1 are");
    }
    file.has_offsets = value >= 5.0;
    file.text.next_line();
    const std::string title(file.text.rest_of_line());
    const std::string_view mode = file.text.word();
    file.binary = same_word(mode, "BINARY");
    if (!file.binary && !same_word(mode, "ASCII")) return file.text.expected("ASCII or BINARY");
    if (!same_word(file.text.word(), "DATASET")) return file.text.expected("DATASET");
    const std::string dataset(file.text.word());
    const bool polydata = same_word(dataset, "POLYDATA");
    if (!polydata && !same_word(dataset, "UNSTRUCTURED_GRID")) {
        return file.text.error("DATASET " + dataset +
                               " is not supported; UNSTRUCTURED_GRID and POLYDATA are");
    }
    if (number != kVtkVersion) mesh.notes.push_back({"vtk:version", number});
    if (title != kVtkTitle) mesh.notes.push_back({"vtk:title", title});
    if (polydata) mesh.notes.push_back({"vtk:dataset", "POLYDATA"});
    return polydata;
}

}  // namespace

Result<Mesh> read_vtk(const std::string& path) {
    const Result<std::string> bytes = read_file(path);
    if (!bytes) return bytes.error();
    VtkLegacy file{TextReader(*bytes, path, {'\0', false}), false, false};
    Mesh mesh;
    const Result<bool> polydata = read_header(file, mesh);
    if (!polydata) return polydata.error();
    Geometry geometry;
    VtkData data;
    if (Status status = read_geometry(file, *polydata, geometry, data, mesh); !status) {
        return status.error();
    }
    const std::size_t data_at = file.text.offset();
    Result<CellList> cells =
        *polydata ? Result<CellList>(polydata_cells(geometry)) : grid_cells(file, geometry);
    if (!cells) return cells.error();
    file.text.seek(data_at);
    Status status = read_vtk_attributes(file, geometry.points, cells->count(), data);
    if (!status) return status.error();
    attach_vtk_data(*cells, std::move(data), mesh);
    return mesh;
}

}  // namespace ravel::io
