// ravel strip MESH: the single strip of every component, proven, and written as a mesh if asked.
// With --tables: the paper's tables beside ours for many meshes.
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

#include "ravel/input_file.h"
#include "ravel/objective.h"
#include "ravel/output_file.h"
#include "ravel/progress.h"
#include "ravel/report.h"
#include "ravel/strip_output.h"
#include "ravel/strip_tables.h"
#include "ravel/talk.h"
#include "ravel/verbs.h"
#include "ravel/wind.h"
#include "strip/forced.h"

namespace ravel::tool {
namespace {

struct Options {
    std::vector<std::string> meshes;
    std::string from, output, to;
    std::string method = "steered", objective = "turns";
    bool unmatched = false, tables = false;
    bool json = false, force = false, binary = false;
};

const std::vector<std::pair<std::string, FactorMethod>> kMethods{
    {"steered", FactorMethod::steered},
    {"euler", FactorMethod::euler},
    {"two-pass", FactorMethod::two_pass},
    {"template", FactorMethod::template_substitution}};

FactorMethod method_of(const std::string& name) {
    for (const auto& [known, method] : kMethods)
        if (known == name) return method;
    return FactorMethod::steered;
}

// Template substitution is exact; what the others don't find may be there.
std::string two_factor_of(const Options& options, const StripCounts& counts) {
    if (counts.paths + counts.singletons == 0) return "found";
    return options.method == "template" && !options.unmatched ? "none exists" : "not found";
}

Json facts_of(const Options& options, const Mesh& mesh, const Wound& wound,
              const StepFacts& steps) {
    const StripCounts& counts = wound.strip.counts;
    const Materialised& made = wound.made;
    Json facts;
    facts["mesh"] = options.meshes.front();
    facts["cells"] = mesh.cell_count();
    facts["cell_kind"] = name_of(mesh.kind);
    facts["components"] = counts.components;
    facts["method"] = options.method;
    facts["factor"]["cycles"] = counts.cycles;
    facts["factor"]["paths"] = counts.paths;
    facts["factor"]["singletons"] = counts.singletons;
    facts["factor"]["two_factor"] = two_factor_of(options, counts);
    facts["fan_merges"] = counts.fan_merges;
    facts["links"] = counts.links;
    facts["links_forced"] = forced_links(wound.complex, wound.strip);
    facts["strips"] = counts.strips;
    facts["open_strips"] = counts.open_strips;
    facts["added_cells"] = made.added_cells;
    facts["added_vertices"] = made.added_points;
    facts["added_cells_percent"] = mesh.cell_count() == 0
                                       ? 0.0
                                       : 100.0 * static_cast<double>(made.added_cells) /
                                             static_cast<double>(mesh.cell_count());
    facts["objective"] = options.objective;
    Json& along = facts["along_strip"];
    along["steps"] = steps.steps;
    if (mesh.kind == CellKind::polygon) {
        along["normal_change_degrees"] = steps.normal_change_degrees;
        along["turn_percent"] = steps.turn_percent;
    }
    along["axis_x_percent"] = steps.axis_percent[0];
    along["axis_y_percent"] = steps.axis_percent[1];
    along["axis_z_percent"] = steps.axis_percent[2];
    facts["seconds"] = wound.seconds;
    return facts;
}

ExitCode broken(const std::string& mesh, const Error& error) {
    if (error.code != Code::corrupt) return complain_of_mesh(mesh, error);
    complain(mesh, error);
    remark("the strip fails its certificate: this is a bug, please report it");
    return ExitCode::bug;
}

ExitCode print_tables(const Options& options) {
    Json quads = Json::array(), tets = Json::array();
    for (const std::string& name : options.meshes) {
        auto mesh = read_mesh_input(name, options.from);
        if (!mesh) return complain(name, mesh.error());
        const std::string model = std::filesystem::path(name).stem().string();
        Json& rows = mesh->kind == CellKind::polygon ? quads : tets;
        if (Status status = add_table_rows(model, *mesh, rows); !status)
            return broken(name, status.error());
    }
    if (options.json) {
        Json both;
        both["table_1"] = quads;
        both["table_2"] = tets;
        fmt::print("{}", json_of(both));
        return ExitCode::done;
    }
    const char* gap = "";
    for (const auto& [rows, kind] :
         {std::pair{&quads, CellKind::polygon}, {&tets, CellKind::tet}}) {
        if (rows->empty()) continue;
        fmt::print("{}Table {}\n{}", gap, kind == CellKind::polygon ? "1, polygons" : "2, tets",
                   table_of(*rows, table_columns(kind)));
        gap = "\n";
    }
    return ExitCode::done;
}

ExitCode misuse(const std::string& sentence) {
    say(sentence);
    return ExitCode::usage;
}

// Options that don't go together, as a sentence; empty where all is well.
std::string clash_of(const Options& options) {
    const bool plain = options.method == "steered" && options.objective == "turns" &&
                       !options.unmatched && options.output.empty();
    if (options.tables) return plain ? "" : "--tables takes meshes and --json, nothing else";
    if (options.meshes.size() != 1) return "strip takes one mesh, unless with --tables";
    if (options.unmatched && options.method != "two-pass" && options.method != "template")
        return "--unmatched goes with --method two-pass or template";
    if (options.objective != "turns" && options.method != "steered")
        return "--objective goes with --method steered";
    return "";
}

ExitCode run(const Options& options) {
    if (const std::string clash = clash_of(options); !clash.empty()) return misuse(clash);
    if (options.tables) return print_tables(options);
    if (!options.output.empty())
        if (Status status = may_write(options.output, options.force); !status)
            return complain("", status.error());
    const std::string& name = options.meshes.front();
    Progress progress(name, "reading");
    auto mesh = read_mesh_input(name, options.from);
    if (!mesh) return complain(name, mesh.error());
    const Objective objective = *objective_of(options.objective);
    if (objective == Objective::normals && mesh->kind == CellKind::tet)
        return misuse("tets have no normals: take --objective turns or an axis");

    progress.now(fmt::format("winding {} {}s", mesh->cell_count(), name_of(mesh->kind)));
    WindOptions winding;
    winding.method = method_of(options.method);
    winding.strip.reading = options.unmatched ? Reading::unmatched : Reading::matched;
    winding.weigh = [&](const Complex& complex) {
        return facet_weights(*mesh, complex, objective);
    };
    auto wound = wind(*mesh, winding);
    if (!wound) return broken(name, wound.error());
    const Json facts =
        facts_of(options, *mesh, *wound, measure_steps(*mesh, wound->complex, wound->strip));
    const StripCounts& counts = wound->strip.counts;
    if (options.method == "two-pass" && counts.paths + counts.singletons > 0)
        remark(fmt::format("two-pass finds no 2-factor: {} strip ends and {} single cells mended",
                           2 * counts.paths, counts.singletons));
    if (!options.output.empty()) {
        progress.now("writing");
        io::WriteOptions format;
        format.binary = options.binary;
        std::vector<std::string> left_out;
        const Mesh result = with_strip_data(std::move(wound->made));
        if (Status status = write_mesh_output(result, options.output, options.to, format,
                                              options.force, &left_out);
            !status)
            return complain(options.output, status.error());
        remark_each(options.output, left_out);
    }
    // Where the mesh itself goes to stdout the facts would spoil it; those asked for go to stderr.
    if (options.output != "-")
        fmt::print("{}", options.json ? json_of(facts) : text_of(facts));
    else if (options.json)
        std::fputs(json_of(facts).c_str(), stderr);
    return ExitCode::done;
}

}  // namespace

void add_strip(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand("strip", "Wind the cells onto one strip per component");
    std::vector<std::string> methods;
    for (const auto& [name, method] : kMethods) methods.push_back(name);
    verb->add_option("MESH", options->meshes, "The mesh; its ending tells the format")->required();
    verb->add_option("--method", options->method, "How the 2-factor is found")
        ->check(CLI::IsMember(methods))
        ->capture_default_str();
    verb->add_flag(
        "--unmatched", options->unmatched,
        "Take the edges that two-pass or template leave out, as the paper does for tets");
    verb->add_option("--objective", options->objective,
                     "What the strip looks for: turns as the decoder expects them, like normals, "
                     "steps along an axis")
        ->check(CLI::IsMember(objective_names()))
        ->capture_default_str();
    verb->add_flag("--tables", options->tables,
                   "Tables 1 and 2 of the paper beside ours, for one or more meshes");
    verb->add_option(
        "-o,--output", options->output,
        "The subdivided mesh, cells in strip order, with cell data strip_position and parent");
    verb->add_flag("-f,--force", options->force, "Overwrite the output");
    verb->add_flag("--json", options->json,
                   "Facts as one JSON object (on stderr where the mesh goes to stdout)");
    verb->add_option("--from", options->from, "Format of a mesh that comes by stdin")
        ->type_name("ENDING");
    verb->add_option("--to", options->to, "Format of a mesh that goes to stdout")
        ->type_name("ENDING");
    verb->add_flag("--binary", options->binary, "The binary kind of formats that have both");
    verb->footer(
        "Every strip is checked before anything is printed: each cell once, neighbours share a\n"
        "facet, one strip per component.\n\n"
        "Examples:\n"
        "  ravel strip torus.obj\n"
        "  ravel strip bone.msh --json -o strip.vtk\n"
        "  ravel strip car.obj --objective axis=x\n"
        "  ravel strip --tables sphere_640.obj fandisk_22k.ele");
    verb->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace ravel::tool
