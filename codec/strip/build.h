// From the complex to the single strip.
#pragma once

#include "mesh/complex.h"
#include "strip/strip.h"

namespace ravel {

// One strip per facet-connected component, whatever the complex. Near-linear.
Strip build_strip(const Complex& complex, FactorMethod method = FactorMethod::steered);

}  // namespace ravel
