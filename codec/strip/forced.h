// How many of a strip's links no other strip could do without.
#pragma once

#include <cstdint>

#include "mesh/complex.h"
#include "strip/strip.h"

namespace ravel {

// A proven lower bound of the links of any strip of the complex (graph/bound.h); `strip` tells
// where to look for the proof. Near-linear.
std::uint64_t forced_links(const Complex& complex, const Strip& strip);

}  // namespace ravel
