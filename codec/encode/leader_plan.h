// Whether gates have leaders, how finely their shapes are told apart, and how what they tell is
// carried over.
#pragma once

#include "encode/course.h"

namespace ravel {

// Sets `shape_step` and `leaders_move` of a plan to those with which a stretch of the walk takes
// fewest bits, positions included; a step of 0 where leaders do not pay. Little repeats in most
// meshes, and counts that depend on no order tell these. Linear, but of most facets of a large mesh
// only a vertex is looked at, and the trials, at most four, have a bounded number of cells.
void choose_leaders(const Complex& complex, CoursePlan& plan);

}  // namespace ravel
