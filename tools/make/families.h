// One function per family; a complaint is left in the recipe.
#pragma once

#include "make/builder.h"
#include "make/recipe.h"

namespace ravel::make {

Builder make_grid(Recipe& recipe);
Builder make_torus(Recipe& recipe);
Builder make_sphere(Recipe& recipe);
Builder make_moebius(Recipe& recipe);
Builder make_terrain(Recipe& recipe);
Builder make_polygons(Recipe& recipe);
Builder make_tets(Recipe& recipe);
Builder make_soup(Recipe& recipe);
Builder make_tiny(Recipe& recipe);

// The names `tiny:` knows.
std::vector<std::string> tiny_names();

}  // namespace ravel::make
