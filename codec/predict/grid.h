// Positions on an integer grid: point = origin + step * q, in IEEE double, each operation rounded
// by itself, then rounded to float32 where the mesh has float32. This header is the arithmetic of
// the decoder; the encoder measures its errors with it.
#pragma once

#include <array>
#include <cfloat>
#include <cstdint>
#include <limits>

#include "base/float32.h"
#include "ravel/mesh.h"

namespace ravel {

struct Grid {
    std::array<double, 3> origin{};
    double step = 1;
};

// A float32 beyond its range is infinite, as in IEEE 754.
static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559);
// Nothing is computed in a wider type than it is written in, as x87 would.
static_assert(FLT_EVAL_METHOD == 0);

inline double coordinate_of(const Grid& grid, std::size_t axis, std::int64_t q, Scalar scalar) {
    const double x = grid.origin[axis] + grid.step * static_cast<double>(q);
    return scalar == Scalar::f32 ? to_float32(x) : x;
}

// Grid coordinates stay below this, so that predictions can't overflow.
inline constexpr std::int64_t kMostGrid = std::int64_t{1} << 40;

}  // namespace ravel
