// Collects flags and plain bits, then lays out the bit stream that FlagDecoder reads.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "entropy/flag_model.h"

namespace ravel {

class FlagEncoder {
  public:
    void flag(FlagModel& model, bool yes) {
        const int c = model.flag_class();
        ideal_bits_ += model.cost(yes);
        events_.push_back(static_cast<std::uint8_t>(c << 1 | (yes != model.likely())));
        model.update(yes);
    }
    // The `count` low bits of `value`, most significant first, as they are; count <= 64.
    void plain(std::uint64_t value, int count) {
        ideal_bits_ += count;
        while (count-- > 0)
            events_.push_back(
                static_cast<std::uint8_t>(kFlagClasses << 1 | ((value >> count) & 1)));
    }

    // What an ideal coder would make of the same models, plain bits included. For reports only.
    double ideal_bits() const { return ideal_bits_; }

    // One byte per flag is held until here. Linear.
    Bytes finish() const;

  private:
    double ideal_bits_ = 0;
    std::vector<std::uint8_t> events_;  // class << 1 | missed; class kFlagClasses for plain bits
};

}  // namespace ravel
