// The uniform grid peers put positions on: the one Draco uses, so that all of them round alike.
#pragma once

#include <cstdint>
#include <optional>

#include "ravel/mesh.h"

namespace ravel {
struct EncodeOptions;
}

namespace ravel::compare {

struct Grid {
    int bits = 0;
    double origin[3] = {0, 0, 0};
    double range = 0;  // of the longest side; never 0
    std::uint32_t top() const { return static_cast<std::uint32_t>((std::uint64_t{1} << bits) - 1); }
    double step() const { return range / top(); }
};

// Coordinate `k` of point `p` as float64.
double coordinate(const Mesh& mesh, Index p, int k);

bool all_finite(const Mesh& mesh);

// The grid the options ask for; for an error bound the fewest bits that keep it. Empty for
// lossless.
std::optional<Grid> grid_for(const Mesh& mesh, const EncodeOptions& options);

// Arithmetic in float32, step by step as Draco's quantiser does it.
std::uint32_t grid_number(const Grid& grid, double x, int k);
double grid_value(const Grid& grid, std::uint32_t number, int k);

}  // namespace ravel::compare
