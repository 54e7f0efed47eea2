// Reads what FlagEncoder wrote. Any bytes are safe: past the end bits are zero, and `exhausted`
// tells.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "base/rice_code.h"
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
// nothing branches on them. An entry is what the run's flags are, a bit each as in FlagDecoder's
// queues, over three bits that tell how many bits the code has.
inline constexpr std::size_t kShortClasses = 7;
inline constexpr int kShortBits = 5;  // of the longest of their codes
static_assert(kRunCut[kShortClasses - 1].bits + 2 <= kShortBits);
inline constexpr auto kRunCodes = [] {
    std::array<std::array<std::uint16_t, 1u << kShortBits>, kShortClasses> codes{};
    for (std::size_t c = 0; c < kShortClasses; ++c)
        for (unsigned bits = 0; bits < codes[c].size(); ++bits) {
            if (bits >> (kShortBits - 1) != 0) {
                codes[c][bits] = static_cast<std::uint16_t>(1u << kRunOf[c] << 3 | 1u);
                continue;
            }
            const RunCut cut = kRunCut[c];
            int left = kShortBits - 1 - cut.bits;
            unsigned length = bits >> left;
            if (length >= cut.brief) length = 2 * length + (bits >> --left & 1u) - cut.brief;
            codes[c][bits] = static_cast<std::uint16_t>(3u << length << 3 |
                                                        static_cast<unsigned>(kShortBits - left));
        }
    return codes;
}();

class FlagDecoder {
  public:
    explicit FlagDecoder(std::span<const std::byte> bytes) : bytes_(bytes) { queues_.fill(kEmpty); }

    bool flag(FlagModel& model) {
        const auto c = static_cast<std::size_t>(model.flag_class());
        std::uint64_t queue = queues_[c];
        if (queue == kEmpty) queue = fetch(c);
        queues_[c] = queue >> 1;
        const bool yes = model.likely() != ((queue & 1) != 0);
        model.update(yes);
        return yes;
    }
    std::uint64_t plain(int count) {
        std::uint64_t value = 0;
        for (; count > 32; count -= 32) value = value << 32 | bits(32);
        return value << count | bits(count);
    }

    // A number whose rest has `count` bits, at most 41.
    std::uint64_t rice(int count) {
        if (held_ < kRiceEscape + 1) refill();
        const int zeros = std::countl_zero(hold_);
        if (zeros >= kRiceEscape) {
            take(kRiceEscape);
            const auto more = static_cast<int>(bits(6));
            return first_escaped(count) + plain(more);
        }
        take(zeros + 1);
        return static_cast<std::uint64_t>(zeros) << count | plain(count);
    }

    // More bits were asked for than there are: the stream is cut or not one of ours.
    bool exhausted() const { return 8 * past_ > static_cast<std::uint64_t>(held_); }
    // All bits were used, but for the padding of the last byte, which is zero.
    bool finished() const {
        const int left = held_ - static_cast<int>(std::min<std::uint64_t>(8 * past_, 64));
        return position_ == bytes_.size() && left >= 0 && left < 8 && hold_ == 0;
    }

  private:
    // The flags to come of a class, the next one lowest, 1 for a miss; a 1 ends them.
    static constexpr std::uint64_t kEmpty = 1;
    static constexpr std::uint32_t kLongest = 63;  // of a queue
    // What is left of a long run.
    struct Rest {
        std::uint32_t flags = 0;
        bool is_cut = false;  // the last is a miss
    };

    std::uint64_t fetch(std::size_t c) {
        if (held_ < kShortBits) refill();
        if (c >= kShortClasses) return fetch_long(c);
        const std::uint32_t code = kRunCodes[c][hold_ >> (64 - kShortBits)];
        take(static_cast<int>(code & 7));
        return code >> 3;
    }
    [[gnu::noinline]] std::uint64_t fetch_long(std::size_t c) {
        Rest& rest = rests_[c - kShortClasses];
        if (rest.flags == 0) {
            if (bits(1) != 0) {
                rest = {kRunOf[c], false};
            } else {
                const RunCut cut = kRunCut[c];
                auto length = static_cast<std::uint32_t>(bits(cut.bits));
                if (length >= cut.brief)
                    length = 2 * length + static_cast<std::uint32_t>(bits(1)) - cut.brief;
                rest = {length + 1, true};
            }
        }
        const std::uint32_t next = std::min(rest.flags, kLongest);
        rest.flags -= next;
        const std::uint64_t last = rest.flags == 0 && rest.is_cut ? 3 : 2;
        return last << (next - 1);
    }
    std::uint64_t bits(int count) {  // count <= 32
        if (count == 0) return 0;
        if (held_ < count) refill();
        const std::uint64_t value = hold_ >> (64 - count);
        take(count);
        return value;
    }
    void take(int count) {
        hold_ <<= count;
        held_ -= count;
    }
    void refill() {  // from less than 56 bits to 56 or more
        if (bytes_.size() - position_ < 8) {
            refill_from_last();
            return;
        }
        const auto byte = [&](std::size_t i) {
            return static_cast<std::uint64_t>(bytes_[position_ + i]);
        };
        const std::uint64_t next = byte(0) << 56 | byte(1) << 48 | byte(2) << 40 | byte(3) << 32 |
                                   byte(4) << 24 | byte(5) << 16 | byte(6) << 8 | byte(7);
        const int whole = (63 - held_) >> 3;
        hold_ |= next >> (64 - 8 * whole) << (64 - 8 * whole) >> held_;
        held_ += 8 * whole;
        position_ += static_cast<std::size_t>(whole);
    }
    // From the last bytes, and what is beyond them.
    [[gnu::noinline, gnu::cold]] void refill_from_last() {
        while (held_ < 56) {
            std::uint64_t byte = 0;
            if (position_ < bytes_.size())
                byte = static_cast<std::uint64_t>(bytes_[position_++]);
            else
                ++past_;
            hold_ |= byte << (56 - held_);
            held_ += 8;
        }
    }

    std::span<const std::byte> bytes_;
    std::size_t position_ = 0;
    std::uint64_t past_ = 0;  // bytes of zeros put in behind the end
    std::uint64_t hold_ = 0;  // the bits to come, the next one highest, then zeros
    int held_ = 0;            // how many there are
    std::array<std::uint64_t, kFlagClasses> queues_;
    std::array<Rest, kFlagClasses - kShortClasses> rests_{};
};

}  // namespace ravel
