// Meshes from a line of text: the corpus that is made, not stored. The same recipe gives the same
// mesh, to the bit, on every machine.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ravel/mesh.h"
#include "ravel/result.h"

namespace ravel::make {

// Fails with bad_option where the recipe makes no sense.
Result<Mesh> make_mesh(std::string_view recipe);

struct RecipeHelp {
    std::string pattern;  // "torus:quads=N[,seed=S]"
    std::string says;
};
std::vector<RecipeHelp> recipe_help();

}  // namespace ravel::make
