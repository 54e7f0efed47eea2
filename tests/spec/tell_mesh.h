// A decoded mesh and its strip as text.
#pragma once

#include <string>

#include "ravel/ravel.h"

namespace ravel::test {

// Of a mesh of more cells than `most_cells` checksums are told.
void tell_mesh(const Decoded& decoded, Index most_cells, std::string& out);

}  // namespace ravel::test
