// The data sections of legacy VTK files: SCALARS, VECTORS, FIELD and so on.
#include <array>

#include "io/vtk_legacy.h"

namespace ravel::io {

namespace {

struct Reading {
    VtkLegacy& file;
    VtkData& data;
    std::vector<NamedArray>* into = nullptr;  // what the current POINT_DATA or CELL_DATA fills
    Index tuples = 0;
};

// A keyword followed by "name type" and one tuple of this many scalars per element.
struct Kind {
    std::string_view keyword;
    std::uint32_t arity;
};
constexpr std::array kKinds = {
    Kind{"VECTORS", 3},    Kind{"NORMALS", 3},      Kind{"TENSORS", 9},    Kind{"TENSORS6", 6},
    Kind{"GLOBAL_IDS", 1}, Kind{"PEDIGREE_IDS", 1}, Kind{"EDGE_FLAGS", 1},
};

Status add_values(Reading& reading, std::string_view name, std::string_view type,
                  std::uint32_t arity) {
    const std::string decoded = decode_vtk_name(name);
    Result<VtkArray> array =
        read_vtk_array(reading.file, type, arity, reading.tuples, "'" + decoded + "'");
    if (!array) return array.error();
    reading.into->push_back({decoded, std::move(array->values)});
    return Done{};
}

// The table's name is asked for by the format, but files without it are read, too.
void skip_table_name(VtkLegacy& file) {
    const std::size_t here = file.text.offset();
    if (same_word(file.text.word(), "LOOKUP_TABLE")) {
        file.text.rest_of_line();
    } else {
        file.text.seek(here);
    }
}

Status read_scalars(Reading& reading) {
    TextReader& text = reading.file.text;
    const std::string_view name = text.line_word();
    const std::string_view type = text.line_word();
    if (type.empty()) return text.expected("a name and a type after SCALARS");
    std::uint32_t arity = 1;
    if (!text.line_ended() && !text.read_in_line(arity)) {
        return text.expected("a number of components");
    }
    skip_table_name(reading.file);
    return add_values(reading, name, type, arity);
}

// Colours are floats from 0 to 1 in text and bytes in binary files.
Status read_color_scalars(Reading& reading) {
    TextReader& text = reading.file.text;
    const std::string_view name = text.line_word();
    std::uint32_t arity = 0;
    if (!text.read_in_line(arity)) return text.expected("a number of colour components");
    return add_values(reading, name, reading.file.binary ? "unsigned_char" : "float", arity);
}

Status read_lookup_table(Reading& reading) {
    TextReader& text = reading.file.text;
    const std::string name = decode_vtk_name(text.line_word());
    Index size = 0;
    if (!text.read_in_line(size)) return text.expected("the size of the lookup table");
    Result<VtkArray> table = read_vtk_array(
        reading.file, reading.file.binary ? "unsigned_char" : "float", 4, size, "'" + name + "'");
    if (!table) return table.error();
    reading.data.field.push_back({"vtk:lookup_table:" + name, std::move(table->values)});
    return Done{};
}

Status read_texture_coordinates(Reading& reading) {
    TextReader& text = reading.file.text;
    const std::string_view name = text.line_word();
    std::uint32_t arity = 0;
    if (!text.read_in_line(arity)) return text.expected("the dimension of TEXTURE_COORDINATES");
    const std::string_view type = text.line_word();
    return add_values(reading, name, type, arity);
}

Status read_section(Reading& reading, std::string_view keyword) {
    TextReader& text = reading.file.text;
    if (same_word(keyword, "METADATA")) {
        skip_vtk_metadata(reading.file);
        return Done{};
    }
    if (same_word(keyword, "FIELD") && !reading.into) {
        return read_vtk_field(reading.file, reading.data.field, std::nullopt);
    }
    if (!reading.into) return text.expected("POINT_DATA or CELL_DATA");
    if (same_word(keyword, "FIELD")) {
        return read_vtk_field(reading.file, *reading.into, reading.tuples);
    }
    if (same_word(keyword, "SCALARS")) return read_scalars(reading);
    if (same_word(keyword, "COLOR_SCALARS")) return read_color_scalars(reading);
    if (same_word(keyword, "LOOKUP_TABLE")) return read_lookup_table(reading);
    if (same_word(keyword, "TEXTURE_COORDINATES")) return read_texture_coordinates(reading);
    for (const Kind& kind : kKinds) {
        if (!same_word(keyword, kind.keyword)) continue;
        const std::string_view name = text.line_word();
        const std::string_view type = text.line_word();
        return add_values(reading, name, type, kind.arity);
    }
    return text.expected("a data section such as SCALARS or FIELD");
}

}  // namespace

Status read_vtk_field(VtkLegacy& file, std::vector<NamedArray>& into, std::optional<Index> tuples) {
    file.text.line_word();  // the field's own name is always FieldData
    Index arrays = 0;
    if (!file.text.read_in_line(arrays)) return file.text.expected("the number of arrays in FIELD");
    for (Index i = 0; i < arrays; ++i) {
        std::string_view name = file.text.word();
        while (same_word(name, "METADATA")) {
            skip_vtk_metadata(file);
            name = file.text.word();
        }
        const std::string decoded = decode_vtk_name(name);
        std::uint32_t arity = 0;
        Index count = 0;
        if (name.empty() || !file.text.read_in_line(arity) || !file.text.read_in_line(count)) {
            return file.text.expected("name, components and tuples of a FIELD array");
        }
        if (tuples && count != *tuples) {
            return file.text.error("array '" + decoded + "' has " + std::to_string(count) +
                                   " tuples where " + std::to_string(*tuples) + " are needed");
        }
        const std::string_view type = file.text.line_word();
        Result<VtkArray> array = read_vtk_array(file, type, arity, count, "'" + decoded + "'");
        if (!array) return array.error();
        into.push_back({decoded, std::move(array->values)});
    }
    return Done{};
}

Status read_vtk_attributes(VtkLegacy& file, Index points, Index cells, VtkData& data) {
    Reading reading{file, data, nullptr, 0};
    while (true) {
        const std::string_view keyword = file.text.word();
        if (keyword.empty()) return Done{};
        const bool on_points = same_word(keyword, "POINT_DATA");
        if (on_points || same_word(keyword, "CELL_DATA")) {
            reading.into = on_points ? &data.points : &data.cells;
            reading.tuples = on_points ? points : cells;
            Index count = 0;
            if (!file.text.read_in_line(count)) return file.text.expected("a number of tuples");
            if (count != reading.tuples) {
                return file.text.error(std::string(keyword) + " is for " + std::to_string(count) +
                                       " of them, but there are " + std::to_string(reading.tuples));
            }
            continue;
        }
        if (Status status = read_section(reading, keyword); !status) return status;
    }
}

}  // namespace ravel::io
