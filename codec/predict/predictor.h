// Guesses a new vertex from the known vertices around it (the walk's Stencil). Every configuration
// has a base guess and difference vectors, its features; the guess is base + sum of weight *
// feature. Weights are fixed-point (1/4096), fitted per file by the encoder or the defaults below.
// The parallelogram within a polygon is [IsenburgAlliez2002]'s; the fitted weights are ours, and so
// is the apex of a tet: over the middle of its gate, as high as the edges around are long.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/point3.h"
#include "mesh/stencil.h"

namespace ravel {

inline constexpr std::size_t kFeatures = 10;

struct Features {
    Point3 base{};
    std::array<Point3, kFeatures> feature{};
};

inline constexpr std::size_t kConfigurations = static_cast<std::size_t>(Configuration::count);
inline constexpr std::array<std::size_t, kConfigurations> kFeatureCount{2, 5, 6, 10, 3, 3, 7};

using Weights = std::array<std::array<std::int16_t, kFeatures>, kConfigurations>;
inline constexpr Weights kDefaultWeights{{
    {0},
    {0},
    {0},
    {0},
    {0},
    {2048, 0, 1024},
    {0, -256, 1400, 800, 600, 2800, 0},
}};

namespace detail {

inline Point3 plus(const Point3& a, const Point3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point3 times(const Point3& a, double s) {
    return {a[0] * s, a[1] * s, a[2] * s};
}
inline double length(const Point3& a) {
    return std::sqrt(dot(a, a));
}

// x0 x1 x2 o y0 y1 y2: the gate, the apex behind it, the apexes across its edges.
// Up is where the gate runs counter-clockwise, or clockwise where tets are `mirrored`.
inline void tet_features(const std::array<Point3, kStencilSize>& p, bool mirrored, Features& f) {
    const Point3 u = minus(p[1], p[0]), v = minus(p[2], p[0]), w = minus(p[2], p[1]);
    const Point3 sum = plus(plus(p[0], p[1]), p[2]);
    const Point3 middle{sum[0] / 3, sum[1] / 3, sum[2] / 3};
    f.base = middle;
    f.feature[0] = minus(middle, p[3]);
    const Point3 around = plus(plus(p[4], p[5]), p[6]);
    f.feature[1] = minus({around[0] / 3, around[1] / 3, around[2] / 3}, middle);
    const Point3 n = cross(u, v);
    const double square = dot(n, n), edge = (length(u) + length(v) + length(w)) / 3;
    if (square > 0) {
        const Point3 up = times(n, (mirrored ? -1 : 1) / std::sqrt(square));
        double beside = 0;
        for (std::size_t k = 0; k < 3; ++k)
            beside += length(minus(p[4 + k], p[(k + 1) % 3])) + length(minus(p[4 + k], p[(k + 2) % 3]));
        double behind = 0;
        for (std::size_t k = 0; k < 3; ++k) behind += length(minus(p[3], p[k]));
        f.feature[2] = times(up, edge);
        f.feature[3] = times(up, beside / 6);
        f.feature[4] = times(up, behind / 3);
        // The circumcentre, unless the gate is a sliver and it lies far off.
        const Point3 vn = times(cross(v, n), dot(u, u)), nu = times(cross(n, u), dot(v, v));
        const Point3 centre = plus(p[0], times(plus(vn, nu), 1 / (2 * square)));
        const Point3 aside = minus(centre, middle);
        if (length(aside) < edge) f.feature[5] = aside;
    }
    // Nearer apexes count more.
    Point3 pull{};
    double all = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point3 way = minus(p[4 + k], middle);
        const double share = 1 / (dot(way, way) + 1);
        pull = plus(pull, times(way, share));
        all += share;
    }
    f.feature[6] = times(pull, 1 / all);
}

}  // namespace detail

// `values` are of all vertices so far; `mirrored`: tets, most of which are inside out.
inline Features features_of(const Stencil& stencil, const std::vector<Point3>& values,
                            bool mirrored) {
    using detail::plus;
    Features f;
    auto& t = f.feature;
    std::array<Point3, kStencilSize> p{};
    const auto has = [&](std::size_t i) { return stencil.at[i] != kNone; };
    for (std::size_t i = 0; i < kStencilSize; ++i)
        if (has(i)) p[i] = values[stencil.at[i]];
    const auto way = [&](std::size_t i, std::size_t j) { return minus(p[i], p[j]); };
    const auto bend = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
        return minus(minus(p[i], p[j]), minus(p[k], p[l]));
    };
    switch (stencil.configuration) {
        case Configuration::seed:
            if (has(0)) f.base = p[0];
            if (has(1)) t[0] = way(0, 1);
            if (has(2)) t[1] = way(1, 2);
            break;
        case Configuration::quad_third:  // b a v_b u_a w_b w_a
            f.base = minus(plus(p[0], p[0]), p[2]);
            t[0] = way(0, 2);
            t[1] = way(1, 0);
            t[2] = bend(3, 2, 1, 0);
            if (has(4) && has(5)) {
                t[3] = bend(0, 2, 2, 4);
                t[4] = bend(1, 3, 3, 5);
            }
            break;
        case Configuration::quad_corner:  // a c b u_a v_b w_a w_b v_c u_b x_c x_b
            t[6] = bend(1, 7, 2, 8);
            t[7] = way(2, 8);
            if (has(9) && has(10)) {
                t[8] = bend(1, 7, 7, 9);
                t[9] = bend(2, 8, 8, 10);
            }
            [[fallthrough]];
        case Configuration::quad_fourth:  // a c b u_a v_b w_a w_b
            f.base = minus(plus(p[0], p[1]), p[2]);
            t[0] = way(1, 2);
            t[1] = way(0, 2);
            if (has(3) && has(4)) {
                t[2] = bend(0, 3, 2, 4);
                t[3] = way(2, 4);
            }
            if (has(5) && has(6)) {
                t[4] = bend(0, 3, 3, 5);
                t[5] = bend(2, 4, 4, 6);
            }
            break;
        case Configuration::triangle:  // a b u_a v_b
            f.base = minus(plus(p[0], p[1]), p[2]);
            t[0] = way(3, 2);
            t[1] = way(0, 1);
            t[2] = way(1, 3);
            break;
        case Configuration::polygon:  // x w ww z
            f.base = p[0];
            t[0] = way(0, 1);
            t[1] = way(1, 2);
            if (has(3)) t[2] = way(3, 0);
            break;
        case Configuration::tet:
            detail::tet_features(p, mirrored, f);
            break;
        case Configuration::count:
            break;
    }
    return f;
}

inline Point3 guess(Configuration configuration, const Features& f, const Weights& weights) {
    const auto c = static_cast<std::size_t>(configuration);
    Point3 sum{};
    for (std::size_t i = 0; i < kFeatureCount[c]; ++i) {
        const double w = static_cast<double>(weights[c][i]);
        if (w != 0) sum = detail::plus(sum, detail::times(f.feature[i], w));
    }
    return {f.base[0] + sum[0] / 4096, f.base[1] + sum[1] / 4096, f.base[2] + sum[2] / 4096};
}

}  // namespace ravel
