// The order in which a cell's facets are tried as exits: the one rule that the strip's maker
// follows and the walker predicts by.
#pragma once

#include <vector>

#include "mesh/complex.h"

namespace ravel {

// Sets `out` to the facets of the entry's cell other than the entry. Polygon: leftmost first, seen
// from inside with the entry behind: the sides met clockwise from the entry. Tet: the local order
// of the corners after the entry's.
inline void exit_order(const Complex& complex, Id entry, std::vector<Id>& out) {
    out.clear();
    if (complex.kind == CellKind::tet) {
        for (Id i = 1; i < 4; ++i) out.push_back((entry & ~Id{3}) | ((entry + i) & 3));
        return;
    }
    for (Id f = complex.prev_in_cell(entry); f != entry; f = complex.prev_in_cell(f))
        out.push_back(f);
}

}  // namespace ravel
