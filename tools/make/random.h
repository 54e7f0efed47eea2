// The corpus' own generator: the same numbers on every machine and with every standard library.
#pragma once

#include <cstdint>

namespace ravel::make {

// splitmix64 (Steele, Lea, Flood 2014).
struct Random {
    std::uint64_t state = 0;

    std::uint64_t next() {
        state += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    // 0 .. bound - 1; the bias of the remainder does not matter for meshes.
    std::uint64_t below(std::uint64_t bound) { return bound == 0 ? 0 : next() % bound; }
    // -1 .. 1, a multiple of 2^-52.
    double symmetric() { return static_cast<double>(next() >> 11) * 0x1p-52 - 1.0; }
    bool one_in(std::uint64_t n) { return below(n) == 0; }
};

// A number for a lattice point: noise without a table.
inline std::uint64_t hash_of(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
    Random random{a * 0x100000001b3u + b * 0xc2b2ae3d27d4eb4fu + c};
    random.next();
    return random.next();
}

}  // namespace ravel::make
