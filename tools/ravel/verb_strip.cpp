// ravel strip MESH: the single strip of every component, proven, and written as a mesh if asked.
#include <chrono>

#include <fmt/format.h>

#include "ravel/input_file.h"
#include "ravel/output_file.h"
#include "ravel/report.h"
#include "ravel/strip_output.h"
#include "ravel/talk.h"
#include "ravel/verbs.h"
#include "strip/build.h"
#include "strip/check.h"
#include "strip/materialise.h"

namespace ravel::tool {
namespace {

struct Options {
    std::string mesh, from, output, to;
    std::string method = "steered";
    bool json = false, force = false, binary = false;
};

Json facts_of(const Options& options, const Mesh& mesh, const StripCounts& counts,
              const Materialised& made, double seconds) {
    Json facts;
    facts["mesh"] = options.mesh;
    facts["cells"] = mesh.cell_count();
    facts["cell_kind"] = name_of(mesh.kind);
    facts["components"] = counts.components;
    facts["method"] = options.method;
    facts["factor"]["cycles"] = counts.cycles;
    facts["factor"]["paths"] = counts.paths;
    facts["factor"]["singletons"] = counts.singletons;
    facts["fan_merges"] = counts.fan_merges;
    facts["links"] = counts.links;
    facts["strips"] = counts.strips;
    facts["open_strips"] = counts.open_strips;
    facts["added_cells"] = made.added_cells;
    facts["added_vertices"] = made.added_points;
    facts["added_cells_percent"] =
        mesh.cell_count() == 0
            ? 0.0
            : 100.0 * static_cast<double>(made.added_cells) / static_cast<double>(mesh.cell_count());
    facts["seconds"] = seconds;
    return facts;
}

ExitCode broken(const Options& options, const Error& error) {
    complain(options.mesh, error);
    remark("the strip fails its certificate: this is a bug, please report it");
    return ExitCode::bug;
}

ExitCode run(const Options& options) {
    if (options.method == "two-pass" || options.method == "template") {
        fmt::print(stderr, "ravel: the method {} is not in this version; steered and euler are\n",
                   options.method);
        return ExitCode::usage;
    }
    if (!options.output.empty())
        if (Status status = may_write(options.output, options.force); !status)
            return complain("", status.error());
    auto mesh = read_mesh_input(options.mesh, options.from);
    if (!mesh) return complain(options.mesh, mesh.error());

    const auto start = std::chrono::steady_clock::now();
    const FactorMethod method = options.method == "euler" ? FactorMethod::euler : FactorMethod::steered;
    auto complex = build_complex(*mesh);
    if (!complex) return complain_of_mesh(options.mesh, complex.error());
    const Strip strip = build_strip(*complex, method);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    if (Status status = check_strip(*complex, strip); !status) return broken(options, status.error());
    auto made = materialise(*mesh, *complex, strip);
    if (!made) return broken(options, made.error());
    if (Status status = check_materialised(*mesh, *made); !status)
        return broken(options, status.error());

    const Json facts = facts_of(options, *mesh, strip.counts, *made, seconds);
    if (!options.output.empty()) {
        io::WriteOptions format;
        format.binary = options.binary;
        std::vector<std::string> left_out;
        const Mesh result = with_strip_data(std::move(*made));
        if (Status status = write_mesh_output(result, options.output, options.to, format,
                                              options.force, &left_out);
            !status)
            return complain(options.output, status.error());
        remark_each(options.output, left_out);
    }
    // Where the mesh itself goes to stdout, the facts would spoil it.
    if (options.output != "-") fmt::print("{}", options.json ? json_of(facts) : text_of(facts));
    return ExitCode::done;
}

}  // namespace

void add_strip(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand("strip", "Wind the cells onto one strip per component");
    verb->add_option("MESH", options->mesh, "The mesh; its ending tells the format")->required();
    verb->add_option("--method", options->method,
                     "How the 2-factor is found; two-pass and template are not in this version")
        ->check(CLI::IsMember({"steered", "euler", "two-pass", "template"}))
        ->capture_default_str();
    verb->add_option("-o,--output", options->output,
                     "The subdivided mesh, cells in strip order, with cell data strip_position and parent");
    verb->add_flag("-f,--force", options->force, "Overwrite the output");
    verb->add_flag("--json", options->json, "Facts as one JSON object");
    verb->add_option("--from", options->from, "Format of a mesh that comes by stdin")
        ->type_name("ENDING");
    verb->add_option("--to", options->to, "Format of a mesh that goes to stdout")->type_name("ENDING");
    verb->add_flag("--binary", options->binary, "The binary kind of formats that have both");
    verb->footer("Every strip is checked before anything is printed: each cell once, neighbours share a\n"
                 "facet, one strip per component.\n\n"
                 "Examples:\n"
                 "  ravel strip torus.obj\n"
                 "  ravel strip bone.msh --json -o strip.vtk");
    verb->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace ravel::tool
