// What models know before the first flag: a letter per context.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "entropy/flag_model.h"

namespace ravel {

// Chance of "yes" in 1/65536 for the letters `A` .. `e`; `P` is even, and so is what has no letter.
inline constexpr int kPriorLetters = 31;
inline constexpr std::array<std::uint16_t, 16> kPriorChance{
    39,   98,    262,   590,   1180,  2294,  3932,  5898,
    8520, 11796, 15073, 19005, 22938, 26870, 30147, 32768};

inline constexpr std::uint16_t chance_of_letter(char letter) {
    const int i = letter >= 'a' ? letter - 'a' + 26 : letter - 'A';
    if (i < 0 || i >= kPriorLetters) return 32768;
    return i < 16
               ? kPriorChance[static_cast<std::size_t>(i)]
               : static_cast<std::uint16_t>(65535 - kPriorChance[static_cast<std::size_t>(30 - i)]);
}

// `count` models; those whose letter is not `P` start as if `seen` flags had come.
inline std::vector<FlagModel> models_of(std::string_view letters, std::size_t count,
                                        std::uint16_t seen) {
    std::vector<FlagModel> models(count);
    for (std::size_t i = 0; i < letters.size() && i < count; ++i)
        if (letters[i] != 'P') models[i] = FlagModel(chance_of_letter(letters[i]), seen);
    return models;
}

}  // namespace ravel
