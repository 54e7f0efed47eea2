// Under which contexts the residual of a coordinate is coded: by how large the residuals of the
// vertices it was guessed from were, and those of the axes before.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "base/context.h"
#include "mesh/stencil.h"
#include "predict/numbers.h"

namespace ravel {

// A residual r is coded as: is it 0? Has |r| at least so many bits as expected; then step by step
// upwards, or downwards, how many it has. The bit below the highest has a context, the rest are as
// they are, and so is the sign.
inline constexpr std::uint32_t kScales = 96;          // half octaves of the expected |r|
inline constexpr std::uint32_t kEchoScale = kScales;  // per axis; then those of followers
inline constexpr std::uint32_t kUpSteps = 21, kDownSteps = 10;
inline constexpr std::uint32_t kSizeNodes = 2 + kUpSteps + kDownSteps;

struct ResidualContexts {
    static constexpr ContextBlock size{0, kScales + 6, kSizeNodes};
    static constexpr ContextBlock second{size.end(), 16, 16};  // size against expected, size
    static constexpr ContextBlock escape{second.end(), 3, 2};  // axis, was the one before
    static constexpr ContextBlock escape_same{escape.end(), 3};
    static constexpr ContextBlock echo{escape_same.end(), 24, 8};
    static constexpr ContextBlock same{echo.end(), 3, 4};
    static constexpr ContextBlock minus_zero{same.end(), 3, 2};
    static constexpr ContextBlock whole_zero{minus_zero.end(), 3, 2};  // is it 0, rest and all?
    static constexpr ContextBlock leading{whole_zero.end(), kMostLeading};
    static constexpr ContextBlock rest_zero{leading.end(), 64};
    static constexpr ContextBlock level{rest_zero.end(), 9, 12, 4, 2};
    static constexpr ContextBlock follow{level.end(), 8, 2};
    static constexpr ContextBlock follow_same{follow.end(), 3, 4};
    static constexpr ContextBlock along{follow_same.end(), 3, 16};
    static constexpr ContextBlock known{along.end(), 10, 4, 8, 2};
    static constexpr ContextBlock pair{known.end(), 10, 4, 8, 2};
    static constexpr ContextBlock all_same{pair.end(), 2, 8, 2};  // follows, history, copies
    static constexpr Context count = all_same.end();
};

// What a residual is expected to be like.
struct Scale {
    std::uint32_t context = 0;  // of ResidualContexts::size
    std::uint32_t bits = 2;     // |r| is about as likely to have so many bits as fewer
};

// Where a magnitude of expected / 16 is expected, below 2^59.
inline Scale scale_of(std::uint64_t expected) {
    const std::uint64_t x = expected + 1;
    const auto b = static_cast<std::uint32_t>(std::bit_width(x)) - 1;
    const bool half = (b > 15 ? x >> (b - 15) : x << (15 - b)) >= 46341;  // the square root of 2
    return {std::min(2 * b + (half ? 1u : 0u), kScales - 1), b < 5 ? 2 : b - 3};
}
// The expectation after a magnitude.
inline void expect(std::uint64_t& expected, std::uint64_t magnitude) {
    expected += ((16 * magnitude + 31) >> 5) - ((expected + 31) >> 5);
}

// The magnitudes of all residuals so far, and from them the scale of the next.
class ResidualSizes {
  public:
    using Magnitudes = std::array<std::uint32_t, 3>;  // per axis, at most kMost

    ResidualSizes() { usual_.fill(kStart); }
    void reserve(std::size_t vertices) { magnitudes_.reserve(vertices); }

    // Before the residuals of a vertex are coded. The point of an edge is as far off as those
    // before; its ends do not tell.
    void begin(const Stencil& stencil) {
        std::array<std::uint64_t, 3> sum{};
        std::uint64_t n = 0;
        const std::size_t first = stencil.configuration == Configuration::edge ? 2 : 0;
        for (std::size_t i = first; i < first + 3; ++i) {
            if (stencil.at[i] == kNone) continue;
            ++n;
            for (std::size_t axis = 0; axis < 3; ++axis)
                sum[axis] += magnitudes_[stencil.at[i]][axis];
        }
        off_sum_ = off_count_ = 0;
        for (std::size_t i = 0; i < 3; ++i)
            if (stencil.at[i] < off_plane_.size() && off_plane_[stencil.at[i]] != kNone) {
                off_sum_ += off_plane_[stencil.at[i]];
                ++off_count_;
            }
        usual_of_ = &usual_[static_cast<std::size_t>(stencil.configuration)];
        const std::uint64_t all = sum[0] + sum[1] + sum[2];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // 13/16 of the axis itself, 3/16 of the mean over the axes; in sixteenths.
            const std::uint64_t near = n == 0 ? *usual_of_ : part(13 * sum[axis] + all, n);
            expected_[axis] = (29 * near + 3 * *usual_of_) >> 5;
            mean_[axis] = n == 0 ? 0 : static_cast<std::uint32_t>(part(sum[axis], n));
        }
        now_ = {};
        done_ = 0;
    }
    // Of the axis that is coded as the `step`-th.
    Scale scale(std::size_t axis, std::size_t step) const {
        std::uint64_t e = expected_[axis];
        if (step == 1) e = (13 * e + 3 * 16 * done_) >> 4;
        if (step == 2) e = (23 * e + 9 * 8 * done_) >> 5;
        return scale_of(e);
    }
    // Of the last axis of a vertex that goes on with a border: how far off its plane it is.
    Scale scale_off_plane() const {
        const std::uint64_t near = off_count_ == 0 ? usual_off_ : part(16 * off_sum_, off_count_);
        return scale_of((29 * near + 3 * usual_off_) >> 5);
    }
    void coded(std::size_t axis, std::uint64_t magnitude) {
        now_[axis] = static_cast<std::uint32_t>(std::min(magnitude, kMost));
        done_ += now_[axis];
    }
    // After the last axis of such a vertex; `by_guess`: the axis' magnitude, had there been no
    // plane.
    void coded_off_plane(std::size_t axis, std::uint64_t by_guess) {
        const std::uint32_t off = std::min(now_[axis], kNone - 1);
        expect(usual_off_, off);
        off_plane_.resize(magnitudes_.size(), kNone);
        off_plane_.push_back(off);
        done_ -= now_[axis];
        now_[axis] = 0;
        coded(axis, by_guess);
    }
    void push() {
        magnitudes_.push_back(now_);
        *usual_of_ += ((16 * done_ / 3 + 31) >> 5) - ((*usual_of_ + 31) >> 5);
    }
    // A vertex that was not guessed: as half of what is around it, or as nothing.
    void push_half() { magnitudes_.push_back({mean_[0] / 2, mean_[1] / 2, mean_[2] / 2}); }
    void push_nothing() { magnitudes_.push_back({}); }

  private:
    static constexpr std::uint64_t kMost = 0xFFFFFFFF, kStart = 256;

    // x / n, n being 1 to 3: constants divide faster.
    static std::uint64_t part(std::uint64_t x, std::uint64_t n) {
        return n == 3 ? x / 3 : n == 2 ? x / 2 : x;
    }

    std::vector<Magnitudes> magnitudes_;
    std::vector<std::uint32_t> off_plane_;  // kNone, or it ends, where no plane was gone on with
    std::uint64_t off_sum_ = 0, off_count_ = 0, usual_off_ = kStart;
    std::array<std::uint64_t, static_cast<std::size_t>(Configuration::count)> usual_;
    std::uint64_t* usual_of_ = nullptr;
    std::array<std::uint64_t, 3> expected_{};
    Magnitudes mean_{}, now_{};
    std::uint64_t done_ = 0;
};

// Codes r through `coder` (the encoder's writes it, the decoder's returns what it reads):
//     bool flag(Context, bool truth)      uint64 plain(uint64 truth, int count)
template <class Coder>
std::int64_t code_residual(Coder& coder, const Scale& scale, std::int64_t r) {
    using C = ResidualContexts;
    const std::uint64_t m = magnitude(r);
    const auto truth = static_cast<std::uint32_t>(std::bit_width(m));
    const Context nodes = C::size.at(scale.context);
    if (coder.flag(nodes, truth == 0)) return 0;
    std::uint32_t size = scale.bits;
    if (coder.flag(nodes + 1, truth >= size)) {
        for (std::uint32_t step = 0; size < 64; ++size, ++step)
            if (!coder.flag(nodes + 2 + std::min(step, kUpSteps - 1), truth > size)) break;
    } else {
        std::uint32_t step = 0;
        for (--size; size > 1; --size, ++step)
            if (coder.flag(nodes + 2 + kUpSteps + std::min(step, kDownSteps - 1), truth == size))
                break;
    }
    std::uint64_t value = 1;
    if (size >= 2) {
        const std::uint32_t against =
            std::clamp(size + 8, scale.bits, scale.bits + 15) - scale.bits;
        value = value << 1 | coder.flag(C::second.at(against, size), (m >> (size - 2) & 1) != 0);
    }
    // The rest of |r|, then the sign.
    const int rest = size >= 2 ? static_cast<int>(size) - 2 : 0;
    const std::uint64_t mask = (std::uint64_t{1} << rest) - 1;
    const std::uint64_t low = coder.plain((m & mask) << 1 | (r < 0 ? 1 : 0), rest + 1);
    value = value << rest | low >> 1;
    return static_cast<std::int64_t>((low & 1) != 0 ? std::uint64_t{0} - value : value);
}

}  // namespace ravel
