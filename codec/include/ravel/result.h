// Errors as values. A function that can fail on input returns Result<T>: either the value or an
// Error that says what is wrong (code), where (at) and in one sentence what a user can do (detail).
// Nothing in codec/ throws across its interface because of the bytes or the mesh it was given.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace ravel {

enum class Code : std::uint8_t {
    not_a_ravel_file,     // the magic bytes are missing
    unsupported_version,  // written by a newer ravel
    truncated,            // the bytes end before the data does
    checksum_mismatch,    // the bytes are not those that were written
    corrupt,              // a value that no encoder writes
    limit_exceeded,       // more than the caller, or one block, allows
    bad_option,           // options that contradict each other or are out of range
    bad_mesh,             // a Mesh that breaks its own invariants (see ravel/mesh.h)
    unreadable,           // a mesh file that can't be read
    unwritable,           // a file that can't be written, or a format that can't hold the mesh
};

// The spelling used in messages and in JSON, e.g. "checksum_mismatch".
const char* name_of(Code code);

struct Error {
    Code code = Code::corrupt;
    std::uint64_t at =
        0;               // byte offset for bytes, cell or attribute index for meshes, line for text
    std::string detail;  // one sentence, no trailing newline
};

template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : value_(std::move(value)) {}
    Result(Error error) : error_(std::move(error)) {}

    explicit operator bool() const { return ok(); }
    bool ok() const { return value_.has_value(); }

    T& operator*() { return *value_; }
    const T& operator*() const { return *value_; }
    T* operator->() { return &*value_; }
    const T* operator->() const { return &*value_; }

    Error& error() { return error_; }
    const Error& error() const { return error_; }

  private:
    std::optional<T> value_;
    Error error_;  // of those without a value
};

// For functions that return nothing but may fail.
struct Done {};
using Status = Result<Done>;

}  // namespace ravel
