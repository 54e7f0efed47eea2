// The strip that a walk makes when its pockets are linked instead of repaired.
#pragma once

#include "strip/steered.h"
#include "strip/strip.h"

namespace ravel {

// A walk that follows the decoder's rule costs no turns, but leaves pockets behind at its dead
// ends. Here every step of the walk stays, as part of a strip or as a link: along the walk's tree
// each cell goes on to at most one other, the path from a component's first cell may stay open, and
// every other run of cells is a singleton or closes by a facet that the walk did not use. Of all
// such readings of the tree, one with fewest links. Near-linear.
Strip link_pockets(const Complex& complex, const Steered& walk);

// The same, with the loops merged around fans where that saves links. A merge makes the strip turn
// unexpectedly at a few cells, a link splits cells.
Strip merge_pockets(const Complex& complex, const Steered& walk);

// Cells that the links of a strip add once it is materialised.
Index added_cells(const Complex& complex, const Strip& strip);

}  // namespace ravel
