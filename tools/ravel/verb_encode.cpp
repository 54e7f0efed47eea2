// ravel encode MESH -o FILE.ravel
#include <fmt/format.h>

#include <filesystem>

#include "io/mesh_io.h"
#include "ravel/encode_options.h"
#include "ravel/input_file.h"
#include "ravel/output_file.h"
#include "ravel/progress.h"
#include "ravel/talk.h"
#include "ravel/verbs.h"

namespace ravel::tool {
namespace {

struct Options {
    std::string mesh, output, from;
    bool force = false;
    EncodeFlags flags;
};

ExitCode run(const Options& options) {
    if (Status status = may_write(options.output, options.force); !status)
        return complain("", status.error());
    std::error_code ignored;
    if (options.mesh != "-" && std::filesystem::equivalent(options.mesh, options.output, ignored))
        return complain("", {Code::bad_option, 0, options.output + " is the mesh itself"});
    Progress progress(options.mesh, "reading");
    auto mesh = read_mesh_input(options.mesh, options.from);
    if (!mesh) return complain(options.mesh, mesh.error());
    progress.now(fmt::format("packing {} {}s", mesh->cell_count(), name_of(mesh->kind)));
    auto packed = encode(*mesh, options_of(options.flags));
    if (!packed) return complain_of_mesh(options.mesh, packed.error());
    progress.now("writing");
    if (Status status = write_bytes_output(options.output, packed->bytes, options.force); !status)
        return complain(options.output, status.error());
    const double cells = static_cast<double>(mesh->cell_count());
    const double bits = cells > 0 ? 8.0 * static_cast<double>(packed->bytes.size()) / cells : 0;
    remark(fmt::format(
        "{}: {} {}s on {} strip{}, {} bytes, {:.2f} bits per cell, positions {}", options.output,
        mesh->cell_count(), name_of(mesh->kind), packed->strip.components,
        packed->strip.components == 1 ? "" : "s", packed->bytes.size(), bits,
        packed->position_bound == 0 ? std::string("exact")
                                    : fmt::format("within {:.3g}", packed->position_bound)));
    return ExitCode::done;
}

}  // namespace

void add_encode(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand("encode", "Pack a mesh into a .ravel file");
    std::string endings;
    for (const std::string& ending : io::known_endings()) endings += " " + ending;
    verb->add_option("MESH", options->mesh, "The mesh; its ending tells the format")->required();
    verb->add_option("-o,--output", options->output, "The .ravel file")->required();
    verb->add_flag("-f,--force", options->force, "Overwrite the output");
    verb->add_option("--from", options->from, "Format of a mesh that comes by stdin")
        ->type_name("ENDING");
    add_encode_flags(*verb, options->flags);
    add_threads_flag(*verb, options->flags);
    verb->footer("Endings that can be read:" + endings +
                 "\n\nExamples:\n"
                 "  ravel encode chair.obj -o chair.ravel                      to the last bit\n"
                 "  ravel encode chair.obj -o chair.ravel --position-bits 14\n"
                 "  ravel encode part.msh -o part.ravel --max-error 0.001 --keep-order\n"
                 "  cat chair.obj | ravel encode - --from obj -o - > chair.ravel");
    verb->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace ravel::tool
