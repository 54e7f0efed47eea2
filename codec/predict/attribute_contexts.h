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
    // Companions: border, marks beside, borders beside that are none, how straight on.
    static constexpr ContextBlock mark_facet{minus_zero.end(), 2, 4, 4, 7};
    static constexpr ContextBlock mark_line{mark_facet.end(), 7, 4, 4};  // flat, lines at the ends
    static constexpr ContextBlock mark_point{mark_line.end(), 4, 2};     // lines there, border
    static constexpr ContextBlock mark_turn{mark_point.end(), 2, 2, 2};
    static constexpr ContextBlock mark_block{mark_turn.end(), 3};
    // Numbers that come once: how long steps have repeated; how the last two were found.
    static constexpr ContextBlock number_echo{mark_block.end(), kHints};
    static constexpr ContextBlock number_next{number_echo.end(), 16};
    static constexpr ContextBlock number_guess{number_next.end(), 16};
    static constexpr ContextBlock number_near{number_guess.end(), 2};
    // Turns of cells: how the cell before is left, or what came last; steps of the answer.
    static constexpr ContextBlock turn{number_near.end(), 9, 9, 8};
    static constexpr Context count = turn.end();
};

}  // namespace ravel
