// What flags and bits would take, for writers that choose: a Coder that leaves all models as they
// are.
#pragma once

#include <cstdint>

#include "base/context.h"
#include "base/rice_code.h"

namespace ravel {

// Of a coder that writes: `cost(context, yes)` are the bits of a flag now.
template <class Coder>
struct Pricing {
    const Coder& coder;
    double bits = 0;

    bool flag(Context context, bool truth) {
        bits += coder.cost(context, truth);
        return truth;
    }
    std::uint64_t plain(std::uint64_t truth, int count) {
        bits += count;
        return truth;
    }
    std::uint64_t rice(std::uint64_t truth, int count) {
        bits += rice_bits(truth, count);
        return truth;
    }
};

}  // namespace ravel
