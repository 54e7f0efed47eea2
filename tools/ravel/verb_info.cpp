// ravel info FILE.ravel: what is inside, without unpacking it.
#include <fmt/format.h>

#include "ravel/input_file.h"
#include "ravel/ravel.h"
#include "ravel/report.h"
#include "ravel/talk.h"
#include "ravel/verbs.h"

namespace ravel::tool {
namespace {

struct Options {
    std::string file;
    bool json = false;
};

double bits_each(std::uint64_t bytes, Index elements) {
    return elements == 0 ? 0 : 8.0 * static_cast<double>(bytes) / static_cast<double>(elements);
}

Json facts_of(const std::string& file, const FileInfo& info) {
    Json facts;
    facts["file"] = file;
    facts["version"] = info.version;
    facts["cell_kind"] = name_of(info.kind);
    facts["cells"] = info.cells;
    facts["vertices"] = info.points;
    facts["corners"] = info.corners;
    facts["companions"] = info.companions;
    facts["components"] = info.components;
    facts["links"] = info.links;
    facts["strip"] = info.wants_mending ? "mended when it is made" : "as the walk runs";
    facts["position_type"] = name_of(info.position_scalar);
    facts["lossless"] = info.lossless_positions;
    facts["position_bits"] = info.position_bits;
    facts["grid_step"] = info.grid_step;
    facts["bound"] = info.position_bound;
    facts["max_error"] = info.position_error;
    facts["keeps_order"] = info.keeps_order;
    facts["bytes"] = info.file_bytes;
    facts["bits_per_cell"] = bits_each(info.file_bytes, info.cells);
    facts["bits_per_vertex"] = bits_each(info.file_bytes, info.points);
    return facts;
}

Json sections_of(const FileInfo& info) {
    Json sections = Json::array();
    const auto add = [&](const std::string& name, std::uint64_t bytes, const Json& raw) {
        Json section;
        section["section"] = name;
        section["bytes"] = bytes;
        section["raw_bytes"] = raw;
        section["bits_per_cell"] = bits_each(bytes, info.cells);
        sections.push_back(std::move(section));
    };
    add("header", info.header_bytes, nullptr);
    for (const SectionInfo& section : info.sections)
        add(section.name, section.bytes, section.raw_bytes);
    return sections;
}

ExitCode run(const Options& options) {
    auto bytes = read_bytes(options.file);
    if (!bytes) return complain(options.file, bytes.error());
    auto info = inspect(*bytes);
    if (!info) return complain(options.file, info.error());
    Json facts = facts_of(options.file, *info);
    const Json sections = sections_of(*info);
    Json attributes = Json::array();
    for (const auto& attribute : info->attributes) {
        Json row;
        row["attribute"] = attribute.name;
        row["place"] = name_of(attribute.place);
        row["type"] = name_of(attribute.scalar);
        row["arity"] = attribute.arity;
        row["bound"] = attribute.bound;
        row["max_error"] = attribute.error;
        attributes.push_back(std::move(row));
    }
    if (options.json) {
        facts["sections"] = sections;
        facts["attributes"] = attributes;
        fmt::print("{}", json_of(facts));
        return ExitCode::done;
    }
    fmt::print("{}\n{}", text_of(facts), table_of(sections, {}));
    if (!attributes.empty()) fmt::print("\n{}", table_of(attributes, {}));
    return ExitCode::done;
}

}  // namespace

void add_info(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand(
        "info", "Sections, bytes, bits per cell and bounds of a .ravel file, without decoding it");
    verb->add_option("FILE", options->file, "The .ravel file")->required();
    verb->add_flag("--json", options->json, "Facts as one JSON object");
    verb->footer("Headers only are read: `ravel verify FILE.ravel` decodes and checks all of it.");
    verb->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace ravel::tool
