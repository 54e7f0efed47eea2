// The contexts of what rides along: residuals first (see ResidualContexts), then the rest.
#pragma once

#include "predict/around.h"
#include "predict/residual_context.h"

namespace ravel {

struct AttributeContexts {
    // Is it the tuple of a neighbour? How that one lies, hint, votes for it and against.
    static constexpr ContextBlock same{ResidualContexts::count, kBesideKinds, kHints, 4, 4};
    static constexpr ContextBlock lacks{same.end(), 2, 2};        // the one before; any neighbours
    static constexpr ContextBlock fresh{lacks.end(), 3, kHints};  // neighbours with other tuples
    static constexpr ContextBlock recent{fresh.end(), 8};
    // Does a part go on across a link? Neighbours with it and against, walls about, a former wall.
    static constexpr ContextBlock flood{recent.end(), 4, 3, 21, 2};
    static constexpr ContextBlock outlier{flood.end(), 2};  // the one before
    static constexpr ContextBlock minus_zero{outlier.end(), 3};
    static constexpr Context count = minus_zero.end();
};

}  // namespace ravel
