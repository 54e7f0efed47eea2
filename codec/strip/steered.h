// Long paths over the mesh that turn as the decoder expects.
#pragma once

#include "strip/dual.h"

namespace ravel {

struct SteerOptions {
    int look_ahead = 2;  // neighbours with fewer ways on than this go before the rule's choice
};

// A 2-matching of paths, for `augment` to mend. Linear.
EdgeSet steer(const Complex& complex, const Dual& dual, const SteerOptions& options = {});

}  // namespace ravel
