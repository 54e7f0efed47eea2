// Polygon file format, from columns to bytes; binary is little-endian.
#include <cstring>

#include "io/attributes.h"
#include "io/decimals.h"
#include "io/file_bytes.h"
#include "io/ply_file.h"

namespace ravel::io {

namespace {

const char* ply_name(Scalar scalar) {
    switch (scalar) {
        case Scalar::u8:
            return "uchar";
        case Scalar::i8:
            return "char";
        case Scalar::u16:
            return "ushort";
        case Scalar::i16:
            return "short";
        case Scalar::u32:
            return "uint";
        case Scalar::i32:
            return "int";
        case Scalar::f32:
            return "float";
        case Scalar::f64:
            return "double";
        case Scalar::u64:
            return "uint64";  // beyond the format's first description, but usual
        case Scalar::i64:
            return "int64";
    }
    return "uchar";
}

void append_header(std::string& out, const PlyFile& file, bool binary) {
    out += "ply\nformat ";
    out += binary ? "binary_little_endian" : "ascii";
    out += " 1.0\n";
    for (const Note& note : file.notes) {
        out += note.key == "ply:obj_info" ? "obj_info" : "comment";
        if (!note.text.empty()) out += ' ';
        out += note.text;
        out += '\n';
    }
    for (const PlyElement& element : file.elements) {
        out += "element " + element.name + " " + std::to_string(element.count) + "\n";
        for (const PlyProperty& property : element.properties) {
            out += "property ";
            if (property.is_list) out += "list " + std::string(ply_name(property.count_type)) + " ";
            out += ply_name(property.type);
            out += " " + property.name + "\n";
        }
    }
    out += "end_header\n";
}

void append_raw(std::string& out, const Array& values, Index first, Index count) {
    const std::size_t size = size_of(values.scalar);
    out.append(reinterpret_cast<const char*>(values.bytes.data()) + first * size, count * size);
}

void append_row(std::string& out, const PlyElement& element, Index row, bool binary) {
    bool first_word = true;
    const auto space = [&] {
        if (!first_word) out += ' ';
        first_word = false;
    };
    for (const PlyProperty& property : element.properties) {
        Index first = row, count = 1;
        if (property.is_list) {
            first = property.begin[row];
            count = property.begin[row + 1] - first;
            if (binary) {
                // The types are little-endian, so the low bytes of the count come first.
                out.append(reinterpret_cast<const char*>(&count), size_of(property.count_type));
            } else {
                space();
                append_number(out, count);
            }
        }
        if (binary) {
            append_raw(out, property.values, first, count);
            continue;
        }
        with_values(property.values, [&](auto values) {
            for (Index i = first; i < first + count; ++i) {
                space();
                append_number(out, values[i]);
            }
        });
    }
    if (!binary) out += '\n';
}

}  // namespace

Status write_ply_file(const PlyFile& file, const std::string& path, bool binary) {
    std::string out;
    append_header(out, file, binary);
    for (const PlyElement& element : file.elements)
        for (Index row = 0; row < element.count; ++row) append_row(out, element, row, binary);
    return write_file(path, out);
}

}  // namespace ravel::io
