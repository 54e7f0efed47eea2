// From the complex to the single strip.
#pragma once

#include <cstdint>
#include <span>

#include "mesh/complex.h"
#include "strip/strip.h"

namespace ravel {

// Which edges of two_pass and template_substitution are strips: the factor's own, or the others, as
// the paper does for tets. The other methods have the factor's own.
enum class Reading : std::uint8_t { matched, unmatched };

struct StripOptions {
    // Strip edges on the longest ring that is toggled to merge strips (graph/rings.h): long rings
    // save links but make the strip turn more often. 0: fans only, as the paper; else what rings
    // leave is merged by rotations (graph/rotate.h).
    int ring_edges = 6;
    Reading reading = Reading::matched;
    // Per facet, equal on twins: the strips of FactorMethod::steered prefer light ones to the
    // walker's rule. Empty: the rule alone.
    std::span<const std::uint32_t> weights = {};
};

// One strip per facet-connected component, whatever the complex. Near-linear.
Strip build_strip(const Complex& complex, FactorMethod method = FactorMethod::steered,
                  const StripOptions& options = {});

}  // namespace ravel
