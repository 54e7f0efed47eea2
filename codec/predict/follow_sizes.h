// How large what leaders say is expected to be off. The parts that are led differ in this, not the
// places in them: of a leaf that is bent another way all is off, of a leg that stands elsewhere the
// first vertex alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "mesh/stencil.h"
#include "predict/residual_context.h"

namespace ravel {

class FollowSizes {
  public:
    FollowSizes() { usual_.fill(kStart); }

    // Before a vertex that may follow.
    void begin(const Stencil& stencil) {
        usual_of_ = stencil.configuration != Configuration::seed
                        ? 3
                        : std::min<std::size_t>(stencil.variant, 2);
        done_ = 0;
    }
    // Of an axis that is not the same.
    Scale scale(std::size_t axis) const {
        const std::uint64_t e = usual_[usual_of_];
        const Scale scale = scale_of(axis == 0   ? e
                                     : axis == 1 ? (20 * e + 12 * 16 * done_) >> 5
                                                 : (16 * e + 16 * 8 * done_) >> 5);
        // In octaves: parts that are led have less to learn from.
        return {scale.context & ~1u, scale.bits, scale.context < kKindScales ? kFollowedKind : 0};
    }
    // Is a coordinate likely to be the same? 0 if leaders have been off by next to nothing, to 3.
    std::uint32_t far() const {
        const std::uint64_t usual = usual_[usual_of_];
        return (usual >= 8 ? 1u : 0u) + (usual >= 32 ? 1u : 0u) + (usual >= 128 ? 1u : 0u);
    }
    void coded(std::int64_t r) { done_ += std::min<std::uint64_t>(magnitude(r), 0xFFFFFFFF); }
    // After the last axis.
    void end() {
        // In sixteenths, a quarter of the way; rounded down whichever way that is.
        const std::uint64_t mean = 16 * done_ / 3;
        usual_[usual_of_] = (3 * usual_[usual_of_] + mean) / 4;
    }

  private:
    static constexpr std::uint64_t kStart = 64;

    std::array<std::uint64_t, 4> usual_;  // of seeds by variant, of all others
    std::size_t usual_of_ = 0;
    std::uint64_t done_ = 0;  // magnitudes of the axes so far
};

}  // namespace ravel
