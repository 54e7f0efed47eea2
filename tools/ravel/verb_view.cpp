// ravel view FILE: a place kept for the viewer.
#include <fmt/format.h>

#include "ravel/verbs.h"

namespace ravel::tool {

void add_view(CLI::App& app, Action& action) {
    CLI::App* verb = app.add_subcommand("view", "Look at a mesh (not in this version)");
    auto file = std::make_shared<std::string>();
    verb->add_option("FILE", *file, "A .ravel file or a mesh");
    verb->footer(
        "The viewer is not part of this version. `ravel strip MESH -o strip.vtk` writes the strip\n"
        "as cell data that any viewer of VTK files can colour.");
    verb->callback([file, &action] {
        action = [file] {
            fmt::print(
                stderr,
                "ravel: the viewer is not part of this version; `ravel strip MESH -o strip.vtk` "
                "writes the strip for any viewer of VTK files\n");
            return ExitCode::usage;
        };
    });
}

}  // namespace ravel::tool
