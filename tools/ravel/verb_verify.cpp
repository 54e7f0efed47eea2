// ravel verify MESH: is what comes back what went in?
#include <algorithm>

#include <fmt/format.h>

#include "compare/round.h"
#include "ravel/encode_options.h"
#include "ravel/input_file.h"
#include "ravel/progress.h"
#include "ravel/report.h"
#include "ravel/talk.h"
#include "ravel/verbs.h"

namespace ravel::tool {
namespace {

struct Options {
    std::string input, from;
    bool json = false;
    EncodeFlags flags;
};

Json facts_of(const std::string& attribute, double error, double bound) {
    Json facts;
    facts["attribute"] = attribute;
    facts["max_error"] = error;
    facts["bound"] = bound;
    return facts;
}

// `rounded`: the attributes that are not exact.
void print(Json& facts, const Json& rounded, bool json) {
    if (json && !rounded.empty()) facts["attributes"] = rounded;
    fmt::print("{}", json ? json_of(facts) : text_of(facts));
    if (!json && !rounded.empty()) fmt::print("\n{}", table_of(rounded, {}));
}

ExitCode verify_mesh(const Options& options) {
    Progress progress(options.input, "reading");
    auto mesh = read_mesh_input(options.input, options.from);
    if (!mesh) return complain(options.input, mesh.error());
    progress.now(fmt::format("packing {} {}s", mesh->cell_count(), name_of(mesh->kind)));
    auto packed = encode(*mesh, options_of(options.flags));
    if (!packed) return complain_of_mesh(options.input, packed.error());
    progress.now("unpacking");
    auto again = decode(packed->bytes);
    if (!again) {
        complain(options.input, again.error());
        remark("ravel cannot read what it wrote: this is a bug, please report it");
        return ExitCode::bug;
    }
    progress.now("comparing");
    const double rounding = compare::round_if_asked(*mesh, options_of(options.flags));
    Comparison found = compare_meshes(*mesh, again->mesh, packed->order, packed->position_bound,
                                      packed->attribute_bounds);
    found.max_error = std::max(found.max_error, rounding);
    Json facts;
    facts["mesh"] = options.input;
    facts["equal"] = found.equal;
    facts["connectivity_equal"] = found.connectivity_equal;
    facts["order_kept"] = found.order_kept;
    facts["max_error"] = found.max_error;
    facts["bound"] = std::max(packed->position_bound, rounding);
    facts["attributes_equal"] = found.attributes_equal;
    facts["bytes"] = packed->bytes.size();
    Json rounded = Json::array();
    for (std::size_t i = 0; i < mesh->attributes.size(); ++i)
        if (packed->attribute_bounds[i] > 0)
            rounded.push_back(facts_of(mesh->attributes[i].name, found.attribute_errors[i],
                                       packed->attribute_bounds[i]));
    print(facts, rounded, options.json);
    if (!found.equal) remark(fmt::format("{}: {}", options.input, found.difference));
    return found.equal ? ExitCode::done : ExitCode::no;
}

// Without the mesh there is nothing to compare with: check the checksum and unpack everything.
ExitCode verify_file(const Options& options) {
    Progress progress(options.input, "unpacking");
    auto bytes = read_bytes(options.input);
    if (!bytes) return complain(options.input, bytes.error());
    auto info = inspect(*bytes);
    if (!info) return complain(options.input, info.error());
    DecodeOptions all;
    all.steps = true;  // the strip is checked too
    auto decoded = decode(*bytes, all);
    if (!decoded) return complain(options.input, decoded.error());
    if (Status status = check_mesh(decoded->mesh); !status) {
        complain(options.input, status.error());
        return ExitCode::bug;
    }
    Json facts;
    facts["mesh"] = options.input;
    facts["equal"] = true;
    facts["connectivity_equal"] = nullptr;
    facts["order_kept"] = info->keeps_order;
    facts["max_error"] = info->position_error;
    facts["bound"] = info->position_bound;
    facts["attributes_equal"] = nullptr;
    facts["bytes"] = bytes->size();
    Json rounded = Json::array();
    for (const auto& attribute : info->attributes)
        if (attribute.bound > 0)
            rounded.push_back(facts_of(attribute.name, attribute.error, attribute.bound));
    print(facts, rounded, options.json);
    return ExitCode::done;
}

ExitCode run(const Options& options) {
    const bool packed =
        is_ravel_name(options.input) || (options.input == "-" && options.from.empty());
    return packed ? verify_file(options) : verify_mesh(options);
}

}  // namespace

void add_verify(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb =
        app.add_subcommand("verify", "Pack, unpack and compare a mesh, or check a file");
    verb->add_option("INPUT", options->input, "A mesh, or a .ravel file")->required();
    verb->add_flag("--json", options->json, "Facts as one JSON object");
    verb->add_option("--from", options->from, "Format of a mesh that comes by stdin")
        ->type_name("ENDING");
    add_encode_flags(*verb, options->flags);
    add_threads_flag(*verb, options->flags);
    verb->footer(
        "A mesh is encoded with the options given, decoded and compared, in memory.\n"
        "A .ravel file's checksum is checked and it is unpacked (stdin is taken for one).\n"
        "Exit code 0: equal, or the file is whole. 1: a difference. 4: a corrupt file.\n\n"
        "Examples:\n"
        "  ravel verify chair.obj --position-bits 14 --json\n"
        "  ravel verify chair.ravel");
    verb->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace ravel::tool
