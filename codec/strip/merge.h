// Joins strips without touching a cell.
#pragma once

#include <cstdint>

#include "graph/cycles.h"
#include "strip/dual.h"

namespace ravel {

struct Merged {
    EdgeSet set;
    std::uint64_t fan_merges = 0;
    std::uint64_t strips = 0;  // that are left
};

// Toggles fans (cells around an inner vertex or, for tets, edge) that alternate in and out of the
// set and meet each of their strips once, then lets paths take in neighbouring cycles at their
// ends. No strip is split, no path is made. `strips` are those of the set. Near-linear.
Merged merge_fans(const Complex& complex, const Dual& dual, EdgeSet set, StripList strips);

}  // namespace ravel
