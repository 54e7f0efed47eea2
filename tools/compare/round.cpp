#include "compare/round.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ravel::compare {

double round_if_asked(Mesh& mesh, const EncodeOptions& options) {
    if (!options.float32 || mesh.positions.scalar != Scalar::f64) return 0;
    Array rounded = make_array(Scalar::f32, 3, mesh.point_count());
    const std::span<const double> before = std::as_const(mesh.positions).as<double>();
    double largest = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const float after = static_cast<float>(before[i]);
        rounded.as<float>()[i] = after;
        const double error = std::fabs(static_cast<double>(after) - before[i]);
        if (std::isfinite(error)) largest = std::max(largest, error);
    }
    mesh.positions = std::move(rounded);
    return largest;
}

}  // namespace ravel::compare
