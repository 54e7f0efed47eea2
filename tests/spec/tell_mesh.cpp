#include "spec/tell_mesh.h"

#include <cstdio>

#include "base/bytes.h"
#include "base/checksum.h"
#include "spec/tell_fields.h"

namespace ravel::test {
namespace {

void tell_array(const Array& values, std::string& out) {
    for (std::size_t i = 0; i < values.bytes.size(); i += size_of(values.scalar)) {
        std::string digits;  // most significant first
        for (std::size_t b = size_of(values.scalar); b-- > 0;)
            digits += hex(std::span(values.bytes).subspan(i + b, 1));
        out += " " + digits;
    }
}

void tell_strip(const std::vector<StripStep>& steps, std::string& out) {
    out += "\nthe strip: cell, or cell from exit entry, l for a link; then the next";
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const StripStep& step = steps[i];
        out += (i % 8 == 0 ? "\n" : ", ") + std::to_string(step.cell);
        if (step.from != kNoIndex)
            out += " " + std::to_string(step.from) + " " + std::to_string(step.exit) + " " +
                   std::to_string(step.entry) + (step.link ? " l" : "");
    }
    out += "\n";
}

void tell_points_and_cells(const Mesh& mesh, std::string& out) {
    const bool narrow = mesh.positions.scalar == Scalar::f32;
    for (Index p = 0; p < mesh.point_count(); ++p) {
        out += "point " + std::to_string(p) + ":";
        for (std::size_t k = 0; k < 3; ++k)
            out += " " + (narrow ? number_text(mesh.positions.as<float>()[3 * p + k], true)
                                 : number_text(mesh.positions.as<double>()[3 * p + k]));
        out += "\n";
    }
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        out += "cell " + std::to_string(c) + ":";
        for (const Index i : mesh.cell(c)) out += " " + std::to_string(i);
        out += "\n";
    }
}

void tell_checksums(const Decoded& decoded, std::string& out) {
    const Mesh& mesh = decoded.mesh;
    ByteWriter strip, cells;
    for (const StripStep& step : decoded.steps)
        for (const std::uint64_t n :
             {step.cell, step.from, Index{step.exit}, Index{step.entry}, Index{step.link}})
            strip.u32(static_cast<std::uint32_t>(n));
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        cells.u32(static_cast<std::uint32_t>(mesh.cell(c).size()));
        for (const Index i : mesh.cell(c)) cells.u32(static_cast<std::uint32_t>(i));
    }
    const auto tell = [&](const char* what, std::span<const std::byte> bytes) {
        char text[16];
        std::snprintf(text, sizeof text, "%08X", crc32c(bytes));
        out += std::string("crc32c of ") + what + ": " + text + "\n";
    };
    out += "\nthe mesh, " + std::to_string(mesh.point_count()) + " points and " +
           std::to_string(mesh.cell_count()) + " cells\n";
    tell("the points' bytes", mesh.positions.bytes);
    tell("number of corners and corners of all cells, as u32", cells.bytes());
    tell("cell, from (NONE for a seed), exit, entry, link of all steps of the strip, as u32",
         strip.bytes());
}

}  // namespace

void tell_mesh(const Decoded& decoded, Index most_cells, std::string& out) {
    const Mesh& mesh = decoded.mesh;
    if (mesh.cell_count() <= most_cells) {
        tell_strip(decoded.steps, out);
        out += "\nthe mesh\n";
        tell_points_and_cells(mesh, out);
    } else {
        tell_checksums(decoded, out);
    }
    for (const CompanionBlock& block : mesh.companions) {
        out += "companions of vtk_type " + std::to_string(block.vtk_type) + ", " +
               std::to_string(block.nodes_per_cell) + " nodes each, " +
               std::to_string(block.cell_count) + " cells:";
        for (const Index node : block.nodes) out += " " + std::to_string(node);
        if (!block.hosts.empty()) out += "; hosts";
        for (const Index host : block.hosts) out += " " + std::to_string(host);
        out += "\n";
    }
    for (const Attribute& a : mesh.attributes) {
        out += "attribute \"" + a.name + "\" on " + name_of(a.place) + ", " +
               std::to_string(a.values.arity) + " x " + name_of(a.values.scalar) + ", as bits:";
        tell_array(a.values, out);
        if (!a.index.empty()) out += "; index";
        for (const Index i : a.index) out += i == kNoIndex ? " -" : " " + std::to_string(i);
        out += "\n";
    }
    for (const TagName& n : mesh.tag_names)
        out += "name of \"" + n.attribute + "\", dimension " + std::to_string(n.dimension) +
               ", value " + std::to_string(n.value) + ": \"" + n.name + "\"\n";
    for (const Note& n : mesh.notes) out += "note \"" + n.key + "\": \"" + n.text + "\"\n";
}

}  // namespace ravel::test
