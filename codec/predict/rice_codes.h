// Residuals as Rice codes [Rice1979]: a quotient in unary, a rest as it is, one look at the bits
// for both. How long the rest is follows the mean of what came under the same context, as in
// [Weinberger2000]. Larger than code_residual's codes, where most residuals are 0 by far, and much
// faster.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "base/bytes.h"
#include "predict/residual_context.h"

namespace ravel {

class RiceMeans {
  public:
    RiceMeans() {
        for (auto& of_kind : means_)
            for (std::uint32_t s = 0; s < kScales; ++s)
                of_kind[s] = std::uint64_t{s % 2 == 0 ? 2u : 3u} << std::min(s / 2, kMostBits);
    }

    // Codes r as code_residual does; the coder also codes
    //     uint64 rice(uint64 truth, int bits)     `bits`: of the rest
    template <class Coder>
    std::int64_t code(Coder& coder, const Scale& scale, std::int64_t r) const {
        const std::uint64_t mean = mean_of(scale);
        // Where most are 0 a flag takes less than a code.
        const bool asks = mean < 16;
        if (asks && coder.flag(scale.nodes(), r == 0)) return 0;
        const std::uint64_t least = asks ? 1 : 0;
        return unzigzag(coder.rice(zigzag(r) - least, bits_of(mean)) + least);
    }
    // After a residual that was coded.
    void learn(const Scale& scale, std::int64_t r) {
        std::uint64_t& mean = means_[scale.kind][scale.context];
        mean += ((16 * std::min(zigzag(r), kMost) + 15) >> 4) - ((mean + 15) >> 4);
    }

  private:
    static constexpr std::uint32_t kMostBits = 40;
    static constexpr std::uint64_t kMost = std::uint64_t{1} << 36;

    std::uint64_t mean_of(const Scale& scale) const { return means_[scale.kind][scale.context]; }
    // The least power of two above 11/16 of the mean.
    static int bits_of(std::uint64_t mean) {
        return static_cast<int>(std::bit_width(11 * mean >> 8));
    }

    // In sixteenths, of zigzag(r).
    std::array<std::array<std::uint64_t, kScales>, kSizeKinds> means_;
};

}  // namespace ravel
