// The strip's course through one component, the same for surfaces and tets.
#pragma once

#include <vector>

#include "mesh/complex.h"

namespace ravel {

// From `cell` on: leaves each cell by its links first, and comes back to it when the excursion ends; then by
// the strip. `choose_exit(cell, returned, link, out)` names the facet to leave by, kNone where the strip ends or
// turns back, and whether it is a link; `visit(out, link, cell)` enters the cell beyond. Either returns
// false to give up. Ends when every excursion is over.
template <class ChooseExit, class Visit>
bool wind(Id cell, std::vector<Id>& pending, const ChooseExit& choose_exit, const Visit& visit) {
    pending.clear();
    for (bool returned = false;;) {
        bool link = false;
        Id out = kNone;
        if (!choose_exit(cell, returned, link, out)) return false;
        returned = out == kNone;
        if (returned) {
            if (pending.empty()) return true;
            cell = pending.back();
            pending.pop_back();
            continue;
        }
        if (link) pending.push_back(cell);
        if (!visit(out, link, cell)) return false;
    }
}

}  // namespace ravel
