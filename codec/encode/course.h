// How the walk goes through a mesh: what both sides must know before it, and the walk itself.
#pragma once

#include "container/head.h"
#include "encode/positions.h"
#include "encode/walk_driver.h"
#include "walk/fold_walk.h"
#include "walk/surface_walk.h"
#include "walk/tet_walk.h"

namespace ravel {

struct CoursePlan {
    BlockHead block;  // but for the counts of the strip
    WalkLimits limits;
    WalkPlan walk;
};

// Completes the format of `positions` by what the walk asks of it. `may_fold`: tets that do not
// repeat are walked by FoldWalk. Linear.
CoursePlan plan_course(const Mesh& mesh, const Complex& complex, PositionPlan& positions,
                       bool may_fold);

// As the walk's models begin.
std::vector<FlagModel> walk_models(CellKind kind);

struct Course {
    WalkRecord record;
    Walked walked;
    bool is_whole = true;  // false: FoldWalk cannot walk this mesh
};

// Walks, and gives every answer to `codes` (see WalkCodes).
template <class Codes>
Course run_course(const Complex& complex, const CoursePlan& plan, Codes& codes) {
    const auto run = [&](auto driver, auto make_walk) {
        auto walk = make_walk(driver);
        const bool whole = walk.run();
        return Course{driver.take(), walk.take(), whole};
    };
    const bool copies = plan.block.has_copies, flips = plan.block.has_flips;
    if (plan.block.by_folds)
        return run(TetEncodeDriver<Codes>(complex, plan.walk, codes, copies, flips),
                   [&](auto& driver) { return FoldWalk(driver, plan.limits); });
    if (complex.kind == CellKind::tet)
        return run(TetEncodeDriver<Codes>(complex, plan.walk, codes, copies, flips),
                   [&](auto& driver) { return TetWalk(driver, plan.limits); });
    return run(SurfaceEncodeDriver<Codes>(complex, plan.walk, codes, copies, flips),
               [&](auto& driver) { return SurfaceWalk(driver, plan.limits); });
}

}  // namespace ravel
