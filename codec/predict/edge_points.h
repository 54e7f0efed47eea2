// Points of their own on the edges of tets, as quadratic tets have them: one an edge, whichever
// tets share it, numbered as the walk meets the edges. Each lies near the middle of its edge.
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "mesh/reorder.h"
#include "mesh/stencil.h"
#include "predict/counting_sort.h"

namespace ravel {

struct EdgePoints {
    Index first = 0;                     // number of the first of these points
    std::vector<Id> of;                  // per tet six numbers of edges (kTetEdges)
    std::vector<std::array<Id, 2>> end;  // per edge its vertices, as the first tet has them
};

// `corners`: of tets, points below `vertex.size()`; `vertex`: of the walk, per point. An edge is
// known by its points, so that cuts do not part it. Linear; takes at most 168 bytes a tet.
inline EdgePoints edge_points_of(const std::vector<Index>& corners, const std::vector<Id>& vertex) {
    const std::size_t count = corners.size() / 4 * 6;
    const auto end_of = [&](std::size_t i, std::size_t k) {
        return static_cast<Id>(corners[i / 6 * 4 + kTetEdges[i % 6][k]]);
    };
    EdgePoints edges;
    edges.first = vertex.size();
    {
        std::vector<Id> sorted(count), low(count), high(count);
        std::iota(sorted.begin(), sorted.end(), Id{0});
        for (std::size_t i = 0; i < count; ++i) {
            low[i] = std::min(end_of(i, 0), end_of(i, 1));
            high[i] = std::max(end_of(i, 0), end_of(i, 1));
        }
        const auto points = static_cast<Id>(vertex.size());
        counting_sort(sorted, high, points);
        counting_sort(sorted, low, points);
        // Of equal ones the first, which stands before the others.
        edges.of.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const Id e = sorted[i];
            const bool again =
                i > 0 && low[e] == low[sorted[i - 1]] && high[e] == high[sorted[i - 1]];
            edges.of[e] = again ? edges.of[sorted[i - 1]] : e;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (edges.of[i] < i) {
            edges.of[i] = edges.of[edges.of[i]];
            continue;
        }
        edges.of[i] = static_cast<Id>(edges.end.size());
        edges.end.push_back({vertex[end_of(i, 0)], vertex[end_of(i, 1)]});
    }
    return edges;
}

// What is known around point i of those that no cell has: points of edges come first and have the
// ends of the edge, then up to three points before; others have the point before. `vertices`: of
// the walk.
inline Stencil stencil_of_unused(const EdgePoints& edges, Index i, Index vertices) {
    Stencil stencil;
    stencil.variant = 2;
    std::size_t place = 0;
    Index before = 1;
    if (i < edges.end.size()) {
        stencil.configuration = Configuration::edge;
        for (const Id end : edges.end[i]) stencil.at[place++] = end;
        before = std::min<Index>(i, 3);
    } else if (vertices + i == 0) {
        before = 0;
    }
    for (Index k = 1; k <= before; ++k) stencil.at[place++] = static_cast<Id>(vertices + i - k);
    return stencil;
}

}  // namespace ravel
