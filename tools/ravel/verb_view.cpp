// ravel view FILE: the viewer, served to the browsers of this machine.
#include <filesystem>

#include <fmt/format.h>

#include "ravel/encode_options.h"
#include "ravel/input_file.h"
#include "ravel/loopback_server.h"
#include "ravel/progress.h"
#include "ravel/talk.h"
#include "ravel/verbs.h"
#include "ravel/viewer_page.h"

namespace ravel::tool {
namespace {

struct Options {
    std::string input;
    std::uint16_t port = 0;
    EncodeFlags flags;
};

// The file to show: as it is, even a broken one (the viewer says what is wrong with it), or packed.
Result<std::vector<std::byte>> file_to_show(const Options& options) {
    if (is_ravel_name(options.input)) return read_bytes(options.input);
    Progress progress(options.input, "reading");
    auto mesh = read_mesh_input(options.input, "");
    if (!mesh) return mesh.error();
    progress.now(fmt::format("packing {} {}s", mesh->cell_count(), name_of(mesh->kind)));
    auto packed = encode(*mesh, options_of(options.flags));
    if (!packed) return packed.error();
    return std::move(packed->bytes);
}

ExitCode run(const Options& options) {
    const std::string name = std::filesystem::path(options.input).filename().string();
    Json file;
    file["name"] = name;
    file["url"] = "mesh.ravel";
    Json data;
    data["files"] = Json::array({file});
    const auto page = viewer_page(data);
    if (!page) return complain("", page.error());
    const auto bytes = file_to_show(options);
    if (!bytes) return complain(options.input, bytes.error());
    const std::map<std::string, Document> documents = {
        {"/", {"text/html; charset=utf-8", *page}},
        {"/mesh.ravel",
         {"application/octet-stream",
          {reinterpret_cast<const char*>(bytes->data()), bytes->size()}}},
    };
    return complain("", serve_on_loopback(documents, options.port, [&](std::uint16_t port) {
                        fmt::print("http://127.0.0.1:{}/\n", port);
                        std::fflush(stdout);
                        remark(fmt::format("showing {} there until Ctrl-C", name));
                    }));
}

}  // namespace

void add_view(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand("view", "Look at a mesh and its strip in a browser");
    verb->add_option("FILE", options->input, "A .ravel file, or a mesh, which is packed first")
        ->required();
    verb->add_option("--port", options->port, "Port on 127.0.0.1; any free one if not given");
    add_encode_flags(*verb, options->flags);
    add_threads_flag(*verb, options->flags);
    verb->footer(
        "Prints an address that only this machine can reach, and serves the viewer's page and "
        "this\n"
        "one file there until Ctrl-C. The page needs no network and can also be saved and opened "
        "as\n"
        "a file; meshes dropped on it stay in the browser.\n\n"
        "Example:\n"
        "  ravel view chair.obj --port 8080");
    verb->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace ravel::tool
