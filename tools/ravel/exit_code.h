// What the shell sees.
#pragma once

#include "ravel/result.h"

namespace ravel::tool {

enum class ExitCode : int {
    done = 0,
    no = 1,          // the answer is no: verify found a difference
    usage = 2,       // options that make no sense, or an output that exists
    unreadable = 3,  // a file that can't be read or written, a mesh that is refused
    corrupt = 4,     // bytes that are not a whole .ravel file
    bug = 5,         // ours, please report it
};

inline ExitCode exit_code_of(Code code) {
    switch (code) {
        case Code::not_a_ravel_file:
        case Code::unsupported_version:
        case Code::truncated:
        case Code::checksum_mismatch:
        case Code::corrupt:
            return ExitCode::corrupt;
        case Code::bad_option:
            return ExitCode::usage;
        case Code::bad_mesh:
        case Code::limit_exceeded:
        case Code::unreadable:
        case Code::unwritable:
            return ExitCode::unreadable;
    }
    return ExitCode::bug;
}

}  // namespace ravel::tool
