// The single strip over each component: which facets it runs through and where it makes excursions.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/complex.h"

namespace ravel {

enum class FactorMethod : std::uint8_t { steered, euler, two_pass, template_substitution };

struct StripCounts {
    Index components = 0;  // facet-connected
    Index cycles = 0;      // of the 2-factor, before merging
    Index paths = 0;       // of the 2-factor with two cells or more
    Index singletons = 0;  // of the 2-factor
    Index fan_merges = 0;
    Index links = 0;
    Index strips = 0;       // always == components
    Index open_strips = 0;  // of those, the ones that do not close
};

enum class FacetRole : std::uint8_t { none, strip, link };

// role is per facet of the complex and equal on twins. Per cell at most two facets are `strip`;
// they form cycles, paths and singletons. `link` facets join these to one tree per component. Every
// strip but the one a component starts with is a cycle or a singleton (a loop once split); that one
// may also be a path, which then starts at the root cell: the strip is open.
struct Strip {
    std::vector<FacetRole> role;
    std::vector<Id> roots;  // one cell per component, in the order the components are walked
    StripCounts counts;
};

}  // namespace ravel
