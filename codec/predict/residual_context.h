// Under which contexts the residual of a coordinate is coded: by how large the residuals of the
// vertices it was guessed from were, and those of the axes before.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "base/context.h"
#include "mesh/stencil.h"
#include "predict/numbers.h"

namespace ravel {

// A residual r is coded as: is it 0? Has |r| at least so many bits as expected; then step by step
// upwards, or downwards, how many it has. The bit below the highest has a context, the rest are as
// they are. So is the sign, but where something is known of it (SignQuestion).
inline constexpr std::uint32_t kScales = 96;          // half octaves of the expected |r|
inline constexpr std::uint32_t kEchoScale = kScales;  // per axis
inline constexpr std::uint32_t kUpSteps = 21, kDownSteps = 10;
inline constexpr std::uint32_t kSizeNodes = 2 + kUpSteps + kDownSteps;

// Guesses of one kind err alike. They are told apart by kind where less than 2^28 is expected.
// Those of seeds, and whatever is no guess of a position, are of kind 0.
inline constexpr std::uint32_t kSizeKinds = 6, kKindScales = 64;
inline constexpr std::uint32_t kOffPlaneKind = 4;  // no other guess of most tets has it
inline constexpr std::uint32_t kFollowedKind = 5;  // what leaders say
inline constexpr std::uint32_t size_kind(Configuration configuration) {
    switch (configuration) {
        case Configuration::seed:
            return 0;
        case Configuration::quad_third:
        case Configuration::tet:
            return 1;
        case Configuration::quad_fourth:
        case Configuration::border:
            return 2;
        case Configuration::quad_corner:
        case Configuration::led:
            return 3;
        default:
            return 4;
    }
}

struct ResidualContexts {
    static constexpr ContextBlock size{0, kScales + 3, kSizeNodes};
    static constexpr ContextBlock second{size.end(), 16, 16};  // size against expected, size
    static constexpr ContextBlock escape{second.end(), 3, 2};  // axis, was the one before
    static constexpr ContextBlock escape_same{escape.end(), 3};
    static constexpr ContextBlock echo{escape_same.end(), 24, 8, 3};
    static constexpr ContextBlock same{echo.end(), 3, 4};
    static constexpr ContextBlock minus_zero{same.end(), 3, 2};
    static constexpr ContextBlock whole_zero{minus_zero.end(), 3, 2};  // is it 0, rest and all?
    static constexpr ContextBlock leading{whole_zero.end(), kMostLeading};
    static constexpr ContextBlock rest_zero{leading.end(), 64};
    static constexpr ContextBlock level{rest_zero.end(), 9, 12, 4, 2};
    static constexpr ContextBlock follow{level.end(), 8, 2, 4};
    static constexpr ContextBlock follow_same{follow.end(), 4, 3, 4};
    static constexpr ContextBlock along{follow_same.end(), 3, 16};
    static constexpr ContextBlock known{along.end(), 10, 4, 8, 2};
    static constexpr ContextBlock pair{known.end(), 10, 4, 8, 2};
    static constexpr ContextBlock all_same{pair.end(), 2, 8, 2,
                                           4};                      // follows, history, copies, far
    static constexpr ContextBlock sign{all_same.end(), 4, 2, 7};    // part; size; signs around
    static constexpr ContextBlock sign_of_large{sign.end(), 4};     // signs around
    static constexpr ContextBlock lead{sign_of_large.end(), 2, 8};  // goes on; the last answers
    static constexpr ContextBlock lead_place{lead.end(), 16};
    static constexpr ContextBlock along_round{lead_place.end(), 3, 16};
    static constexpr ContextBlock size_by{along_round.end(), kSizeKinds - 1, kKindScales,
                                          kSizeNodes};
    static constexpr Context count = size_by.end();
};

// What a residual is expected to be like.
struct Scale {
    std::uint32_t context = 0;  // of ResidualContexts::size
    std::uint32_t bits = 2;     // |r| is about as likely to have so many bits as fewer
    std::uint32_t kind = 0;     // of the guess

    // Of the first node.
    Context nodes() const {
        using C = ResidualContexts;
        return kind == 0 ? C::size.at(context) : C::size_by.at(kind - 1, context);
    }
};

// A question about the sign of a residual.
struct SignQuestion {
    Context context = 0;
    bool down = false;  // is the residual below 0 if the answer is yes?
};
// `size`: digits of |r|. `part`: what rounding took off the guess, at most half a unit; it counts
// for little where there are more than two digits. `signs`: of the residuals around, of which there
// are at most three, those above 0 less those below.
inline SignQuestion sign_question(std::uint32_t size, double part, int signs) {
    using C = ResidualContexts;
    if (size > 2)
        return {C::sign_of_large.base + static_cast<std::uint32_t>(std::abs(signs)), signs < 0};
    const bool down = part < 0;
    // In this order no `part` whatever leads out of the block.
    const auto rounded = static_cast<std::uint32_t>(std::min(3.0, std::abs(part) * 8));
    const auto agree = static_cast<std::uint32_t>(down ? 3 - signs : 3 + signs);
    return {C::sign.base + (2 * rounded + size - 1) * 7 + agree, down};
}
// Where nothing is known of it.
struct NoSignQuestion {};

// Where a magnitude of expected / 16 is expected, below 2^59.
inline Scale scale_of(std::uint64_t expected) {
    const std::uint64_t x = expected + 1;
    const auto b = static_cast<std::uint32_t>(std::bit_width(x)) - 1;
    const bool half = (b > 15 ? x >> (b - 15) : x << (15 - b)) >= 46341;  // the square root of 2
    return {std::min(2 * b + (half ? 1u : 0u), kScales - 1), b < 5 ? 2 : b - 3, 0};
}
// The expectation after a magnitude.
inline void expect(std::uint64_t& expected, std::uint64_t magnitude) {
    expected += ((16 * magnitude + 31) >> 5) - ((expected + 31) >> 5);
}

// Usual magnitudes are kept of seeds by variant, then by configuration.
inline constexpr std::size_t kOfSeeds = 3;
inline constexpr std::size_t usual_place(Configuration configuration) {
    return kOfSeeds - 1 + static_cast<std::size_t>(configuration);
}

// The magnitudes of all residuals so far, and from them the scale of the next.
class ResidualSizes {
  public:
    using Magnitudes = std::array<std::uint32_t, 3>;  // per axis, at most kMost

    // `start`: what is expected of seeds, tets and along borders before any is known, below 2^48.
    explicit ResidualSizes(std::uint64_t start = kStart) {
        usual_.fill(16 * kStart);
        std::fill_n(usual_.begin(), kOfSeeds, 16 * start);
        for (const Configuration c : {Configuration::tet, Configuration::border})
            usual_[usual_place(c)] = 16 * start;
    }
    void reserve(std::size_t vertices) { known_.reserve(vertices); }

    // Before the residuals of a vertex are coded. The point of an edge is as far off as those
    // before; its ends do not tell. How far a component is from the one before tells nothing of
    // other vertices, nor do the first corners of its seed of any but these.
    void begin(const Stencil& stencil) {
        const bool seed = stencil.configuration == Configuration::seed;
        const std::uint32_t asks = !seed ? kOthers : stencil.variant > 0 ? kSeeds : 0;
        tells_ = seed ? asks : kOthers | kSeeds;
        std::array<std::uint64_t, 3> sum{};
        std::uint64_t n = 0;
        signs_around_ = 0;
        const std::size_t first = stencil.configuration == Configuration::edge ? 2 : 0;
        for (std::size_t i = first; i < first + 3; ++i) {
            if (stencil.at[i] == kNone || (known_[stencil.at[i]].signs & asks) == 0) {
                signs_around_ += kNoSigns;
                continue;
            }
            const Known& known = known_[stencil.at[i]];
            ++n;
            signs_around_ += known.signs & 0xFFFFFF;
            for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += known.magnitudes[axis];
        }
        off_sum_ = off_count_ = 0;
        for (std::size_t i = 0; i < 3; ++i)
            if (stencil.at[i] < off_plane_.size() && off_plane_[stencil.at[i]] != kNone) {
                off_sum_ += off_plane_[stencil.at[i]];
                ++off_count_;
            }
        usual_of_ = &usual_[seed ? stencil.variant : usual_place(stencil.configuration)];
        kind_ = size_kind(stencil.configuration);
        const std::uint64_t all = sum[0] + sum[1] + sum[2];
        shares_ = shares_of(stencil.configuration);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // In sixteenths.
            const std::uint64_t both = (32 - 3 * shares_.axes) * sum[axis] + shares_.axes * all;
            const std::uint64_t near = n == 0 ? *usual_of_ : part(both / 2, n);
            expected_[axis] = ((32 - shares_.usual) * near + shares_.usual * *usual_of_) >> 5;
            mean_[axis] = n == 0 ? 0 : static_cast<std::uint32_t>(part(sum[axis], n));
        }
        now_ = {};
        signs_now_ = kNoSigns;
        done_ = 0;
    }
    // Of the axis that is coded as the `step`-th.
    Scale scale(std::size_t axis, std::size_t step) const {
        std::uint64_t e = expected_[axis];
        if (step == 1) e = ((32 - shares_.first) * e + shares_.first * 16 * done_) >> 5;
        if (step == 2) e = ((32 - shares_.both) * e + shares_.both * 8 * done_) >> 5;
        return of_kind(scale_of(e), kind_);
    }
    // Of the last axis of a vertex that goes on with a border: how far off its plane, or its round
    // face, it is.
    Scale scale_off_plane() const {
        const std::uint64_t near = off_count_ == 0 ? usual_off_ : part(16 * off_sum_, off_count_);
        return of_kind(scale_of((29 * near + 3 * usual_off_) >> 5), kOffPlaneKind);
    }
    SignQuestion sign(std::uint32_t size, std::size_t axis, double part) const {
        return sign_question(size, part, static_cast<int>(signs_around_ >> (8 * axis) & 7) - 3);
    }
    // The residual of a guess.
    void coded_residual(std::size_t axis, std::int64_t r) {
        coded(axis, magnitude(r));
        // Nobody foresees signs, so nothing branches on them; what is added modulo 2^32 borrows
        // from no other byte.
        signs_now_ += static_cast<std::uint32_t>((r > 0) - (r < 0)) << (8 * axis);
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
        off_plane_.resize(known_.size(), kNone);
        off_plane_.push_back(off);
        done_ -= now_[axis];
        now_[axis] = 0;
        coded(axis, by_guess);
    }
    void push() {
        known_.push_back({now_, signs_now_ | tells_});
        *usual_of_ += ((16 * done_ / 3 + 31) >> 5) - ((*usual_of_ + 31) >> 5);
    }
    // A vertex that was not guessed: as half of what is around it, or as nothing.
    void push_half() {
        known_.push_back({{mean_[0] / 2, mean_[1] / 2, mean_[2] / 2}, kNoSigns | kOthers | kSeeds});
    }
    void push_nothing() { known_.push_back({{}, kNoSigns | kOthers | kSeeds}); }

  private:
    static constexpr std::uint64_t kMost = 0xFFFFFFFF, kStart = 16;
    static constexpr std::uint32_t kNoSigns = 0x010101;

    // What an expectation is made of beside the axis' own, in shares of 1/32.
    struct Shares {
        std::uint64_t usual;        // what the configuration's usually are
        std::uint64_t axes;         // each axis of those around
        std::uint64_t first, both;  // the axes before, of the second and of the third
    };
    static Shares shares_of(Configuration configuration) {
        return configuration < Configuration::tet ? Shares{1, 1, 4, 6} : Shares{3, 2, 6, 9};
    }

    // x / n, n being 1 to 3: constants divide faster.
    static std::uint64_t part(std::uint64_t x, std::uint64_t n) {
        return n == 3 ? x / 3 : n == 2 ? x / 2 : x;
    }

    static Scale of_kind(const Scale& scale, std::uint32_t kind) {
        return {scale.context, scale.bits, scale.context < kKindScales ? kind : 0};
    }

    // Whom a vertex tells something.
    static constexpr std::uint32_t kOthers = 1u << 24, kSeeds = 1u << 25;
    struct Known {
        Magnitudes magnitudes;
        // A byte per axis, 0, 1 or 2: below 0, none, above. The fourth: whom it tells.
        std::uint32_t signs;
    };
    std::vector<Known> known_;
    std::uint32_t signs_around_ = 0, signs_now_ = kNoSigns;  // the sum of three
    std::vector<std::uint32_t> off_plane_;  // kNone, or it ends, where no plane was gone on with
    std::uint64_t off_sum_ = 0, off_count_ = 0, usual_off_ = 16 * kStart;
    std::array<std::uint64_t, usual_place(Configuration::count)> usual_;
    std::uint64_t* usual_of_ = nullptr;
    std::uint32_t kind_ = 0, tells_ = 0;
    Shares shares_{};
    std::array<std::uint64_t, 3> expected_{};
    Magnitudes mean_{}, now_{};
    std::uint64_t done_ = 0;
};

// Codes r through `coder` (the encoder's writes it, the decoder's returns what it reads):
//     bool flag(Context, bool truth)      uint64 plain(uint64 truth, int count)
// `sign(size)`: the question to ask about the sign. `differs`: r is known not to be 0.
template <class Coder, class Sign = NoSignQuestion>
std::int64_t code_residual(Coder& coder, const Scale& scale, std::int64_t r, const Sign& sign = {},
                           bool differs = false) {
    using C = ResidualContexts;
    const std::uint64_t m = magnitude(r);
    const auto truth = static_cast<std::uint32_t>(std::bit_width(m));
    const Context nodes = scale.nodes();
    if (!differs && coder.flag(nodes, truth == 0)) return 0;
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
    const int rest = size >= 2 ? static_cast<int>(size) - 2 : 0;
    const std::uint64_t mask = (std::uint64_t{1} << rest) - 1;
    bool negative = r < 0;
    if constexpr (!std::is_same_v<Sign, NoSignQuestion>) {
        const SignQuestion question = sign(size);
        negative = question.down == coder.flag(question.context, question.down == negative);
        if (rest > 0) value = value << rest | coder.plain(m & mask, rest);
    } else {
        // The rest of |r|, then the sign.
        const std::uint64_t low = coder.plain((m & mask) << 1 | (negative ? 1 : 0), rest + 1);
        value = value << rest | low >> 1;
        negative = (low & 1) != 0;
    }
    return static_cast<std::int64_t>(negative ? std::uint64_t{0} - value : value);
}

}  // namespace ravel
