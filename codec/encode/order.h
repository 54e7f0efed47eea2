// From the mesh's order to the walk's.
#pragma once

#include "encode/walk_driver.h"
#include "mesh/reorder.h"
#include "ravel/ravel.h"

namespace ravel {

// Points of the complex in the order of their first vertex on the walk, then the others; cells in
// the order of the walk.
Reorder reorder_of(const Mesh& mesh, const Complex& complex, const WalkRecord& record);

// Where the elements of the mesh are once it has been decoded.
OrderMaps maps_of(const Reorder& order, const Mesh& mesh, bool order_is_kept);

}  // namespace ravel
