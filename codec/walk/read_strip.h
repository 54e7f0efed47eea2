// The single strip that a walk is.
#pragma once

#include <cstdint>
#include <vector>

#include "walk/walk.h"

namespace ravel {

// Every step of the walk is part of a strip or a link between two; a strip is a run of steps that
// closes to a cycle by a facet no step uses, or a single cell; the one that starts with a component
// may stay open. Links join the strips of a component to a tree.
struct StripReading {
    std::vector<std::uint8_t> link;  // per cell: the step to it is a link
    Index links = 0;
    Index open_strips = 0;
    Index added_cells = 0;  // once every link splits its two cells
};

// Of all readings one with fewest links. Near-linear.
StripReading read_strip(const Walked& walked);

}  // namespace ravel
