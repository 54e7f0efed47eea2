// Lays flags and plain bits out as the bit stream that FlagDecoder reads.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/rice_code.h"
#include "entropy/flag_model.h"

namespace ravel {

class FlagEncoder {
  public:
    FlagEncoder() { open_.fill({kNone, 0}); }

    void flag(FlagModel& model, bool yes) {
        const auto c = static_cast<std::size_t>(model.flag_class());
        ideal_bits_ += model.cost(yes);
        Run& run = open_[c];
        if (run.code == kNone) {
            run = {codes_.size(), 0};
            codes_.push_back({});
        }
        if (yes != model.likely())
            close(run, cut_run(run.flags, kRunOf[c]));
        else if (++run.flags == kRunOf[c])
            close(run, {1, 1});
        model.update(yes);
    }
    // The `count` low bits of `value`, most significant first, as they are; count <= 64.
    void plain(std::uint64_t value, int count) {
        ideal_bits_ += count;
        for (; count > 0; count -= kMostBits) {
            const int bits = count < kMostBits ? count : kMostBits;
            const std::uint64_t part = value >> (count - bits);
            codes_.push_back({static_cast<std::uint32_t>(part & ((1u << bits) - 1)),
                              static_cast<std::uint8_t>(bits)});
        }
    }

    // A number whose rest has `count` bits.
    void rice(std::uint64_t value, int count) {
        if (value < first_escaped(count)) {
            plain(1, static_cast<int>(value >> count) + 1);
            plain(value, count);
            return;
        }
        const std::uint64_t over = value - first_escaped(count);
        const auto more = static_cast<int>(std::bit_width(over));
        plain(0, kRiceEscape);
        plain(static_cast<std::uint64_t>(more), 6);
        plain(over, more);
    }

    // What an ideal coder would make of the same models, plain bits included. For reports and
    // trials.
    double ideal_bits() const { return ideal_bits_; }

    // Runs that are not full yet are taken for full. Linear.
    Bytes finish() const;

  private:
    static constexpr std::size_t kNone = ~std::size_t{0};
    static constexpr int kMostBits = 24;  // of a code
    // A run stands where its first flag does, and is known only after its last.
    struct Code {
        std::uint32_t value = 1;
        std::uint8_t bits = 1;
    };
    struct Run {
        std::size_t code;     // its place in `codes_`, or kNone
        std::uint32_t flags;  // as expected, so far
    };
    static Code cut_run(std::uint32_t length, std::uint32_t full);
    void close(Run& run, const Code& code) {
        codes_[run.code] = code;
        run = {kNone, 0};
    }

    double ideal_bits_ = 0;
    std::vector<Code> codes_;
    std::array<Run, kFlagClasses> open_;
};

}  // namespace ravel
