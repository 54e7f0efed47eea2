// Gmsh MSH files, versions 2.2 and 4.1, text and binary.
#include <limits>

#include "io/attributes.h"
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/gmsh_types.h"
#include "io/left_out.h"
#include "io/msh_stream.h"

namespace ravel::io {

namespace {

constexpr Index kMost32 = std::numeric_limits<std::int32_t>::max();

// Version 2 has 32-bit tags in binary files, data have them in all.
bool fit_32_bits(const std::vector<Index>& tags) {
    return std::all_of(tags.begin(), tags.end(), [](Index tag) { return tag <= kMost32; });
}

std::vector<Index> gmsh_nodes(const MshFile& file, Index c, const GmshType& type) {
    const std::span<const Index> cell = file.cells.cell(c);
    std::vector<Index> nodes(cell.begin(), cell.end());
    for (std::size_t i = 0; i < type.order.size(); ++i) nodes[type.order[i]] = cell[i];
    for (Index& node : nodes) node = file.node_tags[node];
    return nodes;
}

const GmshType& type_of(const MshFile& file, Index c) {
    return *gmsh_type_of(file.cells.types[c], file.cells.cell(c).size());
}

// Text keeps the positions' own type, so that float32 is written as short as it is.
void put_coordinate(MshOutput& out, const Array& values, std::size_t flat) {
    if (out.binary || values.scalar == Scalar::f64)
        out.put(real_at(values, flat));
    else if (values.scalar == Scalar::f32)
        out.put(values.as<float>()[flat]);
    else
        out.put(static_cast<std::int64_t>(real_at(values, flat)));
}

// The tags of element c: as many as go on without a gap. A tag before another that is there is 0.
std::vector<std::int32_t> tags_of(const MshFile& file, Index c) {
    std::vector<std::int32_t> tags;
    std::size_t count = 0;
    for (std::size_t t = 0; t < file.element_columns.size(); ++t) {
        const CellData& column = file.element_columns[t];
        const Index tuple = column.index.empty() ? c : column.index[c];
        tags.push_back(tuple == kNoIndex ? 0 : column.values.as<std::int32_t>()[tuple]);
        if (tuple != kNoIndex) count = t + 1;
    }
    tags.resize(count);
    return tags;
}

void put_element_v2(MshOutput& out, const MshFile& file, Index c,
                    const std::vector<std::int32_t>& tags) {
    const GmshType& type = type_of(file, c);
    if (out.binary) {
        out.put(static_cast<std::int32_t>(file.element_tags[c]));
    } else {
        out.put(file.element_tags[c]);
        out.put(type.gmsh);
        out.put(tags.size());
    }
    for (const std::int32_t tag : tags) out.put(tag);
    for (const Index node : gmsh_nodes(file, c, type)) {
        if (out.binary)
            out.put(static_cast<std::int32_t>(node));
        else
            out.put(node);
    }
    out.end_line();
}

void put_elements_v2(MshOutput& out, const MshFile& file) {
    out.line("$Elements");
    out.line(std::to_string(file.cells.count()));
    Index c = 0;
    while (c < file.cells.count()) {
        const std::vector<std::int32_t> tags = tags_of(file, c);
        if (!out.binary) {
            put_element_v2(out, file, c++, tags);
            continue;
        }
        Index end = c + 1;
        while (end < file.cells.count() && &type_of(file, end) == &type_of(file, c) &&
               end - c < kMost32 && tags_of(file, end).size() == tags.size()) {
            ++end;
        }
        out.put(type_of(file, c).gmsh);
        out.put(static_cast<std::int32_t>(end - c));
        out.put(static_cast<std::int32_t>(tags.size()));
        for (; c < end; ++c) put_element_v2(out, file, c, tags_of(file, c));
    }
    out.end_section("Elements");
}

// Calls f(first, last) for each run of elements that `same` takes for one block.
template <class Same, class F>
void for_each_run(Index count, Same same, F f) {
    for (Index first = 0; first < count;) {
        Index last = first + 1;
        while (last < count && same(first, last)) ++last;
        f(first, last);
        first = last;
    }
}

void put_totals(MshOutput& out, std::uint64_t blocks, const std::vector<Index>& tags) {
    const auto [least, most] = std::minmax_element(tags.begin(), tags.end());
    out.put(blocks);
    out.put(std::uint64_t{tags.size()});
    out.put(std::uint64_t{tags.empty() ? 0 : *least});
    out.put(std::uint64_t{tags.empty() ? 0 : *most});
    out.end_line();
}

void put_nodes_v4(MshOutput& out, const MshFile& file) {
    const auto same = [&](Index a, Index b) {
        return file.node_dimensions[a] == file.node_dimensions[b] &&
               file.node_entities[a] == file.node_entities[b] &&
               (file.parametric_index[a] == kNoIndex) == (file.parametric_index[b] == kNoIndex);
    };
    out.line("$Nodes");
    std::uint64_t blocks = 0;
    for_each_run(file.node_tags.size(), same, [&](Index, Index) { ++blocks; });
    put_totals(out, blocks, file.node_tags);
    for_each_run(file.node_tags.size(), same, [&](Index first, Index last) {
        const bool parametric = file.parametric_index[first] != kNoIndex;
        out.put(file.node_dimensions[first]);
        out.put(file.node_entities[first]);
        out.put(std::int32_t{parametric});
        out.put(std::uint64_t{last - first});
        out.end_line();
        for (Index i = first; i < last; ++i) {
            out.put(std::uint64_t{file.node_tags[i]});
            out.end_line();
        }
        for (Index i = first; i < last; ++i) {
            for (std::size_t k = 0; k < 3; ++k) put_coordinate(out, file.positions, 3 * i + k);
            for (std::int32_t k = 0; parametric && k < file.node_dimensions[first]; ++k) {
                out.put(file.parametric[3 * file.parametric_index[i] + static_cast<Index>(k)]);
            }
            out.end_line();
        }
    });
    out.end_section("Nodes");
}

void put_elements_v4(MshOutput& out, const MshFile& file) {
    const auto same = [&](Index a, Index b) {
        return file.element_dimensions[a] == file.element_dimensions[b] &&
               file.element_entities[a] == file.element_entities[b] &&
               &type_of(file, a) == &type_of(file, b);
    };
    out.line("$Elements");
    std::uint64_t blocks = 0;
    for_each_run(file.cells.count(), same, [&](Index, Index) { ++blocks; });
    put_totals(out, blocks, file.element_tags);
    for_each_run(file.cells.count(), same, [&](Index first, Index last) {
        const GmshType& type = type_of(file, first);
        out.put(file.element_dimensions[first]);
        out.put(file.element_entities[first]);
        out.put(type.gmsh);
        out.put(std::uint64_t{last - first});
        out.end_line();
        for (Index c = first; c < last; ++c) {
            out.put(std::uint64_t{file.element_tags[c]});
            for (const Index node : gmsh_nodes(file, c, type)) out.put(std::uint64_t{node});
            out.end_line();
        }
    });
    out.end_section("Elements");
}

void put_names(MshOutput& out, const std::vector<TagName>& names) {
    if (names.empty()) return;
    out.line("$PhysicalNames");
    out.line(std::to_string(names.size()));
    for (const TagName& name : names) {
        out.line(std::to_string(name.dimension) + ' ' + std::to_string(name.value) + " \"" +
                 name.name + '"');
    }
    out.line("$EndPhysicalNames");
}

// The tags above the rows: what was kept of them, or the usual ones.
void put_data_header(MshOutput& out, const MshData& data) {
    std::vector<std::string> strings{data.name}, reals{"0.0"}, integers{"0"};
    TextReader kept(data.header, "", {'\0', false});
    for (std::string_view word = kept.word(); !word.empty(); word = kept.word()) {
        if (word == "string") {
            strings.emplace_back(kept.rest_of_line());
            continue;
        }
        std::vector<std::string>& tags = word == "reals" ? reals : integers;
        tags.clear();
        while (!kept.line_ended()) tags.emplace_back(kept.line_word());
    }
    const std::size_t rest = integers.empty() ? 0 : 1;
    integers.insert(integers.begin() + static_cast<std::ptrdiff_t>(rest),
                    {std::to_string(data.values.arity), std::to_string(data.tags.size())});
    out.line(std::to_string(strings.size()));
    for (const std::string& string : strings) out.line('"' + string + '"');
    for (const auto* tags : {&reals, &integers}) {
        out.line(std::to_string(tags->size()));
        for (const std::string& tag : *tags) out.line(tag);
    }
}

void put_data(MshOutput& out, const MshData& data) {
    const char* name = data.place == Place::point ? "NodeData" : "ElementData";
    out.line(std::string("$") + name);
    put_data_header(out, data);
    for (std::size_t row = 0; row < data.tags.size(); ++row) {
        out.put(static_cast<std::int32_t>(data.tags[row]));
        for (std::size_t k = 0; k < data.values.arity; ++k) {
            put_coordinate(out, data.values, row * data.values.arity + k);
        }
        out.end_line();
    }
    out.end_section(name);
}

void put_section(MshOutput& out, const MshSection& section) {
    out.line('$' + section.name);
    out.out += section.text;
    out.line("$End" + section.name);
}

void put_types(MshOutput& out, const std::vector<MshType>& types) {
    if (types.empty()) return;
    out.line(std::string("$") + kTypesSection);
    for (const MshType& type : types) {
        out.line(type.section + ' ' + name_of(type.scalar) + " \"" + type.name + '"');
    }
    out.line(std::string("$End") + kTypesSection);
}

void put_format(MshOutput& out, const MshFile& file) {
    out.line("$MeshFormat");
    out.line(std::string(file.version_4 ? "4.1 " : "2.2 ") + (out.binary ? "1 8" : "0 8"));
    if (out.binary) {
        out.put(std::int32_t{1});
        out.out += '\n';
    }
    out.line("$EndMeshFormat");
}

// Sections that Gmsh has before the nodes; all others that are kept go behind the elements.
bool before_nodes(const MshSection& section) {
    return section.name == "PartitionedEntities";
}

}  // namespace

Status put_nodes_and_elements_v2(MshOutput& out, const MshFile& file, const std::string& path) {
    if (out.binary && !(fit_32_bits(file.node_tags) && fit_32_bits(file.element_tags))) {
        return cannot_hold(path, "binary MSH 2.2 has 32-bit numbers of nodes and elements only");
    }
    out.line("$Nodes");
    out.line(std::to_string(file.node_tags.size()));
    for (Index i = 0; i < file.node_tags.size(); ++i) {
        if (out.binary)
            out.put(static_cast<std::int32_t>(file.node_tags[i]));
        else
            out.put(file.node_tags[i]);
        for (std::size_t k = 0; k < 3; ++k) put_coordinate(out, file.positions, 3 * i + k);
        out.end_line();
    }
    out.end_section("Nodes");
    put_elements_v2(out, file);
    return Done{};
}

Status put_nodes_and_elements_v4(MshOutput& out, const MshFile& file, const std::string&) {
    put_nodes_v4(out, file);
    put_elements_v4(out, file);
    return Done{};
}

Status write_msh(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                 Sentences* left_out_sentences) {
    LeftOut left_out(mesh, "MSH");
    left_out.take_notes("vtk:version");
    left_out.take_notes("vtk:title");
    left_out.take_notes("vtk:dataset");
    const Result<MshFile> file = mesh_to_msh(mesh, path, options.binary, left_out);
    if (!file) return file.error();
    MshOutput out(options.binary);
    put_format(out, *file);
    put_names(out, file->names);
    if (file->version_4 && file->has_entities) {
        out.line("$Entities");
        put_entities(out, file->entities);
        out.end_section("Entities");
    }
    for (const MshSection& section : file->sections) {
        if (before_nodes(section)) put_section(out, section);
    }
    Status status = file->version_4 ? put_nodes_and_elements_v4(out, *file, path)
                                    : put_nodes_and_elements_v2(out, *file, path);
    if (!status) return status;
    put_types(out, file->types);
    for (const MshSection& section : file->sections) {
        if (!before_nodes(section)) put_section(out, section);
    }
    for (const MshData& data : file->data) {
        if (!fit_32_bits(data.tags)) {
            return cannot_hold(path, "data of nodes or elements with numbers beyond 32 bits");
        }
        put_data(out, data);
    }
    left_out.report(left_out_sentences);
    return write_file(path, out.out);
}

}  // namespace ravel::io
