// ravel VERB [options] INPUT [-o OUTPUT]
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

#include <fmt/core.h>

#include "ravel/interrupt.h"
#include "ravel/talk.h"
#include "ravel/verbs.h"

namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  ravel make torus:quads=10000 -o torus.obj\n"
    "  ravel encode torus.obj -o torus.ravel --position-bits 14\n"
    "  ravel decode torus.ravel -o again.obj\n"
    "  ravel verify torus.obj\n"
    "  ravel compare torus.obj --position-bits 14\n"
    "\n"
    "`ravel VERB --help` says more. Results go to stdout, talk to stderr; `-` is stdin or stdout.\n"
    "Exit codes: 0 done, 1 the answer is no, 2 usage, 3 a file can't be read or written,\n"
    "4 corrupt .ravel file, 5 a bug in ravel.";

int run(int argc, char** argv) {
    using namespace ravel::tool;
    CLI::App app{"Packs polygon and tetrahedral meshes by winding all cells onto one strip.",
                 "ravel"};
    app.footer(kFooter);
    app.set_version_flag("--version", "ravel " RAVEL_VERSION);
    app.require_subcommand(1);
    bool quiet = false;
    app.add_flag("-q,--quiet", quiet, "No remarks on stderr, complaints only");
    Action action;
    add_encode(app, action);
    add_decode(app, action);
    add_info(app, action);
    add_verify(app, action);
    add_strip(app, action);
    add_compare(app, action);
    add_make(app, action);
    add_view(app, action);
    for (CLI::App* verb : app.get_subcommands({})) verb->fallthrough();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const int code = app.exit(error);
        return code == 0 ? 0 : static_cast<int>(ExitCode::usage);
    }
    set_quiet(quiet);
    return static_cast<int>(action());
}

// Results that could not be written are no success, whatever the verb says.
int after_flush(int code) {
    std::cout.flush();
    const bool lost = std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout;
    if (!lost) return code;
    ravel::tool::say("standard output can't be written");
    return code == 0 ? static_cast<int>(ravel::tool::ExitCode::unreadable) : code;
}

}  // namespace

int main(int argc, char** argv) {
    ravel::tool::watch_signals();
    try {
        return after_flush(run(argc, argv));
    } catch (const std::bad_alloc&) {
        ravel::tool::say("out of memory");
        return static_cast<int>(ravel::tool::ExitCode::unreadable);
    } catch (const std::exception& error) {
        ravel::tool::say(std::string("this is a bug, please report it: ") + error.what());
    } catch (...) {
        ravel::tool::say("this is a bug, please report it");
    }
    return static_cast<int>(ravel::tool::ExitCode::bug);
}
