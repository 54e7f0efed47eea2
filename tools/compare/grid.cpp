#include "compare/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ravel/ravel.h"

namespace ravel::compare {

double coordinate(const Mesh& mesh, Index p, int k) {
    const std::size_t at = 3 * p + static_cast<std::size_t>(k);
    if (mesh.positions.scalar == Scalar::f64) return mesh.positions.as<double>()[at];
    return static_cast<double>(mesh.positions.as<float>()[at]);
}

bool all_finite(const Mesh& mesh) {
    for (Index p = 0; p < mesh.point_count(); ++p)
        for (int k = 0; k < 3; ++k)
            if (!std::isfinite(coordinate(mesh, p, k))) return false;
    return true;
}

std::optional<Grid> grid_for(const Mesh& mesh, const EncodeOptions& options) {
    if (!options.position_bits && !options.max_error && !options.max_error_relative &&
        !options.lattice)
        return std::nullopt;
    Grid grid;
    double square = 0;  // of the box's diagonal
    for (int k = 0; k < 3; ++k) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (Index p = 0; p < mesh.point_count(); ++p) {
            const double x = coordinate(mesh, p, k);
            if (!std::isfinite(x)) continue;
            low = std::min(low, x), high = std::max(high, x);
        }
        if (!(low <= high)) continue;
        square += (high - low) * (high - low);
        grid.origin[k] = static_cast<double>(static_cast<float>(low));
        grid.range = std::max(
            grid.range, static_cast<double>(static_cast<float>(high) - static_cast<float>(low)));
    }
    if (!(grid.range > 0)) grid.range = 1;
    if (options.position_bits) {
        grid.bits = *options.position_bits;
    } else {
        const double error = options.max_error ? *options.max_error
                             : options.lattice ? *options.lattice / 2
                                               : *options.max_error_relative * std::sqrt(square);
        grid.bits = 1;
        while (grid.bits < 30 && grid.step() / 2 > error) ++grid.bits;
    }
    return grid;
}

std::uint32_t grid_number(const Grid& grid, double x, int k) {
    const float scale = static_cast<float>(grid.top()) / static_cast<float>(grid.range);
    const float offset = static_cast<float>(x) - static_cast<float>(grid.origin[k]);
    const float number = std::floor(offset * scale + 0.5f);
    return number <= 0 ? 0 : static_cast<std::uint32_t>(number);
}

double grid_value(const Grid& grid, std::uint32_t number, int k) {
    const float step = static_cast<float>(grid.range) / static_cast<float>(grid.top());
    const float offset = static_cast<float>(number) * step;
    return static_cast<double>(offset + static_cast<float>(grid.origin[k]));
}

}  // namespace ravel::compare
