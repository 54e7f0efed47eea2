// Where the walk starts in each component.
#pragma once

#include <vector>

#include "mesh/complex.h"

namespace ravel {

// Polygons: `facet` is the side that comes first; kNone where the cell has no corners. Tets: the
// corner that comes last.
struct Seed {
    Id cell = 0;
    Id facet = kNone;
};

// One per component, in the order of their lowest cells: the first of the cells with most borders,
// turned so that its borders come last. Equal parts so start alike, and a mesh whose cells are in
// the order of a walk already starts where that did. Linear.
std::vector<Seed> choose_seeds(const Complex& complex);

}  // namespace ravel
