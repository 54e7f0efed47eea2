// The boundary of tets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ravel::web {

struct Surface {
    std::vector<std::uint32_t> points;  // three per triangle, counter-clockwise seen from outside
    std::vector<std::uint32_t> facets;  // 4 * tet + the corner it lies opposite to
};

// The facets that exactly one tet has. `corners`: four points per tet, positive volume. Hashing;
// linear. A facet that three tets share is no boundary.
Surface boundary_of(std::span<const std::uint32_t> corners);

}  // namespace ravel::web
