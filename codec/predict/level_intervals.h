// Levels by place: intervals of an axis, in the lists of which levels are looked up.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "mesh/point3.h"

namespace ravel {

// What the places of a list hold that no level has taken.
template <std::size_t places>
constexpr std::array<double, places> no_levels() {
    std::array<double, places> none{};
    none.fill(std::numeric_limits<double>::infinity());
    return none;
}

// Lists begin where a line of the cache does; not where addresses have 32 bits (pages), as memory
// comes as it is there.
inline constexpr std::size_t kListAlignment = sizeof(void*) == 8 ? 64 : alignof(double);

// Intervals of length 2^bits.
class LevelIntervals {
  public:
    explicit LevelIntervals(int bits)
        : scale_(std::ldexp(1.0, -bits)), length_(std::ldexp(1.0, bits)) {}

    std::int64_t of(double x) const { return whole_below(x * scale_); }

    // The level nearest to x, less than half an interval away: in the interval of x, or the one
    // beside if that may hold a nearer one. `look(interval, best)` puts a nearer one there.
    template <class Near, class Look>
    Near nearest(double x, const Look& look) const {
        Near best;
        best.distance = length_ / 2;
        const double at = x * scale_;
        const std::int64_t interval = whole_below(at);
        const double behind = at - static_cast<double>(interval);
        look(interval, best);
        const bool low = behind < 0.5;
        if (best.distance > (low ? behind : 1 - behind) * length_)
            look(low ? interval - 1 : interval + 1, best);
        return best;
    }

  private:
    double scale_, length_;
};

}  // namespace ravel
