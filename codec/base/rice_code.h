// How a Rice code [Rice1979] is laid out: the quotient as so many `0` and a `1`, then the rest. A
// quotient of kRiceEscape or more is kRiceEscape times `0`, then in six bits how many bits more
// follow, and these: the number less the first one that has such a quotient.
#pragma once

#include <bit>
#include <cstdint>

namespace ravel {

inline constexpr int kRiceEscape = 16;

// The least number, its rest having `count` bits, that is told by kRiceEscape.
inline std::uint64_t first_escaped(int count) {
    return std::uint64_t{kRiceEscape} << count;
}
// Bits of the code of a number whose rest has `count` bits.
inline int rice_bits(std::uint64_t value, int count) {
    const std::uint64_t escaped = first_escaped(count);
    if (value < escaped) return static_cast<int>(value >> count) + 1 + count;
    return kRiceEscape + 6 + static_cast<int>(std::bit_width(value - escaped));
}

}  // namespace ravel
