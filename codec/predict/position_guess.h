// What a vertex is guessed to be, and how guesses become numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "mesh/stencil.h"
#include "predict/position_format.h"

namespace ravel {

inline bool is_edge(const Stencil& stencil) {
    return stencil.configuration == Configuration::edge;
}

struct PositionGuess {
    const Stencil* stencil;
    Point3 at{};
    std::array<std::int64_t, 3> whole{};  // of the coordinates
    std::array<std::size_t, 3> axes{};    // in the order in which they are coded
    bool along = false;                   // a border tells the last of them
};
// The coordinate of `value` on the axis before, if that is coded before it.
inline const double* before_of(const PositionGuess& guess, std::size_t axis, const Point3& value) {
    return axis == 0 || guess.axes[2] == axis - 1 ? nullptr : &value[axis - 1];
}

// Of coordinates in units.
struct Rounding {
    std::int64_t most;  // values are below that
    bool cuts;          // there are digits behind the point

    explicit Rounding(const PositionFormat& format)
        : most(format.most()), cuts(format.numbers.digits > 0) {}

    double clamped(double x) const {
        const auto limit = static_cast<double>(most);
        return std::clamp(x, -limit, limit);
    }
    // The whole part nearest to a value; where there are digits behind the point they are cut off.
    std::int64_t whole_of(double units) const {
        return cuts ? static_cast<std::int64_t>(units) : whole_below(units + 0.5);
    }
    // What whole_of took off.
    double part_of(double units, std::int64_t whole) const {
        return cuts ? 0 : units - static_cast<double>(whole);
    }
};

// A file may hold any residual: the sum wraps.
inline std::int64_t sum_of(std::int64_t guess, std::int64_t r) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(guess) +
                                     static_cast<std::uint64_t>(r));
}

}  // namespace ravel
