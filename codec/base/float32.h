// Rounds a double to float32 and back, by its bits. Written as two casts, GCC 12 leaves both out
// where it makes vectors of them (it takes the type between for as precise as the outer one), and
// then a value is another one by what surrounds it in a loop.
#pragma once

#include <bit>
#include <cstdint>

namespace ravel {

// The value of static_cast<float>(x), every bit of it, that of a NaN too.
inline double to_float32(double x) {
    constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
    constexpr std::uint64_t kCut = 0x1FFFFFFF;  // bits a float32 has no place for
    constexpr std::uint64_t kInfinite = std::uint64_t{0x7FF} << 52;
    constexpr std::uint64_t kQuiet = std::uint64_t{1} << 51;          // conversion quiets a NaN
    constexpr std::uint64_t kLeastNormal = std::uint64_t{897} << 52;  // 2^-126
    constexpr std::uint64_t kTooLarge = std::uint64_t{1151} << 52;    // 2^128
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t sign = bits & kSign;
    std::uint64_t size = bits ^ sign;
    if (size > kInfinite) {
        size = (size | kQuiet) & ~kCut;
    } else if (size < kLeastNormal) {
        // Beside 2^-97 a double's last place is 2^-149, the least float32: the sum rounds as one.
        size = std::bit_cast<std::uint64_t>((std::bit_cast<double>(size) + 0x1p-97) - 0x1p-97);
    } else {
        size = (size + (kCut >> 1) + (size >> 29 & 1)) & ~kCut;  // ties to even
        if (size >= kTooLarge) size = kInfinite;
    }
    return std::bit_cast<double>(sign | size);
}

}  // namespace ravel
