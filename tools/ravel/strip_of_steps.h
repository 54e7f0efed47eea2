// The strip a decoded file runs along, as the strip room describes it.
#pragma once

#include <vector>

#include "ravel/ravel.h"
#include "strip/strip.h"

namespace ravel::tool {

// `steps` name only the facets by which cells are first entered; a loop's last facet, which leads
// back to its first cell, is found again from the complex. A component's first strip is closed
// wherever its ends touch. Fails with corrupt where the steps don't fit the complex.
Result<Strip> strip_of_steps(const Complex& complex, const std::vector<StripStep>& steps);

}  // namespace ravel::tool
