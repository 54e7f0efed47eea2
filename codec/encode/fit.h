// Fits the predictor's weights to a mesh.
#pragma once

#include <functional>
#include <vector>

#include "predict/predictor.h"
#include "predict/round_faces.h"

namespace ravel {

// `values` are coordinates per vertex of the walk, in units; vertices with a stencil of
// configuration `seed` and those in `skip` (non-empty: per vertex) are passed over. Weighted least
// squares, reweighted towards least absolute error, on at most some four thousand vertices per
// set of weights. A set keeps its defaults, or has none, where fitting does not pay for storing.
// `along`: vertices that lie along a border beside their gate are taken to be guessed from there.
Weights fit_weights(const std::vector<Stencil>& stencils, const std::vector<Point3>& values,
                    const std::vector<bool>& skip, bool mirrored, const RoundFaces* along);

// The largest grain such that all weights of a set are multiples of 2^grain; 0 if all are 0.
int grain_of(const std::array<std::int16_t, kFeatures>& weights);

}  // namespace ravel
