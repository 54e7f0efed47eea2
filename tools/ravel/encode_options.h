// The options that encode, verify and compare share.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "ravel/ravel.h"

namespace ravel::tool {

struct EncodeFlags {
    int position_bits = 0;  // 0: not given
    double max_error = 0;   // 0: not given
    double max_error_relative = 0;
    double lattice = 0;
    bool lossless = false;
    bool float32 = false;
    bool keep_order = false;
    std::vector<AttributeOptions> attributes;
    double strip_budget = -1;  // negative: not given
    bool fast = false;
    int level = 0;    // 0: not given
    int threads = 1;  // 0: all there are
};

void add_encode_flags(CLI::App& verb, EncodeFlags& flags);
// For verbs that are not to be timed.
void add_threads_flag(CLI::App& verb, EncodeFlags& flags);
EncodeOptions options_of(const EncodeFlags& flags);

// "14 bits", "error <= 0.001", "lossless", with the other options that differ from their defaults.
std::string words_for(const EncodeOptions& options);

}  // namespace ravel::tool
