// Guesses a new vertex from the known vertices around it (the walk's Stencil). Every configuration
// has a base guess and difference vectors, its features; the guess is base + sum of weight *
// feature. Weights are fixed-point (1/4096), fitted per file by the encoder or the defaults below.
// The parallelogram within a polygon is [IsenburgAlliez2002]'s; the fitted weights are ours.
#pragma once

#include <array>
#include <cstdint>

#include "mesh/stencil.h"

namespace ravel {

inline constexpr std::size_t kFeatures = 10;
inline constexpr int kWeightBits = 12;

// One axis of a stencil turned into base and features; all are scaled by `divisor`.
template <class T>
struct Features {
    T base{};
    std::array<T, kFeatures> feature{};
};

inline constexpr std::array<std::size_t, static_cast<std::size_t>(Configuration::count)>
    kFeatureCount{2, 5, 6, 10, 3, 3, 2};
inline constexpr std::int64_t divisor_of(Configuration c) {
    return c == Configuration::tet ? 3 : 1;
}

using Weights =
    std::array<std::array<std::int16_t, kFeatures>, static_cast<std::size_t>(Configuration::count)>;
inline constexpr Weights kDefaultWeights{{
    {0},
    {0},
    {0},
    {0},
    {0},
    {2048, 0, 1024},
    {2048},
}};

// `p(i)` is the coordinate of the stencil's i-th vertex; `has(i)` tells whether there is one.
template <class T, class Point, class Has>
Features<T> features_of(Configuration configuration, const Point& p, const Has& has) {
    Features<T> f;
    auto& t = f.feature;
    switch (configuration) {
        case Configuration::seed:
            if (has(0)) f.base = p(0);
            if (has(1)) t[0] = p(0) - p(1);
            if (has(2)) t[1] = p(1) - p(2);
            break;
        case Configuration::quad_third:  // b a v_b u_a w_b w_a
            f.base = p(0) + p(0) - p(2);
            t[0] = p(0) - p(2);
            t[1] = p(1) - p(0);
            t[2] = (p(3) - p(2)) - (p(1) - p(0));
            if (has(4) && has(5)) {
                t[3] = (p(0) - p(2)) - (p(2) - p(4));
                t[4] = (p(1) - p(3)) - (p(3) - p(5));
            }
            break;
        case Configuration::quad_corner:  // a c b u_a v_b w_a w_b v_c u_b x_c x_b
            t[6] = (p(1) - p(7)) - (p(2) - p(8));
            t[7] = p(2) - p(8);
            if (has(9) && has(10)) {
                t[8] = (p(1) - p(7)) - (p(7) - p(9));
                t[9] = (p(2) - p(8)) - (p(8) - p(10));
            }
            [[fallthrough]];
        case Configuration::quad_fourth:  // a c b u_a v_b w_a w_b
            f.base = p(0) + p(1) - p(2);
            t[0] = p(1) - p(2);
            t[1] = p(0) - p(2);
            if (has(3) && has(4)) {
                t[2] = (p(0) - p(3)) - (p(2) - p(4));
                t[3] = p(2) - p(4);
            }
            if (has(5) && has(6)) {
                t[4] = (p(0) - p(3)) - (p(3) - p(5));
                t[5] = (p(2) - p(4)) - (p(4) - p(6));
            }
            break;
        case Configuration::triangle:  // a b u_a v_b
            f.base = p(0) + p(1) - p(2);
            t[0] = p(3) - p(2);
            t[1] = p(0) - p(1);
            t[2] = p(1) - p(3);
            break;
        case Configuration::polygon:  // x w ww z
            f.base = p(0);
            t[0] = p(0) - p(1);
            t[1] = p(1) - p(2);
            if (has(3)) t[2] = p(3) - p(0);
            break;
        case Configuration::tet: {  // x0 x1 x2 o y0 y1 y2
            f.base = p(0) + p(1) + p(2);
            t[0] = f.base - (p(3) + p(3) + p(3));
            t[1] = (p(4) + p(5) + p(6)) - f.base;
            break;
        }
        case Configuration::count:
            break;
    }
    return f;
}

inline double guess(Configuration configuration, const Features<double>& f,
                    const Weights& weights) {
    const auto& w = weights[static_cast<std::size_t>(configuration)];
    double sum = 0;
    for (std::size_t i = 0; i < kFeatures; ++i) sum += static_cast<double>(w[i]) * f.feature[i];
    return (f.base + sum / 4096.0) / static_cast<double>(divisor_of(configuration));
}

}  // namespace ravel
