// The mesh as the decoder has it before it restores any order.
#pragma once

#include "encode/course.h"
#include "encode/positions.h"
#include "mesh/reorder.h"
#include "predict/ground.h"
#include "ravel/ravel.h"

namespace ravel {

// Points, cells and what rides along in the order of the strip; positions as they come back;
// attribute values as they are. The rest as in Ground.
struct StripMesh {
    Mesh mesh;
    std::vector<Id> point;
    std::vector<std::uint8_t> flipped;
    std::vector<Stencil> stencils;

    Ground<Walked> ground(const Walked& walked) const {
        return {walked, mesh, point, flipped, stencils};
    }
};
StripMesh strip_mesh_of(const Mesh& mesh, const Complex& complex, const WalkRecord& record,
                        const Reorder& order, const EdgePoints& edges, const PositionPlan& plan);

}  // namespace ravel
