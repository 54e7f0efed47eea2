// The section `positions`: chooses the grid, measures its error, writes residuals along the walk.
#pragma once

#include "encode/walk_driver.h"
#include "predict/edge_points.h"
#include "predict/position_codes.h"
#include "ravel/ravel.h"

namespace ravel {

// Per point of the mesh what is to be coded.
struct PositionPlan {
    PositionFormat format;
    Grid grid;
    std::uint8_t bits = 0;  // of the longest side
    std::vector<Position> values;
    double bound = 0, error = 0;
};

// Chooses the grid that the options ask for; coordinates that are not finite, lie far out, or which
// a grid can't bring within max_error, are escaped. Error: a grid finer than can be held.
Result<PositionPlan> plan_positions(const Mesh& mesh, const EncodeOptions& options);

// The coordinates of a point, in units of its numbers.
Point3 units_of(const PositionPlan& plan, std::size_t point);

// Places of all points, as the walk will see them; for lossless tets this chooses the integers that
// stand for the floats.
std::vector<Point3> plan_places(const Mesh& mesh, PositionPlan& plan);

// `unused`: unused points, in the order they are appended, those of edges first.
// `fast`: nothing is tried out.
Bytes write_positions(PositionPlan& plan, const Complex& complex, const WalkRecord& record,
                      const std::vector<Index>& unused, const EdgePoints& edges, bool fast);

}  // namespace ravel
