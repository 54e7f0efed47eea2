// Names and numbers of the C interface beside those of the C++ one.
#include <algorithm>
#include <cstring>

#include "c/handle.h"

namespace ravel::c {
namespace {

int code_of(Code code) {
    switch (code) {
        case Code::not_a_ravel_file:
            return RAVEL_NOT_A_RAVEL_FILE;
        case Code::unsupported_version:
            return RAVEL_UNSUPPORTED_VERSION;
        case Code::truncated:
            return RAVEL_TRUNCATED;
        case Code::checksum_mismatch:
            return RAVEL_CHECKSUM_MISMATCH;
        case Code::corrupt:
            return RAVEL_CORRUPT;
        case Code::limit_exceeded:
            return RAVEL_LIMIT_EXCEEDED;
        case Code::bad_option:
            return RAVEL_BAD_OPTION;
        case Code::bad_mesh:
            return RAVEL_BAD_MESH;
        case Code::unreadable:
        case Code::unwritable:
            break;  // codes of files, which this interface does not open
    }
    return RAVEL_BUG;
}

static_assert(static_cast<int>(Scalar::u8) == RAVEL_U8 &&
              static_cast<int>(Scalar::u32) == RAVEL_U32 &&
              static_cast<int>(Scalar::u64) == RAVEL_U64 &&
              static_cast<int>(Scalar::f64) == RAVEL_F64);
static_assert(static_cast<int>(Place::point) == RAVEL_ON_POINTS &&
              static_cast<int>(Place::mesh) == RAVEL_ON_MESH);
static_assert(static_cast<int>(CellKind::polygon) == RAVEL_POLYGONS &&
              static_cast<int>(CellKind::tet) == RAVEL_TETS);
static_assert(kNoIndex == UINT64_MAX);

}  // namespace

int fail(ravel_error* error, int code, std::string_view sentence, std::uint64_t place) {
    if (error != nullptr) {
        *error = {};
        error->code = code;
        error->place = place;
        const std::size_t size = std::min(sentence.size(), sizeof error->sentence - 1);
        std::memcpy(error->sentence, sentence.data(), size);
    }
    return code;
}

int fail(ravel_error* error, const Error& why) {
    return fail(error, code_of(why.code), why.detail, why.at);
}

}  // namespace ravel::c

extern "C" {

uint32_t ravel_abi(void) {
    return RAVEL_ABI;
}

const char* ravel_code_name(int code) {
    switch (code) {
        case RAVEL_DONE:
            return "done";
        case RAVEL_NOT_A_RAVEL_FILE:
            return "not_a_ravel_file";
        case RAVEL_UNSUPPORTED_VERSION:
            return "unsupported_version";
        case RAVEL_TRUNCATED:
            return "truncated";
        case RAVEL_CHECKSUM_MISMATCH:
            return "checksum_mismatch";
        case RAVEL_CORRUPT:
            return "corrupt";
        case RAVEL_LIMIT_EXCEEDED:
            return "limit_exceeded";
        case RAVEL_BAD_OPTION:
            return "bad_option";
        case RAVEL_BAD_MESH:
            return "bad_mesh";
        case RAVEL_BAD_ARGUMENT:
            return "bad_argument";
        case RAVEL_TOO_SMALL:
            return "too_small";
        case RAVEL_OUT_OF_MEMORY:
            return "out_of_memory";
        case RAVEL_BUG:
            return "bug";
        default:
            return "unknown";
    }
}

size_t ravel_scalar_size(int scalar) {
    return scalar >= 0 && scalar <= RAVEL_F64 ? ravel::size_of(static_cast<ravel::Scalar>(scalar))
                                              : 0;
}
}
