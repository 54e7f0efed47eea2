// What the tool says besides its results: on stderr, one line a time.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ravel/exit_code.h"
#include "ravel/result.h"

namespace ravel::tool {

// "ravel: SENTENCE" on stderr, whether it can be written or not.
void say(std::string_view sentence);
// Remarks are silenced by --quiet; complaints are not.
void set_quiet(bool quiet);
bool is_quiet();
// A line without an end stands on stderr: whoever speaks next wipes it.
void set_line_shown(bool shown);
void remark(std::string_view sentence);
void remark_each(std::string_view file, const std::vector<std::string>& sentences);

// Prints "ravel: FILE: what is wrong" and gives the exit code that goes with it.
ExitCode complain(std::string_view file, const Error& error);
// The same for an error met while packing: a mesh too large is a mesh refused.
ExitCode complain_of_mesh(std::string_view file, const Error& error);

}  // namespace ravel::tool
