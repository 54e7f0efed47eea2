// Every verb declares its options to CLI11 and leaves behind what to do once they are read.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "ravel/exit_code.h"

namespace ravel::tool {

using Action = std::function<ExitCode()>;

void add_encode(CLI::App& app, Action& action);
void add_decode(CLI::App& app, Action& action);
void add_info(CLI::App& app, Action& action);
void add_verify(CLI::App& app, Action& action);
void add_strip(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_make(CLI::App& app, Action& action);
void add_view(CLI::App& app, Action& action);

}  // namespace ravel::tool
