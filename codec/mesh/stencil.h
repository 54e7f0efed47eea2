// What the walk knows around a vertex it meets for the first time.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>

#include "mesh/complex.h"

namespace ravel {

// The known vertices around a new one, in roles that depend on the configuration; kNone where there
// is none. Predictors weigh them. In a quad a b c d is entered through a -> b: the cell before has
// u_a and v_b beyond a and b, and the cell before that w_a and w_b beyond these; a cell behind the
// zipped side b -> c has u_b and v_c beyond b and c, and the next one x_b and x_c.
enum class Configuration : std::uint8_t {
    seed,  // first cell of a component: [previous vertex, the one before, the one before that]
    quad_third,   // quad, new corner follows b, the last one unknown too: [b a v_b u_a w_b w_a]
    quad_fourth,  // quad, last corner, third new: [a c b u_a v_b w_a w_b]
    quad_corner,  // quad, last corner, third from a zip: [a c b u_a v_b w_a w_b v_c u_b x_c x_b]
    triangle,     // [a b u_a v_b y x v_y u_x]: x is before a on the front and y behind b, and the
                  // cells behind these sides have u_x beyond a and v_y beyond b
    polygon,  // other degrees: [previous corner, the one before, the one before that, next known]
    tet,      // [x0 x1 x2 o y0 y1 y2]: gate, the apex behind it, the apexes across its edges
    border,   // [a b y z]: a tet's that goes on with the border beyond edge a b, y being the apex
              // of the triangle there, z the gate's vertex opposite
    led,      // a tet's that lies as the apex of a leader does: those of tet, then
              // [l0 l1 l2 q m]: the leader's gate, the apex behind it and that beyond it
    edge,     // [a b, then the points of edges before, latest first]: own point of edge a b
    count,
};
inline constexpr std::size_t kStencilSize = 12;
struct Stencil {
    Configuration configuration = Configuration::seed;
    std::uint8_t borders = 0;  // tet: bit e if there is a border across edge e, opposite x_e
    // triangle: by how many cells are known around a and b, below 10. seed: how many corners of its
    // cell were before it, at most 2; unused points have 2.
    std::uint8_t variant = 0;
    std::array<Id, kStencilSize> at = [] {
        std::array<Id, kStencilSize> none{};
        none.fill(kNone);
        return none;
    }();
};

inline Stencil stencil_of(Configuration configuration, std::initializer_list<Id> known) {
    Stencil stencil;
    stencil.configuration = configuration;
    std::copy(known.begin(), known.end(), stencil.at.begin());
    return stencil;
}

// The corners before and behind the new one in its cell, as far as the stencil tells.
inline std::array<Id, 2> neighbours_of(const Stencil& stencil) {
    const Configuration c = stencil.configuration;
    const bool both =
        c != Configuration::seed && c != Configuration::quad_third && c != Configuration::polygon;
    return {stencil.at[0], both ? stencil.at[1] : kNone};
}

}  // namespace ravel
