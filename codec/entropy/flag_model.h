// The adaptive probability of a yes/no code and the class it falls into. Encoder and decoder hold
// the same models and update them alike, in integers.
//
// A flag is not arithmetic-coded. Its model says which value is likely and how likely; the class
// groups models of like certainty, and the flags of a class ("as expected" or "missed") are
// run-length coded together. The run codes of all classes share one stream of bits, each run
// standing where the decoder first needs it. [Howard1996] names the scheme interleaved coding; the
// runs are [Golomb1966] codes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace ravel {

inline constexpr int kFlagClasses = 15;

// A run code of class c is `1` for kRunOf[c] flags as expected, or `0` and the length (below
// kRunOf[c]) of the run before a miss, in truncated binary. kRunOf is the length that has even odds
// at the middle of the class.
inline constexpr std::array<std::uint16_t, kFlagClasses> kRunOf{1,  2,  2,  3,   5,   7,   11,  17,
                                                                26, 43, 69, 121, 231, 462, 1386};
// Upper bounds of the chance of a miss, in 1/4096, from class 14 (least) down to class 1; above
// the last is class 0.
inline constexpr std::array<std::uint16_t, kFlagClasses - 1> kClassBound{
    4, 8, 16, 31, 51, 82, 135, 205, 307, 451, 655, 901, 1229, 1597};

namespace detail {
// Filled when the program starts: no packer makes much less of them, and a decoder for the web
// counts its bytes.
struct FlagTables {
    // By the chance of yes in 1/4096: twice the class, and 1 if yes is likely.
    std::array<std::uint8_t, 4096> verdict;
    // The steps of adaptation in 1/65536, by how many flags came.
    struct Rates {
        std::uint16_t slow, fast;
    };
    std::array<Rates, 511> rates;

    FlagTables() {
        for (unsigned c = 0; c < verdict.size(); ++c) {
            const unsigned miss = std::min(c, 4095 - c);
            unsigned bound = 0;
            while (bound < kClassBound.size() && miss > kClassBound[bound]) ++bound;
            verdict[c] =
                static_cast<std::uint8_t>((kFlagClasses - 1 - bound) << 1 | (c >= 2048 ? 1 : 0));
        }
        for (unsigned i = 0; i < rates.size(); ++i) {
            const auto slow = static_cast<std::uint16_t>(655360u / (10 * i + 13));
            rates[i] = {slow, std::max(slow, std::uint16_t{65536 / 20})};
        }
    }
};
inline const FlagTables kFlagTables;
}  // namespace detail

// Two estimates of the chance of "yes" learn at once: `fast` follows the last twenty flags, `slow`
// the last five hundred; their mean is what counts. Either's step of adaptation is 1 / (seen + 1.3)
// until it reaches its own. 22 bits keep rare misses apart where steps are small.
class FlagModel {
  public:
    FlagModel() = default;
    // As if `seen` flags had come already, of which `chance` / 65536 said yes.
    FlagModel(std::uint16_t chance, std::uint16_t seen)
        : fast_(std::uint32_t{chance} << 6), slow_(fast_), seen_(seen) {
        classify();
    }

    bool likely() const { return (verdict_ & 1) != 0; }
    int flag_class() const { return verdict_ >> 1; }
    // Bits that an ideal coder would take for the flag, the same on every machine. For reports, and
    // for the encoder's trials; no decoder asks.
    double cost(bool yes) const {
        const unsigned c = chance();
        return kBitsOf[(yes ? c : 65535u - c) >> 5];
    }
    void update(bool yes) {
        const std::uint32_t goal = yes ? kCertain : 0;
        const detail::FlagTables::Rates rates = detail::kFlagTables.rates[seen_];
        slow_ += step(goal, slow_, rates.slow);
        fast_ += step(goal, fast_, rates.fast);
        seen_ = static_cast<std::uint16_t>(seen_ + (seen_ + 1u < detail::kFlagTables.rates.size()));
        classify();
    }

  private:
    static const std::array<float, 2048> kBitsOf;  // by chance in 1/2048
    static constexpr std::uint32_t kCertain = (1u << 22) - 1;

    // (goal - now) * rate / 65536, rounded down; as a number to add modulo 2^32.
    static std::uint32_t step(std::uint32_t goal, std::uint32_t now, std::uint32_t rate) {
        const std::int64_t way = static_cast<std::int64_t>(goal) - static_cast<std::int64_t>(now);
        return static_cast<std::uint32_t>(way * static_cast<std::int64_t>(rate) >> 16);
    }
    unsigned chance() const { return (fast_ + slow_) >> 7; }  // in 1/65536
    // Once a flag has come, not when the next is asked for: that waits for it.
    void classify() { verdict_ = detail::kFlagTables.verdict[chance() >> 4]; }

    std::uint32_t fast_ = kCertain / 2 + 1, slow_ = kCertain / 2 + 1;
    std::uint16_t seen_ = 0;
    std::uint8_t verdict_ = 1;
};

}  // namespace ravel
