// What an interrupted run leaves behind: nothing. SIGINT, SIGTERM and SIGHUP remove the temporary
// folders, then end the program as they would have; a closed pipe or a full quota is an error where
// it is met, no sudden end. (SIGKILL may leave a hidden folder, but never half an output.)
#pragma once

#include <filesystem>
#include <functional>

#include "ravel/result.h"

namespace ravel::tool {

// Before any thread is started; signals that the caller ignores stay ignored.
void watch_signals();

// A new folder `parent`/.ravel-XXXXXX that goes when a signal ends the program.
Result<std::filesystem::path> make_leftover(const std::filesystem::path& parent);
// Removes it now.
void remove_leftover(const std::filesystem::path& folder);

// Runs `work` whole: a signal waits for its end.
Status without_interruption(const std::function<Status()>& work);

}  // namespace ravel::tool
