// The tree of strips: which facets are links, and where each component starts.
#pragma once

#include "graph/joiner.h"
#include "strip/dual.h"
#include "strip/strip.h"

namespace ravel {

// Roles and roots for strips of which at most one per component is a path. Links form a spanning
// tree of the strips of each component; components come in the order of their lowest cells.
// Near-linear.
Strip link_strips(const Complex& complex, const Dual& dual, StripJoiner& joiner);

}  // namespace ravel
