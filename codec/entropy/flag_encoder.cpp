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

}  // namespace

// `0` and the length in truncated binary: the first `2^bits - full` lengths take bits - 1 bits, the
// others one more.
FlagEncoder::Code FlagEncoder::cut_run(std::uint32_t length, std::uint32_t full) {
    if (full <= 1) return {0, 1};
    const auto bits = static_cast<std::uint8_t>(std::bit_width(full - 1));
    const std::uint32_t brief = (std::uint32_t{1} << bits) - full;
    if (length < brief) return {length, bits};
    return {length + brief, static_cast<std::uint8_t>(bits + 1)};
}

Bytes FlagEncoder::finish() const {
    BitWriter out;
    for (const Code& code : codes_) out.put(code.value, code.bits);
    return out.take();
}

}  // namespace ravel
