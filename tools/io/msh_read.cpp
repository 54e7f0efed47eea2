// Gmsh MSH files, versions 2.2 and 4.1, text and binary: the head and the sequence of sections.
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/msh_stream.h"

namespace ravel::io {

namespace {

struct Reading {
    MshInput in;
    MshFile file;
    TagLookup nodes;
    bool has_nodes = false;
    bool has_elements = false;
};

Status read_format(Reading& reading) {
    TextReader& text = reading.in.text;
    const std::string_view first = text.word();
    if (first == "$NOD") {
        return text.error("MSH 1 files are not supported; 2.2 and 4.1 are");
    }
    if (first != "$MeshFormat") return text.error("this is no MSH file: $MeshFormat is missing");
    const std::string said(text.word());
    std::string version = said;  // "2.000000" is 2
    while (version.find('.') != std::string::npos &&
           (version.back() == '0' || version.back() == '.'))
        version.pop_back();
    int mode = 0, data_size = 0;
    if (version != "2.2" && version != "4.1" && version != "2" && version != "2.1")
        return text.error("MSH version '" + said + "' is not supported; 2.2 and 4.1 are");
    if (!text.read(mode) || !text.read(data_size)) return text.expected("file type and data size");
    if (mode != 0 && mode != 1) return text.error("the file type is 0 for text or 1 for binary");
    if (data_size != 8) return text.error("only files with a data size of 8 are supported");
    reading.file.version_4 = version == "4.1";
    reading.file.binary = reading.in.binary = mode == 1;
    if (mode == 1) {
        text.next_line();
        std::uint32_t one = 0;
        if (!reading.in.get(one)) return reading.in.missing("the number one");
        if (one != 1 && one != 0x01000000) return reading.in.fault("the number one is missing");
        reading.in.swapped = one != 1;
    }
    return Done{};
}

Status read_nodes(Reading& reading) {
    if (reading.has_nodes) return reading.in.fault("a second section $Nodes");
    reading.has_nodes = true;
    Status status = reading.file.version_4 ? read_nodes_v4(reading.in, reading.file)
                                           : read_nodes_v2(reading.in, reading.file);
    if (!status) return status;
    Index twice = 0;
    if (!reading.nodes.fill(reading.file.node_tags, twice)) {
        return reading.in.fault("node " + std::to_string(twice) + " is there twice");
    }
    return Done{};
}

Status read_elements(Reading& reading) {
    if (reading.has_elements) return reading.in.fault("a second section $Elements");
    if (!reading.has_nodes) return reading.in.fault("$Elements comes before $Nodes");
    reading.has_elements = true;
    return reading.file.version_4 ? read_elements_v4(reading.in, reading.nodes, reading.file)
                                  : read_elements_v2(reading.in, reading.nodes, reading.file);
}

Status read_section(Reading& reading, const std::string& name) {
    MshInput& in = reading.in;
    if (name == "Nodes") return read_nodes(reading);
    if (name == "Elements") return read_elements(reading);
    if (name == "PhysicalNames") return read_physical_names(in, reading.file.names);
    if (name == "Entities" && reading.file.version_4) {
        if (reading.file.has_entities) return in.fault("a second section $Entities");
        reading.file.has_entities = true;
        return read_entities(in, reading.file.entities);
    }
    if (name == "NodeData" || name == "ElementData") {
        const Place place = name == "NodeData" ? Place::point : Place::cell;
        return read_data_section(in, place, reading.file.data.emplace_back());
    }
    if (name == kTypesSection) return read_types_section(in, reading.file.types);
    if (name == "MeshFormat") return in.fault("a second section $MeshFormat");
    return read_raw_section(in, name, reading.file.sections.emplace_back());
}

Status read_sections(Reading& reading) {
    TextReader& text = reading.in.text;
    while (true) {
        const std::string_view word = text.word();
        if (word.empty()) return Done{};
        if (word.size() < 2 || word[0] != '$' || word.starts_with("$End")) {
            if (reading.in.binary) {
                return reading.in.fault("expected the beginning of a section");
            }
            return text.expected("the beginning of a section, $Name");
        }
        const std::string name(word.substr(1));
        text.next_line();
        if (Status status = read_section(reading, name); !status) return status;
        if (text.word() != "$End" + name) {
            if (reading.in.binary) return reading.in.fault("expected $End" + name);
            return text.expected("$End" + name);
        }
    }
}

}  // namespace

Result<Mesh> read_msh(const std::string& path) {
    const Result<std::string> bytes = read_file(path);
    if (!bytes) return bytes.error();
    Reading reading{MshInput(TextReader(*bytes, path, {'\0', false})), {}, {}, false, false};
    if (Status status = read_format(reading); !status) return status.error();
    if (reading.in.text.word() != "$EndMeshFormat") {
        return reading.in.text.expected("$EndMeshFormat");
    }
    if (Status status = read_sections(reading); !status) return status.error();
    if (!reading.has_nodes) return reading.in.fault("the file has no section $Nodes");
    return msh_to_mesh(std::move(reading.file), path);
}

}  // namespace ravel::io
