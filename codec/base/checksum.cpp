#include "base/checksum.h"

#include <array>

namespace ravel {
namespace {

// Eight tables let the loop take eight bytes a step. Filled when the program starts: stored, they
// would be a tenth of a decoder for the web.
struct Tables {
    std::array<std::array<std::uint32_t, 256>, 8> t{};
    Tables() {
        for (std::uint32_t i = 0; i < 256; ++i) {
            std::uint32_t c = i;
            for (int k = 0; k < 8; ++k) c = (c >> 1) ^ (c & 1 ? 0x82F63B78u : 0u);
            t[0][i] = c;
        }
        for (std::uint32_t i = 0; i < 256; ++i)
            for (std::size_t s = 1; s < 8; ++s)
                t[s][i] = (t[s - 1][i] >> 8) ^ t[0][t[s - 1][i] & 0xFF];
    }
};
const Tables kTables;

}  // namespace

std::uint32_t crc32c(std::span<const std::byte> bytes) {
    const auto at = [&](std::size_t i) { return static_cast<std::uint32_t>(bytes[i]); };
    std::uint32_t c = ~0u;
    std::size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) {
        const std::uint32_t low = c ^ (at(i) | at(i + 1) << 8 | at(i + 2) << 16 | at(i + 3) << 24);
        c = kTables.t[7][low & 0xFF] ^ kTables.t[6][(low >> 8) & 0xFF] ^
            kTables.t[5][(low >> 16) & 0xFF] ^ kTables.t[4][low >> 24] ^ kTables.t[3][at(i + 4)] ^
            kTables.t[2][at(i + 5)] ^ kTables.t[1][at(i + 6)] ^ kTables.t[0][at(i + 7)];
    }
    for (; i < bytes.size(); ++i) c = (c >> 8) ^ kTables.t[0][(c ^ at(i)) & 0xFF];
    return ~c;
}

}  // namespace ravel
