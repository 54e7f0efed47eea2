// A strip made, proven and materialised.
#pragma once

#include <functional>

#include "strip/build.h"
#include "strip/materialise.h"

namespace ravel::tool {

struct Wound {
    Complex complex;
    Strip strip;
    Materialised made;
    double seconds = 0;  // from the mesh to the strip, without the proofs
};

struct WindOptions {
    FactorMethod method = FactorMethod::steered;
    StripOptions strip;
    // Called with the complex before the strip is made, to set strip.weights.
    std::function<std::vector<std::uint32_t>(const Complex&)> weigh;
};

// An error of code `corrupt` is a certificate that fails: a bug.
Result<Wound> wind(const Mesh& mesh, const WindOptions& options);

}  // namespace ravel::tool
