// Do two surfaces have the same polygons? For codecs that renumber points and faces: polygons are
// compared as cyclic sequences of the places their corners are at.
#pragma once

#include "compare/contender.h"

namespace ravel::compare {

struct PolygonMatch {
    Index expected = 0;    // polygons of the original
    Index found = 0;       // of those, polygons that came back
    Index extra = 0;       // polygons that came back and were not in the original
    double max_error = 0;  // over points of the original whose place came back
};

// Places are grid points, or exact positions where `grid` is empty. Degenerate polygons count too.
PolygonMatch match_polygons(const Mesh& original, const Mesh& decoded,
                            const std::optional<Grid>& grid);

}  // namespace ravel::compare
