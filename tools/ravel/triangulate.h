// Polygons to triangles, for programs that take nothing else.
#pragma once

#include "ravel/mesh.h"

namespace ravel::tool {

// Every polygon becomes the fan from its first corner: (0, i, i + 1). No geometry is asked, so a
// concave polygon may give triangles outside it. Polygons with fewer than three corners stay as
// they are. Values of cells and corners go to all triangles that come from them. Tets stay as they
// are.
Mesh triangulate(const Mesh& mesh);

}  // namespace ravel::tool
