#include "entropy/flag_encoder.h"

#include <array>
#include <bit>

namespace ravel {
namespace {

// Of 0 < x < 1, by the series of the area tangent. Known when this is compiled: a decoder, which
// asks for no cost, then links neither the table nor a logarithm to fill it.
constexpr double log2_of(double x) {
    int whole = 0;
    for (; x < 1; x *= 2) --whole;
    const double z = (x - 1) / (x + 1);
    double sum = 0, power = z;
    for (int k = 1; k < 40; k += 2, power *= z * z) sum += power / k;
    return whole + 2 / 0.69314718055994531 * sum;
}

}  // namespace

constinit const std::array<float, 2048> FlagModel::kBitsOf = [] {
    std::array<float, 2048> bits{};
    for (std::size_t i = 0; i < bits.size(); ++i)
        bits[i] = static_cast<float>(-log2_of((static_cast<double>(i) + 0.5) / 2048));
    return bits;
}();

namespace {

class BitWriter {
  public:
    void put(std::uint32_t value, int count) {
        hold_ = hold_ << count | value;
        held_ += count;
        while (held_ >= 8) {
            held_ -= 8;
            bytes_.push_back(static_cast<std::byte>(hold_ >> held_));
        }
    }
    Bytes take() {
        if (held_ > 0) put(0, 8 - held_);
        return std::move(bytes_);
    }

  private:
    Bytes bytes_;
    std::uint64_t hold_ = 0;
    int held_ = 0;
};

// Truncated binary: the first `2^bits - size` values take bits - 1 bits, the others one more.
void put_below(BitWriter& out, std::uint32_t value, std::uint32_t size) {
    if (size <= 1) return;
    const int bits = static_cast<int>(std::bit_width(size - 1));
    const std::uint32_t brief = (std::uint32_t{1} << bits) - size;
    if (value < brief)
        out.put(value, bits - 1);
    else
        out.put(value + brief, bits);
}

}  // namespace

Bytes FlagEncoder::finish() const {
    // The runs of every class, in order: full runs, and runs cut short by a miss.
    struct Runs {
        std::vector<std::uint16_t> lengths;  // kRunOf for a full one
        std::size_t next = 0;
        std::uint32_t open = 0;  // flags as expected since the last run ended
        std::uint32_t left = 0;  // while laying out: flags of the current run still to come
    };
    std::array<Runs, kFlagClasses> runs;
    for (const std::uint8_t event : events_) {
        const auto c = static_cast<std::size_t>(event >> 1);
        if (c == kFlagClasses) continue;
        Runs& r = runs[c];
        if (event & 1) {
            r.lengths.push_back(static_cast<std::uint16_t>(r.open));
            r.open = 0;
        } else if (++r.open == kRunOf[c]) {
            r.lengths.push_back(kRunOf[c]);
            r.open = 0;
        }
    }
    for (std::size_t c = 0; c < runs.size(); ++c)
        if (runs[c].open > 0) runs[c].lengths.push_back(kRunOf[c]);

    BitWriter out;
    for (const std::uint8_t event : events_) {
        const auto c = static_cast<std::size_t>(event >> 1);
        if (c == kFlagClasses) {
            out.put(event & 1, 1);
            continue;
        }
        Runs& r = runs[c];
        if (r.left == 0) {
            const std::uint16_t length = r.lengths[r.next++];
            const bool full = length == kRunOf[c];
            out.put(full ? 1 : 0, 1);
            if (!full) put_below(out, length, kRunOf[c]);
            r.left = full ? kRunOf[c] : length + 1u;
        }
        --r.left;
    }
    return out.take();
}

}  // namespace ravel
