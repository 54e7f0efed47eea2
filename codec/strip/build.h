// From the complex to the single strip.
#pragma once

#include "mesh/complex.h"
#include "strip/strip.h"

namespace ravel {

struct StripEffort {
    // Strip edges on the longest ring that is toggled to merge strips (graph/rings.h): long rings
    // save links but make the strip turn more often. 0: fans only, as the paper.
    int ring_edges = 6;
};

// One strip per facet-connected component, whatever the complex. Near-linear.
Strip build_strip(const Complex& complex, FactorMethod method = FactorMethod::steered,
                  const StripEffort& effort = {});

}  // namespace ravel
