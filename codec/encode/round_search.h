// Looks for the round faces of a tet mesh's border.
#pragma once

#include <vector>

#include "encode/walk_driver.h"
#include "predict/round_face.h"

namespace ravel {

// Faces on which many vertices of the border lie, within a unit or a 2^15th of its size, the
// largest first. Pieces of the border around some of its triangles are fitted, and what fits is
// refitted to all that lies on it. `places`: of the vertices, in units; those in `skip` are passed
// over. O(vertices).
RoundFaceList find_round_faces(const WalkRecord& record, const std::vector<Point3>& places,
                               const std::vector<bool>& skip);

}  // namespace ravel
