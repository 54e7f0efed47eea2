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

// Places of all points, as the walk will see them; for lossless tets this chooses the integers that
// stand for the floats.
std::vector<Point3> plan_places(const Mesh& mesh, PositionPlan& plan);

// What is to be coded, in order.
struct CodedPositions {
    const PositionPlan& plan;
    const Complex& complex;
    const WalkRecord& record;
    const std::vector<Index>& unused;  // points as appended, those of edges first
    const EdgePoints& edges;
    std::vector<Position> values;  // those of the plan, in that order

    std::size_t vertices() const { return record.vertex_of.size(); }
    std::size_t size() const { return vertices() + unused.size(); }
};
CodedPositions in_order(const PositionPlan& plan, const Complex& complex, const WalkRecord& record,
                        const std::vector<Index>& unused, const EdgePoints& edges);

// How positions are coded, and for followers which vertex leads (see plan_follows).
struct ChosenFormat {
    PositionFormat format;
    std::vector<std::uint8_t> leads;
};

// From `plan.format`, the format that makes the fewest bytes, but for what costs more time than it
// is worth. `fast`: nothing is tried out. `threads`: how many trials may run at a time; the choice
// is the same.
ChosenFormat choose_format(const CodedPositions& all, bool fast, int threads);

// The head of the section, and all of it.
Bytes position_head_of(const PositionFormat& format);
Bytes write_positions(const CodedPositions& all, const ChosenFormat& chosen);

}  // namespace ravel
