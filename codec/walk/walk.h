// What a walk leaves behind, for surfaces and tets alike, and what it asks of its driver.
//
// The walk goes from cell to cell by a fixed rule as long as there is an unvisited neighbour; where
// there is none it goes back the way it came to the last cell that has one. So it winds every cell
// of a component onto one thread, and where it goes costs no codes; only what the next cell looks
// like does. `read_strip` reads the single strip from it.
//
// The walk is one automaton with two drivers. Wherever it needs to know something about the next
// cell it calls its driver with a context and a question; the encoder's driver answers from the
// mesh and writes the answer down, the decoder's reads it. Everything else follows from the
// answers, so both sides hold the same state at every step. A driver has
//
//     bool flag(Context, bool truth)              a yes/no code
//     uint64 number(Context base, uint64 truth)   a number >= 0, kNumberSteps contexts from `base`
//     void begin_cell(Id gate)                    gate: walk facet the walk comes through, or kNone
//     void new_vertex(Id vertex, Id corner, const Stencil&)   met for the first time, at this
//                                                 corner of the cell
//     void end_cell(Id cell)                      corners and twins of the cell are now known
//     bool failed() const                         the decoder's bytes have ended or made no sense
//     const Point3& place(Id vertex)              where a visited vertex is; the same numbers on
//                                                 both sides
//
// and the truths, which the decoder's driver answers with zero: see SurfaceWalk and TetWalk.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/complex.h"
#include "mesh/point3.h"
#include "mesh/stencil.h"
#include "walk/contexts.h"

namespace ravel {

// The visited part of the complex, cells in order of visit, corners and facets numbered as in
// Complex. Surface cells start with the corner at which their entry side starts; tets have the
// entry facet opposite their last corner.
struct Walked {
    CellKind kind = CellKind::polygon;
    bool fours = false;        // every cell has four corners: `first` and `of` are left out
    std::vector<Id> first{0};  // cells + 1
    std::vector<Id> of;        // corner -> cell
    std::vector<Id> vertex;
    std::vector<Id> twin;  // kNone: border, or not yet met
    std::vector<Id> gate;  // per cell: the facet of an earlier cell it was entered through
    Id vertex_count = 0;

    Id cell_count() const { return static_cast<Id>(gate.size()); }
    Id begin(Id cell) const { return fours ? 4 * cell : first[cell]; }
    Id end(Id cell) const { return fours ? 4 * cell + 4 : first[cell + 1]; }
    Id degree(Id cell) const { return fours ? 4 : first[cell + 1] - first[cell]; }
    Id cell_of(Id facet) const { return fours ? facet / 4 : of[facet]; }
    Id next_in_cell(Id facet) const {
        if (fours) return (facet & ~Id{3}) | ((facet + 1) & 3);
        const Id cell = of[facet];
        return facet + 1 == first[cell + 1] ? first[cell] : facet + 1;
    }
    Id prev_in_cell(Id facet) const {
        if (fours) return (facet & ~Id{3}) | ((facet + 3) & 3);
        const Id cell = of[facet];
        return facet == first[cell] ? first[cell + 1] - 1 : facet - 1;
    }
    // The facet a cell was entered by; only where it has a gate.
    Id entry(Id cell) const { return begin(cell) + (kind == CellKind::tet ? 3 : 0); }
};

// Limits both sides know before the walk, and what the mesh has none of (so that it costs no
// codes).
struct WalkLimits {
    Id cells = 0;
    Id corners = 0;
    Id vertices = 0;
    Id uniform_degree = 0;  // surfaces: every cell has this degree; 0 where they differ
    bool has_border = true;
    // Tets: the grid that finds apexes by place (see VertexGrid), and whether most tets are inside
    // out.
    double grid_side = 1;
    std::array<std::uint32_t, 3> grid_count{1, 1, 1};
    bool mirrored = false;
    double shape_step = 0;  // tets: lengths that tell shapes of gates apart (see GateShapes); or 0
    bool leaders_move = false;      // tets: what leaders tell is moved, not mapped (see Leaders)
    std::size_t plausible = kNone;  // no more elements than this are reserved ahead
};

inline void reserve(Walked& walked, const WalkLimits& limits) {
    const std::size_t cells = std::min<std::size_t>(limits.cells, limits.plausible);
    const std::size_t corners = std::min<std::size_t>(limits.corners, limits.plausible);
    walked.gate.reserve(cells);
    if (!walked.fours) {
        walked.first.reserve(cells + 1);
        walked.of.reserve(corners);
    }
    walked.vertex.reserve(corners);
    walked.twin.reserve(corners);
}

// Visits every cell of the component whose first cell has just been visited. `choose_exit(cell)`
// names the open facet by which the walk leaves the cell, kNone where it has none; `visit(out)`
// enters the cell beyond, false to give up. Linear: a cell is left for good once.
template <class ChooseExit, class Visit>
bool wind(const Walked& walked, const ChooseExit& choose_exit, const Visit& visit) {
    for (Id cell = walked.cell_count() - 1;;) {
        const Id out = choose_exit(cell);
        if (out != kNone) {
            cell = walked.cell_count();
            if (!visit(out)) return false;
            continue;
        }
        const Id gate = walked.gate[cell];
        if (gate == kNone) return true;
        cell = walked.cell_of(gate);
    }
}

}  // namespace ravel
