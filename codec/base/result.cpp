#include "ravel/result.h"

namespace ravel {

const char* name_of(Code code) {
    switch (code) {
        case Code::not_a_ravel_file:
            return "not_a_ravel_file";
        case Code::unsupported_version:
            return "unsupported_version";
        case Code::truncated:
            return "truncated";
        case Code::checksum_mismatch:
            return "checksum_mismatch";
        case Code::corrupt:
            return "corrupt";
        case Code::limit_exceeded:
            return "limit_exceeded";
        case Code::bad_option:
            return "bad_option";
        case Code::bad_mesh:
            return "bad_mesh";
        case Code::unreadable:
            return "unreadable";
        case Code::unwritable:
            return "unwritable";
    }
    return "unknown";
}

}  // namespace ravel
