#include "encode/course.h"

#include <algorithm>
#include <cmath>

#include "encode/leader_plan.h"
#include "entropy/priors.h"
#include "walk/priors.h"

namespace ravel {
namespace {

WalkLimits limits_of(const Complex& complex) {
    WalkLimits limits;
    limits.cells = complex.cell_count();
    limits.corners = static_cast<Id>(complex.twin.size());
    limits.vertices = static_cast<Id>(complex.point.size());
    limits.has_border =
        std::find(complex.twin.begin(), complex.twin.end(), kNone) != complex.twin.end();
    if (complex.kind == CellKind::polygon && limits.cells > 0) {
        limits.uniform_degree = complex.degree(0);
        for (Id c = 1; c < limits.cells && limits.uniform_degree != 0; ++c)
            if (complex.degree(c) != limits.uniform_degree) limits.uniform_degree = 0;
    }
    return limits;
}

// The grid in which the walk looks for apexes: cubes of half a mean edge, fewer where the box is
// large beside the mesh. Where there are more tets of negative volume than of positive, the walk
// looks for mirror images.
void choose_grid(const Complex& complex, const std::vector<Point3>& places, BlockHead& block) {
    Point3 high{};
    // Whole numbers add up to the same whatever the order of the cells and their corners.
    std::uint64_t length = 0;
    Index edges = 0, negative = 0, positive = 0;
    for (Id base = 0; base < complex.twin.size(); base += 4) {
        std::array<Point3, 4> p;
        for (Id i = 0; i < 4; ++i) {
            p[i] = places[complex.point[complex.vertex[base + i]]];
            for (std::size_t axis = 0; axis < 3; ++axis)
                high[axis] = std::max(high[axis], p[i][axis]);
        }
        const double volume = dot(cross(minus(p[1], p[0]), minus(p[2], p[0])), minus(p[3], p[0]));
        positive += volume > 0;
        negative += volume < 0;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const Point3 edge = minus(p[i], p[j]);
                length += static_cast<std::uint64_t>(std::min(std::sqrt(dot(edge, edge)), 0x1p30));
                ++edges;
            }
    }
    block.mirrored = negative > positive;
    double side = edges == 0 ? 1 : std::max<double>(1, static_cast<double>(length / edges / 2));
    for (;; side = std::floor(side * 1.25) + 1) {
        std::uint64_t blocks = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double count = std::floor(high[axis] / side) + 1;
            block.grid_count[axis] = static_cast<std::uint32_t>(std::min(count, 1048576.0));
            blocks *= grid_blocks_of(block.grid_count[axis]);
        }
        if (blocks <= most_grid_blocks(block.vertices)) break;
    }
    block.grid_side = static_cast<Index>(side);
}

}  // namespace

std::vector<FlagModel> walk_models(CellKind kind) {
    return kind == CellKind::tet
               ? models_of(tet::kPriors, tet::kContexts, tet::kPriorSeen)
               : models_of(surface::kPriors, surface::kContexts, surface::kPriorSeen);
}

CoursePlan plan_course(const Mesh& mesh, const Complex& complex, PositionPlan& positions,
                       bool may_fold) {
    CoursePlan plan;
    WalkLimits& limits = plan.limits = limits_of(complex);
    BlockHead& block = plan.block;
    block.cells = limits.cells;
    block.corners = limits.corners;
    block.vertices = limits.vertices;
    block.uniform_degree = limits.uniform_degree;
    block.has_border = limits.has_border;
    block.has_flips =
        std::find(complex.flipped.begin(), complex.flipped.end(), 1) != complex.flipped.end();
    std::vector<bool> used(mesh.point_count(), false);
    for (const Id p : complex.point) {
        block.points += !used[p];
        used[p] = true;
    }
    block.has_copies = block.points != block.vertices;
    block.unused_points = mesh.point_count() - block.points;
    block.companions = mesh.companions.size();
    plan.walk.seeds = choose_seeds(complex);
    block.components = plan.walk.seeds.size();
    plan.walk.places = plan_places(mesh, positions);
    if (mesh.kind != CellKind::tet) return plan;
    choose_grid(complex, plan.walk.places, block);
    limits.grid_side = static_cast<double>(block.grid_side);
    limits.grid_count = block.grid_count;
    limits.mirrored = positions.format.mirrored = block.mirrored;
    choose_leaders(complex, plan);
    // Where tets repeat, leaders tell next to everything.
    block.by_folds = may_fold && block.shape_step == 0;
    positions.format.leaders_move = block.leaders_move;
    positions.format.usual_start = usual_start_of(positions.format, limits.grid_side);
    return plan;
}

}  // namespace ravel
