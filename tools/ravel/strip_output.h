// A materialised strip as a mesh file holds it.
#pragma once

#include "ravel/mesh.h"
#include "strip/materialise.h"

namespace ravel::tool {

// Cells in strip order with cell data `strip_position` (int64, along the strip of its component),
// `strip_component` where there are several, and `parent` (int64, a cell of the original mesh).
Mesh with_strip_data(Materialised&& strip);

Result<Mesh> mesh_of_strip(const Mesh& mesh, const Complex& complex, const Strip& strip);

}  // namespace ravel::tool
