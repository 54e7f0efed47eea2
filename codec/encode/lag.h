// Which of the parts that were walked alike a part is most like.
#pragma once

#include "encode/walk_driver.h"
#include "predict/position_format.h"

namespace ravel {

// The lag (see follows.h) by which leaders would be followed best, by the sizes of what they miss.
// `places`: of all vertices, in units; `format`: by which they are guessed. Looks at some thousand
// vertices, and at kMostLag leaders of each.
int best_lag(const WalkRecord& record, const std::vector<Point3>& places,
             const PositionFormat& format);

}  // namespace ravel
