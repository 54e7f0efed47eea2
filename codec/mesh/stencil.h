// What the walk knows around a vertex it meets for the first time.
#pragma once

#include <array>
#include <cstdint>

#include "mesh/complex.h"

namespace ravel {

// The known vertices around a new one, in roles that depend on the configuration; kNone where there is
// none. Predictors weigh them.
enum class Configuration : std::uint8_t {
    seed,          // first cell of a component: [previous vertex, the one before, the one before that]
    quad_third,    // quad, new corner follows b, the last one unknown too: [b, a, v_b, u_a]
    quad_fourth,   // quad, last corner, third new: [a + c - b ...]: [a, c, b, u_a, v_b]
    quad_corner,   // quad, last corner, third from a zip: [a, c, b, u_a, v_b, v_c, u_b]
    triangle,      // [a, b, u_a, v_b]
    polygon,       // other degrees: [previous corner, the one before, the one before that, next known]
    tet,           // [x0, x1, x2, o, y0, y1, y2]
    count,
};
inline constexpr std::size_t kStencilSize = 7;
struct Stencil {
    Configuration configuration = Configuration::seed;
    std::array<Id, kStencilSize> at{kNone, kNone, kNone, kNone, kNone, kNone, kNone};
};

}  // namespace ravel
