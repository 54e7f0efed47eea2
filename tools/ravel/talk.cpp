#include "ravel/talk.h"

#include <fmt/core.h>

#include <atomic>
#include <cstdio>

namespace ravel::tool {
namespace {

bool quiet_flag = false;
std::atomic<bool> line_shown = false;

}  // namespace

void set_quiet(bool quiet) {
    quiet_flag = quiet;
}

bool is_quiet() {
    return quiet_flag;
}

void set_line_shown(bool shown) {
    line_shown = shown;
}

void say(std::string_view sentence) {
    // Not by fmt::print, which throws where stderr can't be written.
    const char* wipe = line_shown ? "\r\033[K" : "";
    std::fputs(fmt::format("{}ravel: {}\n", wipe, sentence).c_str(), stderr);
}

void remark(std::string_view sentence) {
    if (!quiet_flag) say(sentence);
}

void remark_each(std::string_view file, const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) remark(fmt::format("{}: {}", file, sentence));
}

ExitCode complain(std::string_view file, const Error& error) {
    // Readers of mesh files name file and place themselves.
    const bool names_file = file.empty() || error.detail.find(file) != std::string::npos;
    std::string place;
    const ExitCode code = exit_code_of(error.code);
    if (code == ExitCode::corrupt)
        place = fmt::format(" ({}, byte {})", name_of(error.code), error.at);
    say(fmt::format("{}{}{}{}", names_file ? "" : file, names_file ? "" : ": ", error.detail,
                    place));
    return code;
}

ExitCode complain_of_mesh(std::string_view file, const Error& error) {
    const ExitCode code = complain(file, error);
    return code == ExitCode::corrupt ? ExitCode::unreadable : code;
}

}  // namespace ravel::tool
