// Joins strips without touching a cell.
#pragma once

#include <cstdint>

#include "graph/joiner.h"
#include "strip/dual.h"

namespace ravel {

// Toggles fans (cells around an inner vertex or, for tets, edge) that alternate in and out of the
// set and meet each of their strips once, and lets paths take in neighbouring cycles at their ends.
// No strip is split, no path is made. Gives the number of strips saved. Near-linear.
std::uint64_t merge_fans(const Complex& complex, const Dual& dual, StripJoiner& joiner);

}  // namespace ravel
