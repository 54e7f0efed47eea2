// Reads what FlagEncoder wrote. Any bytes are safe: past the end bits are zero, and `exhausted`
// tells.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "entropy/flag_model.h"

namespace ravel {

// How truncated binary tells the length of a run that is cut short.
struct RunCut {
    std::uint8_t bits = 0;    // of the short lengths
    std::uint16_t brief = 1;  // how many are short; the others have a bit more
};
inline constexpr std::array<RunCut, kFlagClasses> kRunCut = [] {
    std::array<RunCut, kFlagClasses> cuts{};
    for (std::size_t c = 0; c < kFlagClasses; ++c) {
        if (kRunOf[c] <= 1) continue;
        const auto width = static_cast<unsigned>(std::bit_width(kRunOf[c] - 1u));
        cuts[c] = {static_cast<std::uint8_t>(width - 1),
                   static_cast<std::uint16_t>((1u << width) - kRunOf[c])};
    }
    return cuts;
}();

// The codes of the classes with short runs by their first bits: of these nobody foresees any, so
// nothing branches on them.
struct RunCode {
    std::uint8_t left = 0;  // flags of the run
    bool is_full = false;   // no miss ends it
    std::uint8_t bits = 0;  // of the code
};
inline constexpr std::size_t kShortClasses = 7;
inline constexpr int kShortBits = 5;  // of the longest of their codes
static_assert(kRunCut[kShortClasses - 1].bits + 2 <= kShortBits);
inline constexpr auto kRunCodes = [] {
    std::array<std::array<RunCode, 1u << kShortBits>, kShortClasses> codes{};
    for (std::size_t c = 0; c < kShortClasses; ++c)
        for (unsigned bits = 0; bits < codes[c].size(); ++bits) {
            RunCode& code = codes[c][bits];
            if (bits >> (kShortBits - 1) != 0) {
                code = {static_cast<std::uint8_t>(kRunOf[c]), true, 1};
                continue;
            }
            const RunCut cut = kRunCut[c];
            int left = kShortBits - 1 - cut.bits;
            unsigned length = bits >> left;
            if (length >= cut.brief) length = 2 * length + (bits >> --left & 1u) - cut.brief;
            code = {static_cast<std::uint8_t>(length + 1), false,
                    static_cast<std::uint8_t>(kShortBits - left)};
        }
    return codes;
}();

class FlagDecoder {
  public:
    explicit FlagDecoder(std::span<const std::byte> bytes) : bytes_(bytes) {}

    bool flag(FlagModel& model) {
        const auto c = static_cast<std::size_t>(model.flag_class());
        Run& run = runs_[c];
        if (run.left == 0) fetch(run, c);
        --run.left;
        const bool yes = model.likely() != (run.left == run.miss);
        model.update(yes);
        return yes;
    }
    std::uint64_t plain(int count) {
        std::uint64_t value = 0;
        for (; count > 32; count -= 32) value = value << 32 | bits(32);
        return value << count | bits(count);
    }

    // More bits were asked for than there are: the stream is cut or not one of ours.
    bool exhausted() const { return 8 * past_ > static_cast<std::uint64_t>(held_); }
    // All bits were used, but for the padding of the last byte, which is zero.
    bool finished() const {
        const int left = held_ - static_cast<int>(std::min<std::uint64_t>(8 * past_, 64));
        return position_ == bytes_.size() && left >= 0 && left < 8 &&
               (hold_ & ((std::uint64_t{1} << held_) - 1)) == 0;
    }

  private:
    struct Run {
        std::uint32_t left = 0;
        std::uint32_t miss = 0;  // what is left once the miss has come: 0, or never
    };

    void fetch(Run& run, std::size_t c) {
        if (held_ < 16) refill();
        if (c < kShortClasses) {
            const RunCode code =
                kRunCodes[c][hold_ >> (held_ - kShortBits) & ((1u << kShortBits) - 1)];
            held_ -= code.bits;
            run = {code.left, std::uint32_t{0} - code.is_full};
            return;
        }
        if ((hold_ >> --held_ & 1) != 0) {
            run = {kRunOf[c], ~std::uint32_t{0}};
            return;
        }
        const RunCut cut = kRunCut[c];
        held_ -= cut.bits;
        auto length = static_cast<std::uint32_t>(hold_ >> held_) & ((1u << cut.bits) - 1);
        if (length >= cut.brief) {
            const auto last = static_cast<std::uint32_t>(hold_ >> --held_ & 1);
            length = 2 * length + last - cut.brief;
        }
        run = {length + 1, 0};
    }
    std::uint64_t bits(int count) {  // count <= 32
        if (held_ < count) refill();
        held_ -= count;
        return hold_ >> held_ & ((std::uint64_t{1} << count) - 1);
    }
    void refill() {  // to more than 48 bits
        if (bytes_.size() - position_ >= 8) {
            std::uint64_t next = 0;
            for (std::size_t i = 0; i < 8; ++i)
                next = next << 8 | static_cast<std::uint64_t>(bytes_[position_ + i]);
            const int whole = std::min((64 - held_) >> 3, 7);
            hold_ = hold_ << 8 * whole | next >> (64 - 8 * whole);
            held_ += 8 * whole;
            position_ += static_cast<std::size_t>(whole);
            return;
        }
        refill_from_last();
    }
    // From the last bytes, and what is beyond them.
    [[gnu::noinline, gnu::cold]] void refill_from_last() {
        while (held_ <= 48) {
            std::uint64_t byte = 0;
            if (position_ < bytes_.size())
                byte = static_cast<std::uint64_t>(bytes_[position_++]);
            else
                ++past_;
            hold_ = hold_ << 8 | byte;
            held_ += 8;
        }
    }

    std::span<const std::byte> bytes_;
    std::size_t position_ = 0;
    std::uint64_t past_ = 0;  // bytes of zeros put in behind the end
    std::uint64_t hold_ = 0;
    int held_ = 0;
    std::array<Run, kFlagClasses> runs_{};
};

}  // namespace ravel
