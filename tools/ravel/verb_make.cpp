// ravel make RECIPE -o MESH
#include <fmt/format.h>

#include "make/make_mesh.h"
#include "ravel/output_file.h"
#include "ravel/talk.h"
#include "ravel/verbs.h"

namespace ravel::tool {
namespace {

struct Options {
    std::string recipe, output, to;
    bool list = false, force = false, binary = false;
};

ExitCode list() {
    std::size_t width = 0;
    for (const auto& help : make::recipe_help()) width = std::max(width, help.pattern.size());
    for (const auto& help : make::recipe_help())
        fmt::print("{:<{}}  {}\n", help.pattern, width, help.says);
    return ExitCode::done;
}

ExitCode run(const Options& options) {
    if (options.list) return list();
    if (options.recipe.empty() || options.output.empty()) {
        say("make needs a RECIPE and -o MESH, or --list");
        return ExitCode::usage;
    }
    if (Status status = may_write(options.output, options.force); !status)
        return complain("", status.error());
    auto mesh = make::make_mesh(options.recipe);
    if (!mesh) return complain("", mesh.error());
    io::WriteOptions format;
    format.binary = options.binary;
    std::vector<std::string> left_out;
    if (Status status =
            write_mesh_output(*mesh, options.output, options.to, format, options.force, &left_out);
        !status)
        return complain(options.output, status.error());
    remark_each(options.output, left_out);
    remark(fmt::format("{}: {} {}s, {} vertices", options.output, mesh->cell_count(),
                       name_of(mesh->kind), mesh->point_count()));
    return ExitCode::done;
}

}  // namespace

void add_make(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb =
        app.add_subcommand("make", "Make a mesh from a recipe, the same on every machine");
    verb->add_option("RECIPE", options->recipe, "E.g. torus:quads=10000,seed=1");
    verb->add_option("-o,--output", options->output, "The mesh; its ending tells the format");
    verb->add_flag("-f,--force", options->force, "Overwrite the output");
    verb->add_option("--to", options->to, "Format of a mesh that goes to stdout")
        ->type_name("ENDING");
    verb->add_flag("--binary", options->binary, "The binary kind of formats that have both");
    verb->add_flag("--list", options->list, "All recipes");
    verb->footer(
        "Examples:\n"
        "  ravel make --list\n"
        "  ravel make torus:quads=10000,seed=1 -o torus.obj\n"
        "  ravel make tets:box=20x20x20,jitter=0.2,seed=7 -o box.vtk\n"
        "  ravel make soup:polygons=200,seed=3 -o soup.ply");
    verb->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace ravel::tool
