// "torus:quads=10000,seed=1": a family, then flags and key=value pairs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ravel/result.h"

namespace ravel::make {

struct Recipe {
    struct Word {
        std::string key;
        std::string value;  // empty for a flag
        bool used = false;
    };
    std::string text;
    std::string family;
    std::vector<Word> words;
    std::string complaint;  // the first value that made no sense

    bool has(std::string_view key);
    // Values outside [low, high] and words that are no number are complaints.
    std::uint64_t integer(std::string_view key, std::uint64_t otherwise, std::uint64_t low,
                          std::uint64_t high);
    double number(std::string_view key, double otherwise, double low, double high);
    // "20x30x40", or "20" for all; missing ones repeat the last.
    void sizes(std::string_view key, std::uint64_t* values, int count, std::uint64_t high);
    // Empty when every word was asked for and made sense.
    std::string verdict() const;
};

Recipe parse_recipe(std::string_view text);

}  // namespace ravel::make
