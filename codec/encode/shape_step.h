// How finely the walk tells shapes of gates apart, where tets repeat.
#pragma once

#include <vector>

#include "mesh/complex.h"
#include "mesh/point3.h"

namespace ravel {

// The step of GateShapes under which facets of one shape most often have their apexes at one place;
// 0 where that would not pay. `places` are of points; `grid_side` is that of the walk's grid. Does
// not depend on the order of cells and points, nor, where places differ, of corners. Linear, but of most facets of a large mesh
// only a vertex is looked at.
Index choose_shape_step(const Complex& complex, const std::vector<Point3>& places, Index grid_side);

}  // namespace ravel
