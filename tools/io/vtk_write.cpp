// Legacy VTK files: the version, title and kind of dataset that were read, 4.2 and an unstructured
// grid for other meshes.
#include <algorithm>

#include "io/attributes.h"
#include "io/decimals.h"
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/left_out.h"
#include "io/typed_values.h"
#include "io/vtk_cells.h"
#include "io/vtk_legacy.h"

namespace ravel::io {

namespace {

struct Writing {
    std::string out;
    bool binary = false;
    bool version_5 = false;
};

void put_array(Writing& file, const Array& values, std::size_t per_line) {
    if (!file.binary) {
        append_values(file.out, values, per_line);
        return;
    }
    std::vector<std::byte> bytes = values.bytes;
    swap_bytes(bytes, size_of(values.scalar));
    file.out.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    file.out += '\n';
}

void put_line(Writing& file, std::string_view keyword, Index first) {
    file.out += keyword;
    file.out += ' ';
    append_number(file.out, first);
    file.out += '\n';
}

void put_line(Writing& file, std::string_view keyword, Index first, Index second) {
    file.out += keyword;
    file.out += ' ';
    append_number(file.out, first);
    file.out += ' ';
    append_number(file.out, second);
    file.out += '\n';
}

// The cells [first, last) of the list as one section.
void put_cells(Writing& file, std::string_view keyword, const CellList& list, Index first,
               Index last) {
    const Index nodes = list.begin[last] - list.begin[first];
    const Index count = last - first;
    if (file.version_5) {
        put_line(file, keyword, count + 1, nodes);
        std::vector<std::int64_t> offsets, points;
        for (Index c = first; c <= last; ++c) {
            offsets.push_back(static_cast<std::int64_t>(list.begin[c] - list.begin[first]));
        }
        points.assign(list.nodes.begin() + static_cast<std::ptrdiff_t>(list.begin[first]),
                      list.nodes.begin() + static_cast<std::ptrdiff_t>(list.begin[last]));
        file.out += "OFFSETS vtktypeint64\n";
        put_array(file, array_of(offsets, 1), 1);
        file.out += "CONNECTIVITY vtktypeint64\n";
        put_array(file, array_of(points, 1), 8);
        return;
    }
    put_line(file, keyword, count, nodes + count);
    std::vector<std::int32_t> numbers;
    for (Index c = first; c < last; ++c) {
        const std::span<const Index> cell = list.cell(c);
        const std::size_t start = numbers.size();
        numbers.push_back(static_cast<std::int32_t>(cell.size()));
        for (const Index point : cell) numbers.push_back(static_cast<std::int32_t>(point));
        if (!file.binary) {
            for (std::size_t i = start; i < numbers.size(); ++i) {
                append_number(file.out, numbers[i]);
                file.out += i + 1 < numbers.size() ? ' ' : '\n';
            }
            numbers.clear();
        }
    }
    if (file.binary) put_array(file, array_of(numbers, 1), 1);
}

void put_types(Writing& file, const CellList& list) {
    put_line(file, "CELL_TYPES", list.count());
    put_array(file, array_of(std::vector<std::int32_t>(list.types.begin(), list.types.end()), 1),
              1);
}

void put_field(Writing& file, const std::vector<NamedArray>& arrays) {
    file.out += "FIELD FieldData ";
    append_number(file.out, arrays.size());
    file.out += '\n';
    for (const NamedArray& array : arrays) {
        file.out += encode_vtk_name(array.name) + ' ';
        append_number(file.out, array.values.arity);
        file.out += ' ';
        append_number(file.out, array.values.count());
        file.out += std::string(" ") + vtk_scalar_name(array.values.scalar, file.version_5) + '\n';
        put_array(file, array.values, 1);
    }
}

// Legacy files can't say arrays without a name.
void drop_nameless(std::vector<NamedArray>& arrays, LeftOut& left_out) {
    const auto nameless = [](const NamedArray& array) {
        return array.name.empty() || array.values.arity == 0;
    };
    if (std::any_of(arrays.begin(), arrays.end(), nameless)) {
        left_out.say("legacy VTK has no place for arrays without a name or without components");
    }
    std::erase_if(arrays, nameless);
}

// In polygonal data vertices come first, then lines, polygons and strips. The mesh's cells are the
// list's first; whether the companions can be put around them and be found again in their order.
struct PolydataRanges {
    Index polygons = 0, vertices_end = 0, lines_end = 0;
};
bool fits_polydata(const CellList& list, const Mesh& mesh, PolydataRanges& ranges) {
    const Note* note = find_note(mesh, "vtk:dataset");
    if (!note || note->text != "POLYDATA" || mesh.kind != CellKind::polygon) return false;
    const auto rank = [](std::uint16_t type) {
        switch (type) {
            case kVtkVertex:
            case kVtkPolyVertex:
                return 0;
            case kVtkLine:
            case kVtkPolyLine:
                return 1;
            case kVtkStrip:
                return 2;
            default:
                return 3;
        }
    };
    ranges.polygons = ranges.vertices_end = ranges.lines_end = mesh.cell_count();
    int last = 0;
    for (Index c = ranges.polygons; c < list.count(); ++c) {
        const int here = rank(list.types[c]);
        const Index size = list.cell(c).size();
        // A poly-vertex of one node would come back as a vertex.
        if (here < last || here == 3 || (list.types[c] == kVtkPolyVertex && size == 1) ||
            (list.types[c] == kVtkPolyLine && size == 2)) {
            return false;
        }
        last = here;
        if (here == 0) ranges.vertices_end = c + 1;
        if (here <= 1) ranges.lines_end = c + 1;
    }
    return true;
}

// The rows of cell data follow the cells: vertices and lines before the polygons.
Array polydata_order(const Array& values, const PolydataRanges& ranges) {
    Array ordered = values;
    const auto at = [&](Index c) {
        return ordered.bytes.begin() + static_cast<std::ptrdiff_t>(c * values.stride());
    };
    std::rotate(at(0), at(ranges.polygons), at(ranges.lines_end));
    return ordered;
}

void put_polydata(Writing& file, const CellList& list, const PolydataRanges& ranges,
                  std::vector<NamedArray>& cell_data, std::vector<NamedArray>& field) {
    if (ranges.vertices_end > ranges.polygons) {
        put_cells(file, "VERTICES", list, ranges.polygons, ranges.vertices_end);
    }
    if (ranges.lines_end > ranges.vertices_end) {
        put_cells(file, "LINES", list, ranges.vertices_end, ranges.lines_end);
    }
    put_cells(file, "POLYGONS", list, 0, ranges.polygons);
    if (list.count() > ranges.lines_end) {
        put_cells(file, "TRIANGLE_STRIPS", list, ranges.lines_end, list.count());
    }
    for (NamedArray& array : cell_data) array.values = polydata_order(array.values, ranges);
    for (NamedArray& array : field) {
        if (array.name.starts_with(kPresentOnCells)) {
            array.values = polydata_order(array.values, ranges);
        }
    }
}

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

}  // namespace

Status write_vtk(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                 Sentences* left_out_sentences) {
    Result<CellList> cells = join_cells(mesh, path);
    if (!cells) return cells.error();
    if (const auto fault = vtk_fault(*cells, mesh)) return cannot_hold(path, *fault);

    LeftOut left_out(mesh, "legacy VTK");
    for (std::size_t i = 0; i < mesh.companions.size(); ++i) left_out.take_block(i);
    const Note* version = find_note(mesh, "vtk:version");
    const Note* title = find_note(mesh, "vtk:title");
    constexpr Index kMost = Index{1} << 31;  // up to version 4 cells are 32-bit integers
    const bool large = mesh.point_count() >= kMost || cells->nodes.size() >= kMost;
    double value = 0;
    std::string number = kVtkVersion;
    if (version && parse_real(version->text, value) && value >= 2.0) number = version->text;
    if (large && number < "5") number = "5.1";

    Writing file{{}, options.binary, number >= "5"};
    file.out = "# vtk DataFile Version " + number + '\n' +
               (title ? one_line(title->text) : kVtkTitle) +
               (file.binary ? "\nBINARY\n" : "\nASCII\n");
    PolydataRanges ranges;
    const bool polydata = fits_polydata(*cells, mesh, ranges);
    file.out += polydata ? "DATASET POLYDATA\n" : "DATASET UNSTRUCTURED_GRID\n";

    VtkData data = gather_vtk_data(mesh, left_out);
    for (auto* arrays : {&data.points, &data.cells, &data.field}) drop_nameless(*arrays, left_out);
    Writing cell_part{{}, file.binary, file.version_5};
    if (polydata) {
        put_polydata(cell_part, *cells, ranges, data.cells, data.field);
    } else {
        put_cells(cell_part, "CELLS", *cells, 0, cells->count());
        put_types(cell_part, *cells);
    }
    if (!data.field.empty()) put_field(file, data.field);
    file.out += "POINTS " + std::to_string(mesh.point_count()) + ' ' +
                vtk_scalar_name(mesh.positions.scalar, file.version_5) + '\n';
    put_array(file, mesh.positions, 1);
    file.out += cell_part.out;
    if (!data.points.empty()) {
        put_line(file, "POINT_DATA", mesh.point_count());
        put_field(file, data.points);
    }
    if (!data.cells.empty()) {
        put_line(file, "CELL_DATA", cells->count());
        put_field(file, data.cells);
    }
    left_out.report(left_out_sentences);
    return write_file(path, file.out);
}

}  // namespace ravel::io
