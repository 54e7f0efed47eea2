// Whole files in and out of memory, with errors that name the file and say what is wrong.
#pragma once

#include <string>
#include <string_view>

#include "ravel/result.h"

namespace ravel::io {

// The bytes of the file; the error tells a missing file, a directory and a forbidden one apart.
Result<std::string> read_file(const std::string& path);

// Creates or replaces the file; a full disk is an error and not a short file.
Status write_file(const std::string& path, std::string_view bytes);

bool file_exists(const std::string& path);

// "FILE: byte N: sentence", for binary files.
Error byte_error(const std::string& path, std::uint64_t byte, const std::string& sentence);

}  // namespace ravel::io
