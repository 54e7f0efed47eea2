// Contexts are numbers: encoder and decoder keep one adaptive model for each. Blocks of contexts
// stand one after the other.
#pragma once

#include <algorithm>
#include <cstdint>

namespace ravel {

using Context = std::uint32_t;

// A block of contexts with up to four small coordinates; each is clamped into its range.
struct ContextBlock {
    Context base = 0;
    std::uint32_t a = 1, b = 1, c = 1, d = 1;

    constexpr Context end() const { return base + a * b * c * d; }
    constexpr Context at(std::uint32_t i, std::uint32_t j = 0, std::uint32_t k = 0,
                         std::uint32_t l = 0) const {
        i = std::min(i, a - 1), j = std::min(j, b - 1), k = std::min(k, c - 1),
        l = std::min(l, d - 1);
        return base + ((i * b + j) * c + k) * d + l;
    }
};

// Numbers are coded as the unary count of their bits, each step under its own context, and the bits
// below the highest as they are.
inline constexpr std::uint32_t kNumberSteps = 64;

}  // namespace ravel
