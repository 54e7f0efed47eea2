// Polygons through Draco, which knows triangles only: an attribute marks the edges that cutting
// added.
#pragma once

#include <memory>

#include <draco/mesh/mesh.h>

#include "ravel/mesh.h"

namespace ravel::compare {

// Fans of triangles from first corners; polygons with fewer than three corners are left out. With
// `mark_edges` every triangle corner says whether the edge opposite it was added, as Draco's OBJ
// reader does it for -preserve_polygons. With `flat` all positions are zero.
std::unique_ptr<draco::Mesh> draco_mesh_of(const Mesh& mesh, bool double_positions, bool mark_edges,
                                           bool flat);

// The mesh Draco's OBJ writer would write: triangles are merged across marked edges.
Mesh mesh_of_draco(const draco::Mesh& mesh);

}  // namespace ravel::compare
