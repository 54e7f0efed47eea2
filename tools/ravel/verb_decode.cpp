// ravel decode FILE.ravel -o MESH
#include <fmt/format.h>

#include "io/mesh_io.h"
#include "ravel/input_file.h"
#include "ravel/output_file.h"
#include "ravel/progress.h"
#include "ravel/ravel.h"
#include "ravel/strip_of_steps.h"
#include "ravel/strip_output.h"
#include "ravel/talk.h"
#include "ravel/triangulate.h"
#include "ravel/verbs.h"
#include "strip/build.h"

namespace ravel::tool {
namespace {

struct Options {
    std::string file, output, to;
    bool force = false, strip = false, triangles = false, binary = false;
    double memory_gib = 16;
};

Result<Mesh> strip_mesh_of(const Decoded& decoded) {
    auto complex = build_complex(decoded.mesh);
    if (!complex) return complex.error();
    if (!decoded.wants_mending) {
        auto strip = strip_of_steps(*complex, decoded.steps);
        if (strip) return mesh_of_strip(decoded.mesh, *complex, *strip);
        // Cells that could be glued in several ways may be glued otherwise than they were packed.
        remark(strip.error().detail + "; the strip is mended");
    }
    return mesh_of_strip(decoded.mesh, *complex, build_strip(*complex));
}

ExitCode complain_of_limit(const Options& options, Error error) {
    if (error.code == Code::limit_exceeded)
        error.detail += fmt::format("; --memory {} (GiB) refuses it, a larger number may not",
                                    options.memory_gib);
    return complain(options.file, error);
}

ExitCode run(const Options& options) {
    if (Status status = may_write(options.output, options.force); !status)
        return complain("", status.error());
    Progress progress(options.file, "reading");
    auto bytes = read_bytes(options.file);
    if (!bytes) return complain(options.file, bytes.error());
    DecodeOptions limits;
    limits.memory_limit = static_cast<std::uint64_t>(options.memory_gib * 1073741824.0);
    limits.steps = options.strip;
    progress.now("unpacking");
    auto decoded = decode(*bytes, limits);
    if (!decoded) return complain_of_limit(options, decoded.error());
    *bytes = {};
    Mesh mesh;
    if (options.strip) {
        progress.now("splitting cells");
        auto subdivided = strip_mesh_of(*decoded);
        if (!subdivided) return complain(options.file, subdivided.error());
        mesh = std::move(*subdivided);
    } else {
        mesh = std::move(decoded->mesh);
    }
    if (options.triangles) mesh = triangulate(mesh);
    progress.now(fmt::format("writing {} {}s", mesh.cell_count(), name_of(mesh.kind)));
    io::WriteOptions format;
    format.binary = options.binary;
    std::vector<std::string> left_out;
    if (Status status =
            write_mesh_output(mesh, options.output, options.to, format, options.force, &left_out);
        !status)
        return complain(options.output, status.error());
    remark_each(options.output, left_out);
    remark(fmt::format("{}: {} {}s, {} vertices", options.output, mesh.cell_count(),
                       name_of(mesh.kind), mesh.point_count()));
    return ExitCode::done;
}

}  // namespace

void add_decode(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand("decode", "Unpack a .ravel file into a mesh");
    std::string endings;
    for (const std::string& ending : io::known_endings()) endings += " " + ending;
    verb->add_option("FILE", options->file, "The .ravel file")->required();
    verb->add_option("-o,--output", options->output, "The mesh; its ending tells the format")
        ->required();
    verb->add_flag("-f,--force", options->force, "Overwrite the output");
    verb->add_option("--to", options->to, "Format of a mesh that goes to stdout")
        ->type_name("ENDING");
    verb->add_flag("--binary", options->binary, "The binary kind of formats that have both");
    verb->add_flag(
        "--strip", options->strip,
        "The subdivided mesh with its single strip: cells in strip order, with cell data "
        "strip_position and parent");
    verb->add_flag("--triangulate", options->triangles,
                   "Cut every polygon into the fan of triangles from its first corner");
    verb->add_option("--memory", options->memory_gib, "Refuse files that need more memory, in GiB")
        ->check(CLI::Range(0.001, 65536.0))
        ->capture_default_str()
        ->type_name("GIB");
    verb->footer("Endings that can be written:" + endings +
                 "\n\nExamples:\n"
                 "  ravel decode chair.ravel -o chair.obj\n"
                 "  ravel decode chair.ravel -o strip.vtk --strip\n"
                 "  ravel decode - -o - --to off < chair.ravel > chair.off");
    verb->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace ravel::tool
