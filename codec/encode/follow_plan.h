// Which of the parts that were walked alike is to lead each part.
#pragma once

#include <cstdint>
#include <vector>

#include "encode/walk_driver.h"
#include "predict/position_format.h"

namespace ravel {

// Per vertex of the walk where its leader is told (see lead_codes.h): the place in its list of what
// leads the rest of its part best, by the sizes of what would be missed. `places`: of all vertices,
// in units; `format`: by which they are guessed. For each part one pass over it for each of the
// list, as far as that may be the best.
std::vector<std::uint8_t> plan_follows(const WalkRecord& record, const std::vector<Point3>& places,
                                       const PositionFormat& format);

}  // namespace ravel
