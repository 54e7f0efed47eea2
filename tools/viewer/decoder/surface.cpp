#include "decoder/surface.h"

#include <algorithm>
#include <array>
#include <bit>

namespace ravel::web {
namespace {

constexpr std::uint8_t kFacet[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

using Key = std::array<std::uint32_t, 3>;

Key key_of(std::span<const std::uint32_t> corners, std::uint32_t facet) {
    const std::uint32_t* tet = &corners[facet & ~3u];
    const auto& of = kFacet[facet & 3];
    Key key{tet[of[0]], tet[of[1]], tet[of[2]]};
    if (key[0] > key[1]) std::swap(key[0], key[1]);
    if (key[1] > key[2]) std::swap(key[1], key[2]);
    if (key[0] > key[1]) std::swap(key[0], key[1]);
    return key;
}

std::uint32_t hash_of(const Key& key) {
    std::uint64_t h = key[0] * 0x9E3779B97F4A7C15u;
    h = (h ^ h >> 32 ^ key[1]) * 0xD6E8FEB86659FD93u;
    h = (h ^ h >> 32 ^ key[2]) * 0xA0761D6478BD642Fu;
    return static_cast<std::uint32_t>(h >> 32);
}

}  // namespace

Surface boundary_of(std::span<const std::uint32_t> corners) {
    const auto facets = static_cast<std::uint32_t>(corners.size());
    // Open addressing, at most half full: the first facet of each key, plus one.
    const std::size_t slots = std::bit_ceil(std::size_t{facets} + 1);
    std::vector<std::uint32_t> table(slots, 0);
    std::vector<bool> shared(facets, false);
    Surface surface;
    for (std::uint32_t f = 0; f < facets; ++f) {
        const Key key = key_of(corners, f);
        std::size_t slot = hash_of(key) & (slots - 1);
        while (table[slot] != 0 && key_of(corners, table[slot] - 1) != key)
            slot = (slot + 1) & (slots - 1);
        if (table[slot] == 0)
            table[slot] = f + 1;
        else
            shared[table[slot] - 1] = shared[f] = true;
    }
    for (std::uint32_t f = 0; f < facets; ++f) {
        if (shared[f]) continue;
        surface.facets.push_back(f);
        for (const std::uint8_t corner : kFacet[f & 3])
            surface.points.push_back(corners[(f & ~3u) + corner]);
    }
    return surface;
}

}  // namespace ravel::web
