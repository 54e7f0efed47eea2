// VTU files in any of their encodings. A mesh is one piece.
#include <array>

#include "io/attributes.h"
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/left_out.h"
#include "io/typed_values.h"
#include "io/vtk_data.h"
#include "io/vtu_types.h"

namespace ravel::io {

namespace {

constexpr std::array<const char*, 10> kScalarNames = {
    "UInt8", "Int8", "UInt16", "Int16", "UInt32", "Int32", "UInt64", "Int64", "Float32", "Float64"};

struct Writing {
    VtuOptions options;
    std::string out;
    std::string appended;
};

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            case '\n':
                safe += "&#10;";
                break;
            case '\r':
                safe += "&#13;";
                break;
            case '\t':
                safe += "&#9;";
                break;
            default:
                safe += c;
        }
    }
    return safe;
}

std::string compressor_attribute(VtuCompressor compressor) {
    switch (compressor) {
        case VtuCompressor::zlib:
            return " compressor=\"vtkZLibDataCompressor\"";
        case VtuCompressor::lz4:
            return " compressor=\"vtkLZ4DataCompressor\"";
        case VtuCompressor::lzma:
            return " compressor=\"vtkLZMADataCompressor\"";
        case VtuCompressor::none:
            break;
    }
    return "";
}

Status put_array(Writing& file, const std::string& name, const Array& values, bool is_field) {
    std::string& out = file.out;
    out += "<DataArray type=\"";
    out += vtu_scalar_name(values.scalar);
    out += "\" Name=\"" + escaped(name) + "\" NumberOfComponents=\"" +
           std::to_string(values.arity) + '"';
    if (is_field) out += " NumberOfTuples=\"" + std::to_string(values.count()) + '"';
    const std::string_view bytes(reinterpret_cast<const char*>(values.bytes.data()),
                                 values.bytes.size());
    Status status = Done{};
    switch (file.options.encoding) {
        case VtuEncoding::text:
            out += " format=\"ascii\">\n";
            append_values(out, values, values.arity == 1 ? 12 : 1);
            break;
        case VtuEncoding::inline_base64:
            out += " format=\"binary\">\n";
            status = append_vtu_bytes(out, bytes, file.options.coding, true);
            out += '\n';
            break;
        case VtuEncoding::appended_raw:
        case VtuEncoding::appended_base64:
            out += " format=\"appended\" offset=\"" + std::to_string(file.appended.size()) + "\">";
            status = append_vtu_bytes(file.appended, bytes, file.options.coding,
                                      file.options.encoding == VtuEncoding::appended_base64);
            break;
    }
    out += "</DataArray>\n";
    return status;
}

Status put_arrays(Writing& file, const std::string& element, const std::vector<NamedArray>& arrays,
                  LeftOut& left_out) {
    if (arrays.empty()) return Done{};
    file.out += '<' + element + ">\n";
    for (const NamedArray& array : arrays) {
        if (array.values.arity == 0) {
            left_out.say("VTU has no place for arrays without components");
            continue;
        }
        Status status = put_array(file, array.name, array.values, element == "FieldData");
        if (!status) return status;
    }
    file.out += "</" + element + ">\n";
    return Done{};
}

Status put_cells(Writing& file, const CellList& cells) {
    std::vector<std::int64_t> nodes(cells.nodes.begin(), cells.nodes.end());
    std::vector<std::int64_t> ends(cells.begin.begin() + 1, cells.begin.end());
    std::vector<std::uint8_t> types;
    for (const std::uint16_t type : cells.types) types.push_back(static_cast<std::uint8_t>(type));
    file.out += "<Cells>\n";
    Status status = put_array(file, "connectivity", array_of(nodes, 1), false);
    if (status) status = put_array(file, "offsets", array_of(ends, 1), false);
    if (status) status = put_array(file, "types", array_of(types, 1), false);
    file.out += "</Cells>\n";
    return status;
}

Status put_grid(Writing& file, const Mesh& mesh, const CellList& cells, LeftOut& left_out) {
    const VtkData data = gather_vtk_data(mesh, left_out);
    file.out += "<UnstructuredGrid>\n";
    if (Status s = put_arrays(file, "FieldData", data.field, left_out); !s) return s;
    file.out += "<Piece NumberOfPoints=\"" + std::to_string(mesh.point_count()) +
                "\" NumberOfCells=\"" + std::to_string(cells.count()) + "\">\n";
    if (Status s = put_arrays(file, "PointData", data.points, left_out); !s) return s;
    if (Status s = put_arrays(file, "CellData", data.cells, left_out); !s) return s;
    file.out += "<Points>\n";
    if (Status s = put_array(file, "Points", mesh.positions, false); !s) return s;
    file.out += "</Points>\n";
    if (Status s = put_cells(file, cells); !s) return s;
    file.out += "</Piece>\n</UnstructuredGrid>\n";
    return Done{};
}

}  // namespace

std::optional<Scalar> vtu_scalar(std::string_view name) {
    for (std::size_t i = 0; i < kScalarNames.size(); ++i) {
        if (name == kScalarNames[i]) return static_cast<Scalar>(i);
    }
    return std::nullopt;
}

const char* vtu_scalar_name(Scalar scalar) {
    return kScalarNames[static_cast<std::size_t>(scalar)];
}

Status write_vtu_as(const Mesh& mesh, const std::string& path, const VtuOptions& options,
                    Sentences* left_out_sentences) {
    const Result<CellList> cells = join_cells(mesh, path);
    if (!cells) return cells.error();
    if (const auto fault = vtk_fault(*cells, mesh)) return cannot_hold(path, *fault);
    LeftOut left_out(mesh, "VTU");
    for (std::size_t i = 0; i < mesh.companions.size(); ++i) left_out.take_block(i);
    Writing file{options, {}, {}};
    const bool text = options.encoding == VtuEncoding::text;
    file.out =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" header_type=\"";
    file.out += options.coding.header_64 ? "UInt64\"" : "UInt32\"";
    if (!text) file.out += compressor_attribute(options.coding.compressor);
    file.out += ">\n";
    if (Status status = put_grid(file, mesh, *cells, left_out); !status) {
        return cannot_hold(path, status.error().detail);
    }
    const bool base64 = options.encoding == VtuEncoding::appended_base64;
    if (base64 || options.encoding == VtuEncoding::appended_raw) {
        file.out +=
            base64 ? "<AppendedData encoding=\"base64\">\n_" : "<AppendedData encoding=\"raw\">\n_";
        file.out += file.appended;
        file.out += "\n</AppendedData>\n";
    }
    file.out += "</VTKFile>\n";
    left_out.report(left_out_sentences);
    return write_file(path, file.out);
}

Status write_vtu(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                 Sentences* left_out) {
    VtuOptions encoding;
    if (options.binary) {
        encoding.encoding = VtuEncoding::appended_raw;
        encoding.coding = {VtuCompressor::zlib, true, false};
    }
    return write_vtu_as(mesh, path, encoding, left_out);
}

}  // namespace ravel::io
