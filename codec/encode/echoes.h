// Finds how a mesh repeats itself: planes of symmetry, and vertices that stand on one another.
#pragma once

#include <vector>

#include "predict/echoes.h"

namespace ravel {

struct Echoes {
    std::vector<Echo> likely;  // the best plane across each axis; vertices on one another
    std::vector<Echo> more;    // second planes, and steps along an axis
};

// `places` are coordinates in units; `may_move` false: mirrors through zero alone. O(n log n).
Echoes find_echoes(const std::vector<Point3>& places, bool may_move);

}  // namespace ravel
