// Under which contexts the residual of a coordinate is coded: by how large the residuals of the
// vertices it was guessed from were, and the residual of the axis before.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "base/context.h"
#include "mesh/stencil.h"
#include "predict/numbers.h"

namespace ravel {

// A residual r is coded as the bit width of |r| (a path of six yes/no down a binary tree, 63
// meaning 63 or 64), its sign, the bit below the highest under a context, and the rest as they are.
inline constexpr std::uint32_t kSizeContexts = 40;
inline constexpr std::uint32_t kEchoClass = kSizeContexts;  // then those of followers: per axis
inline constexpr std::uint32_t kSizeNodes = 64;

struct ResidualContexts {
    static constexpr ContextBlock size{0, kEchoClass + 3, kSizeNodes};
    static constexpr ContextBlock size64{size.end(), 1};
    static constexpr ContextBlock second{size64.end(), 64, 1};
    static constexpr ContextBlock outlier{second.end(), 1};
    static constexpr ContextBlock echo{outlier.end(), 24, 8};
    static constexpr ContextBlock same{echo.end(), 3, 4};
    static constexpr ContextBlock minus_zero{same.end(), 3, 2};
    static constexpr ContextBlock whole_zero{minus_zero.end(), 3, 2};  // is it 0, rest and all?
    static constexpr ContextBlock leading{whole_zero.end(), kMostLeading};
    static constexpr ContextBlock rest_zero{leading.end(), 64};
    static constexpr ContextBlock level{rest_zero.end(), 8, 12, 4, 2};
    static constexpr ContextBlock follow{level.end(), 8, 2};
    static constexpr ContextBlock follow_same{follow.end(), 3, 4};
    static constexpr Context count = follow_same.end();
};

// The residual sizes of all vertices so far, and from them the class of the next. `coarseness`
// merges classes (2^coarseness to one), for meshes with few vertices.
class ResidualSizes {
  public:
    explicit ResidualSizes(int coarseness) : coarseness_(coarseness) {}

    void reserve(std::size_t vertices) { sizes_.reserve(vertices); }
    // In halves of a bit; configurations differ in how many vertices they look at.
    std::uint32_t expected(const Stencil& stencil) const {
        std::uint32_t sum = 0, n = 0;
        for (std::size_t i = 0; i < 3; ++i)
            if (stencil.at[i] != kNone) sum += sizes_[stencil.at[i]], ++n;
        return n == 0 ? 16 : (2 * sum + n / 2) / n;
    }
    std::uint32_t context(std::uint32_t expected_halves) const {
        // Every half below 12 bits, every second above.
        const std::uint32_t c =
            expected_halves < 24 ? expected_halves : 24 + (expected_halves - 24) / 4;
        return c >> coarseness_;
    }
    void push(std::uint32_t size) { sizes_.push_back(static_cast<std::uint8_t>(size)); }

  private:
    int coarseness_;
    std::vector<std::uint8_t> sizes_;  // mean bit width of a vertex's residuals
};

// Codes r through `coder` (the encoder's writes it, the decoder's returns what it reads):
//     bool flag(Context, bool truth)      uint64 plain(uint64 truth, int count)
template <class Coder>
std::int64_t code_residual(Coder& coder, std::uint32_t context, std::int64_t r,
                           std::uint32_t& size_out) {
    using C = ResidualContexts;
    const std::uint64_t m = magnitude(r);
    const auto true_size = static_cast<std::uint32_t>(std::bit_width(m));
    const std::uint32_t capped = true_size < 63 ? true_size : 63;
    std::uint32_t node = 1;
    for (int level = 5; level >= 0; --level)
        node = node << 1 | coder.flag(C::size.at(context, node), (capped >> level & 1) != 0);
    std::uint32_t size = node & 63;
    if (size == 63 && coder.flag(C::size64.at(0), true_size == 64)) size = 64;
    size_out = size;
    if (size == 0) return 0;
    std::uint64_t value = 1;
    if (size >= 2) {
        value = value << 1 | coder.flag(C::second.at(size - 1), (m >> (size - 2) & 1) != 0);
        const int rest = static_cast<int>(size) - 2;
        if (rest > 0) {
            const std::uint64_t low = coder.plain(m & ((std::uint64_t{1} << rest) - 1), rest);
            value = value << rest | low;
        }
    }
    const bool negative = coder.plain(r < 0, 1) != 0;
    return static_cast<std::int64_t>(negative ? std::uint64_t{0} - value : value);
}

}  // namespace ravel
