// Long paths over the mesh that turn as the decoder expects.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "strip/dual.h"

namespace ravel {

struct SteerOptions {
    Id look_ahead = 1;  // neighbours with fewer ways on than this go before the rule's choice
    // Per facet: the lightest goes first, the rule decides between equals. Empty: all equal.
    std::span<const std::uint32_t> weights = {};
};

// The cells in the order of the walk, and the facet by which the path came to each: kNone where a
// path starts.
struct Steered {
    std::vector<Id> order;
    std::vector<Id> came_by;
    std::vector<Id>
        entry;  // the facet by which each cell was entered; kNone for a component's first
};

// Paths through all cells. Linear.
Steered steer(const Complex& complex, const SteerOptions& options = {});

// The paths as a 2-matching, for `augment` to mend.
EdgeSet paths_of(const Steered& walk, const Dual& dual);

}  // namespace ravel
