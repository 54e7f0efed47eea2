// What --float32 asks for before anything is packed.
#pragma once

#include "ravel/ravel.h"

namespace ravel::compare {

// Rounds float64 positions to float32 where the options ask for it; gives the largest change of a
// finite coordinate that stays finite.
double round_if_asked(Mesh& mesh, const EncodeOptions& options);

}  // namespace ravel::compare
