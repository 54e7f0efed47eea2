// The certificate of a strip.
#pragma once

#include "mesh/complex.h"
#include "strip/strip.h"

namespace ravel {

// Is this a strip of the complex as strip.h promises it? The error's `at` is a cell or facet.
// Linear.
Status check_strip(const Complex& complex, const Strip& strip);

}  // namespace ravel
