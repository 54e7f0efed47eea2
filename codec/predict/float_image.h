// Floats as integers of the same order: -inf < negative < -0 < +0 < positive < inf, NaNs at both
// ends. The map is one to one on bit patterns, so differences of images keep every bit.
#pragma once

#include <bit>
#include <cstdint>

namespace ravel {

inline std::uint64_t image_of(std::uint32_t bits) {
    return bits & 0x80000000u ? static_cast<std::uint32_t>(~bits) : bits | 0x80000000u;
}
inline std::uint32_t bits32_of(std::uint64_t image) {
    const auto i = static_cast<std::uint32_t>(image);
    return i & 0x80000000u ? i & 0x7FFFFFFFu : ~i;
}
inline std::uint64_t image_of(std::uint64_t bits) {
    return bits >> 63 ? ~bits : bits | std::uint64_t{1} << 63;
}
inline std::uint64_t bits64_of(std::uint64_t image) {
    return image >> 63 ? image & ~(std::uint64_t{1} << 63) : ~image;
}

// The difference a - b of two 32-bit (or 64-bit) images, wrapped and with sign.
inline std::int64_t wrapped_difference(std::uint64_t a, std::uint64_t b, bool narrow) {
    const std::uint64_t d = a - b;
    return narrow ? static_cast<std::int32_t>(static_cast<std::uint32_t>(d))
                  : static_cast<std::int64_t>(d);
}

}  // namespace ravel
