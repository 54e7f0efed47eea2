// How finely the walk tells shapes of gates apart, where tets repeat.
#pragma once

#include "encode/course.h"

namespace ravel {

// The `shape_step` with which a stretch of the walk takes fewest bits, positions included; 0 where
// leaders do not pay. `plan` but for the step. Few tets repeat in most meshes, and a count of
// facets, which depends on no order, tells these. Linear, but of most facets of a large mesh only a
// vertex is looked at, and the trials, at most three, have a bounded number of cells.
Index choose_shape_step(const Complex& complex, const CoursePlan& plan);

}  // namespace ravel
