#include "encode/leader_plan.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <compare>

#include "encode/fit.h"
#include "predict/round_faces.h"
#include "walk/gate_shapes.h"
#include "walk/tet_front.h"

namespace ravel {
namespace {

// Facets from the side of the cell that they are of, those behind which one of some points is.
// Which points depends on where they are.
std::vector<Id> some_facets(const Complex& complex, const std::vector<Point3>& places) {
    constexpr std::size_t kFacets = 16384;  // about so many
    const std::uint64_t one_in = complex.twin.size() / kFacets + 1;
    std::vector<bool> is_taken(places.size());
    for (std::size_t p = 0; p < places.size(); ++p)
        is_taken[p] = hash_of(places[p], 1, 0) % one_in == 0;
    std::vector<Id> facets;
    for (Id f = 0; f < complex.twin.size(); ++f)
        if (complex.twin[f] != kNone && is_taken[complex.point[complex.vertex[f]]])
            facets.push_back(f);
    return facets;
}

struct Seen {
    std::uint64_t shape = 0, apex = 0;  // hashes; that of the apex stands for both

    auto operator<=>(const Seen&) const = default;
};

// The share of facets whose apex lies as that of another of their shape, which was picked at
// random: of a shape's n facets, the sum of squares of how many have their apex at one place,
// divided by n.
double led_share(std::vector<Seen>& seen) {
    std::sort(seen.begin(), seen.end());
    double led = 0;
    for (std::size_t i = 0; i < seen.size();) {
        const std::size_t first = i;
        double squares = 0;
        while (i < seen.size() && seen[i].shape == seen[first].shape) {
            const std::size_t begin = i;
            while (i < seen.size() && seen[i] == seen[begin]) ++i;
            squares += static_cast<double>(i - begin) * static_cast<double>(i - begin);
        }
        led += squares / static_cast<double>(i - first) - 1;
    }
    return seen.empty() ? 0 : led / static_cast<double>(seen.size());
}

// Have most points one of a few numbers of tets around, as in lattices, however far they are
// astray? What counts is how likely two points have the same number.
bool is_regular(const Complex& complex, std::size_t points) {
    constexpr double kRegular = 0.2;  // Delaunay meshes 0.06
    std::vector<std::uint32_t> around(points, 0);
    for (const Id v : complex.vertex) ++around[complex.point[v]];
    std::array<double, 256> count{};
    double all = 0;
    for (const std::uint32_t n : around) {
        if (n == 0) continue;
        ++count[std::min<std::size_t>(n, count.size() - 1)];
        ++all;
    }
    double same = 0;
    for (const double n : count) same += n * n;
    return same > kRegular * all * all;
}

// Steps that are worth a trial, none where hardly anything repeats. Lattices that are bent need
// large ones; what repeats exactly, and is no lattice, small ones.
std::vector<Index> likely_steps(const Complex& complex, const std::vector<Point3>& places,
                                Index grid_side) {
    constexpr double kSome = 0.05, kMany = 0.2;
    const auto place = [&](Id v) -> const Point3& { return places[complex.point[v]]; };
    const std::vector<Id> facets = some_facets(complex, places);
    std::vector<Seen> seen;
    const auto share_with = [&](Index step) {
        seen.clear();
        for (const Id f : facets) {
            const Id base = f & ~Id{3};
            const auto& triple = kOutward[f & 3];
            const std::array<Id, 3> gate{complex.vertex[base + triple[0]],
                                         complex.vertex[base + triple[1]],
                                         complex.vertex[base + triple[2]]};
            const GateShape found =
                shape_of(gate, complex.vertex[f], 1 / static_cast<double>(step), place);
            const Point3 way =
                minus(place(complex.vertex[complex.twin[f]]), place(gate[found.first]));
            seen.push_back(
                {found.shape, hash_of(way, 1 / static_cast<double>(grid_side), found.shape)});
        }
        return led_share(seen);
    };
    if (share_with(std::max<Index>(grid_side / 2, 1)) < kSome &&
        !is_regular(complex, places.size()))
        return {};
    std::vector<Index> steps{grid_side};
    double most = kMany;
    Index small = 0;
    for (const Index step : {Index{16}, Index{4}, Index{1}}) {
        if (step >= grid_side) continue;
        const double share = share_with(step);
        if (share > most) most = share, small = step;
    }
    if (small > 0) steps.push_back(small);
    return steps;
}

// About what the first cells of the walk and the positions of their vertices take, in bits.
double bits_with(const Complex& complex, CoursePlan plan, Index step, bool move) {
    constexpr Id kCells = 16384;
    plan.limits.shape_step = static_cast<double>(step);
    plan.limits.leaders_move = move;
    plan.limits.cells = std::min(plan.limits.cells, kCells);
    WalkCodes codes{{}, walk_models(complex.kind)};
    const WalkRecord record = run_course(complex, plan, codes).record;
    std::vector<Point3> values;
    std::vector<bool> skip;
    for (std::size_t v = 0; v < record.vertex_of.size(); ++v) {
        values.push_back(plan.walk.places[complex.point[record.vertex_of[v]]]);
        skip.push_back(record.copy_of[v] != kNone);
    }
    const RoundFaces planes;  // no round ones
    Predictor predictor(fit_weights(record.stencils, values, skip, plan.limits.mirrored, &planes),
                        plan.limits.mirrored, move);
    double bits = codes.out.ideal_bits();
    for (std::size_t v = 0; v < values.size(); ++v) {
        if (skip[v]) continue;
        const Stencil stencil = stencil_along(record.stencils[v], values, values[v], planes);
        const Point3 off = minus(values[v], predictor.guess(stencil, values));
        for (const double x : off)
            bits += static_cast<double>(
                std::bit_width(static_cast<std::uint64_t>(std::min(0x1p60, std::abs(x) + 0.5))));
    }
    return bits;
}

}  // namespace

void choose_leaders(const Complex& complex, CoursePlan& plan) {
    constexpr double kWorth = 0.99;  // of the bits without
    const std::vector<Index> steps = likely_steps(complex, plan.walk.places, plan.block.grid_side);
    if (steps.empty()) return;
    double least = kWorth * bits_with(complex, plan, 0, false);
    Index best = 0;
    const auto offer = [&](Index step, bool move) {
        const double bits = bits_with(complex, plan, step, move);
        if (!(bits < least)) return;
        least = bits;
        best = step;
        plan.block.leaders_move = move;
    };
    for (const Index step : steps) offer(step, false);
    offer(best > 0 ? best : steps.front(), true);
    plan.block.shape_step = best;
    plan.limits.shape_step = static_cast<double>(best);
    plan.limits.leaders_move = plan.block.leaders_move;
}

}  // namespace ravel
