// Flags packed to bits: those of a few million edges stay in a core's own cache.
#pragma once

#include <cstdint>
#include <vector>

namespace ravel {

class Bits {
  public:
    explicit Bits(std::size_t count) : words_((count + 63) / 64, 0) {}

    bool operator[](std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1) != 0; }
    void set(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
    void clear(std::size_t i) { words_[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }
    void flip(std::size_t i) { words_[i / 64] ^= std::uint64_t{1} << (i % 64); }
    void clear_all() { words_.assign(words_.size(), 0); }

  private:
    std::vector<std::uint64_t> words_;
};

}  // namespace ravel
