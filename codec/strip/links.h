// The tree of strips: which facets are links, and where each component starts.
#pragma once

#include "strip/dual.h"
#include "strip/strip.h"

namespace ravel {

// Roles and roots for a 2-matching with at most one path per component. Links form a spanning tree
// of the strips of each component; components come in the order of their lowest cells. Near-linear.
Strip link_strips(const Complex& complex, const Dual& dual, const EdgeSet& set);

}  // namespace ravel
