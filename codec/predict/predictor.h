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

#include "mesh/carry.h"
#include "mesh/point3.h"
#include "mesh/stencil.h"

namespace ravel {

inline constexpr std::size_t kFeatures = 10;

struct Features {
    Point3 base{};
    std::array<Point3, kFeatures> feature{};
};

// Sets of weights: one for each configuration from seed to border, but for triangle, the variants
// of which come last.
inline constexpr std::size_t kTriangleSet = 7, kTriangleVariants = 10;
inline constexpr std::size_t kWeightSets = kTriangleSet + kTriangleVariants;
inline std::size_t weight_set_of(const Stencil& stencil) {
    if (stencil.configuration == Configuration::triangle) return kTriangleSet + stencil.variant;
    const auto c = static_cast<std::size_t>(stencil.configuration);
    return c - (stencil.configuration > Configuration::triangle);
}
inline constexpr std::array<std::size_t, kWeightSets> kFeatureCount{2, 5, 6, 10, 3, 7, 5, 7, 7,
                                                                    7, 7, 7, 7,  7, 7, 7, 7};

// The set of border, and the only feature of it that leaves the plane.
inline constexpr std::size_t kBorderSet = 6, kBorderHeight = 4;

// Weights of a set are told in steps of 2^grain.
inline constexpr int kMostGrain = 15;

// Those of triangles are the best for some forty meshes of animals, heads and machines.
using Weights = std::array<std::array<std::int16_t, kFeatures>, kWeightSets>;
inline constexpr Weights kDefaultWeights{{
    {0},
    {0},
    {0},
    {0},
    {2048, 0, 1024},
    {160, 450, 1230, 2040, -730, 4430, -520},
    {450, 190, 2860, 90, 0},
    {-1630, 84, -378, -37, -7, -33, 236},
    {-2934, -527, -1097, 250, -88, -236, -283},
    {-2678, -345, -634, 119, 134, -181, -188},
    {-3751, -1091, -1927, 1548, -123, -919, -169},
    {0, -416, -540, 408, 31, -386, -48},
    {0, -1099, -1993, 1001, 888, -656, -494},
    {0, -1011, -2649, 1871, -72, -673, -264},
    {0, -1078, -2096, 1366, 288, -762, -393},
    {0, -1008, -1883, 953, 721, -655, -480},
    {0, -1445, -2619, 1257, 636, -588, -530},
}};

// The parallelogram is all that triangles are guessed by.
constexpr Weights without_triangles(Weights weights) {
    for (std::size_t c = kTriangleSet; c < kWeightSets; ++c) weights[c] = {};
    return weights;
}

// But for tet and border base and features are sums of the stencil's points, each so many times. A
// sum that names a missing point is none.
using Sum = std::array<std::int8_t, kStencilSize>;
inline constexpr std::size_t kSumConfigurations = static_cast<std::size_t>(Configuration::tet);
inline constexpr std::array<std::array<Sum, 1 + kFeatures>, kSumConfigurations> kSums{{
    // seed: the base is the last vertex
    {{{1}, {1, -1}, {0, 1, -1}}},
    // quad_third [b a v_b u_a w_b w_a]: b carried on
    {{{2, 0, -1}, {1, 0, -1}, {-1, 1}, {1, -1, -1, 1}, {1, 0, -2, 0, 1}, {0, 1, 0, -2, 0, 1}}},
    // quad_fourth [a c b u_a v_b w_a w_b]: the parallelogram a + c - b
    {{{1, 1, -1},
      {0, 1, -1},
      {1, 0, -1},
      {1, 0, -1, -1, 1},
      {0, 0, 1, 0, -1},
      {1, 0, 0, -2, 0, 1},
      {0, 0, 1, 0, -2, 0, 1}}},
    // quad_corner [a c b u_a v_b w_a w_b v_c u_b x_c x_b]: the same, and across the zipped side
    {{{1, 1, -1},
      {0, 1, -1},
      {1, 0, -1},
      {1, 0, -1, -1, 1},
      {0, 0, 1, 0, -1},
      {1, 0, 0, -2, 0, 1},
      {0, 0, 1, 0, -2, 0, 1},
      {0, 1, -1, 0, 0, 0, 0, -1, 1},
      {0, 0, 1, 0, 0, 0, 0, 0, -1},
      {0, 1, 0, 0, 0, 0, 0, -2, 0, 1},
      {0, 0, 1, 0, 0, 0, 0, 0, -2, 0, 1}}},
    // triangle [a b u_a v_b y x v_y u_x]: the parallelogram a + b - u_a
    {{{1, 1, -1},
      {0, 0, -1, 1},
      {1, -1},
      {0, 1, 0, -1},
      {0, -1, 0, 0, 1},
      {-1, 0, 0, 0, 0, 1},
      {0, -1, 0, 0, 0, 0, 1},
      {-1, 0, 0, 0, 0, 0, 0, 1}}},
    // polygon [x w ww z]: the corner before
    {{{1}, {1, -1}, {0, 1, -1}, {-1, 0, 0, 1}}},
}};

namespace detail {

inline Point3 plus(const Point3& a, const Point3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point3 times(const Point3& a, double s) {
    return {a[0] * s, a[1] * s, a[2] * s};
}
inline bool names_missing(const Sum& sum, const Stencil& stencil) {
    for (std::size_t i = 0; i < kStencilSize; ++i)
        if (sum[i] != 0 && stencil.at[i] == kNone) return true;
    return false;
}

inline std::array<Point3, kStencilSize> points_of(const Stencil& stencil,
                                                  const std::vector<Point3>& values) {
    std::array<Point3, kStencilSize> p{};
    for (std::size_t i = 0; i < kStencilSize; ++i)
        if (stencil.at[i] != kNone) p[i] = values[stencil.at[i]];
    return p;
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
            beside +=
                length(minus(p[4 + k], p[(k + 1) % 3])) + length(minus(p[4 + k], p[(k + 2) % 3]));
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

// a b y z: within the plane of a b y, from the middle of the edge away from y, as far as y is, as
// the edge is long, as the others are, and to z; then up from the plane.
inline void border_features(const std::array<Point3, kStencilSize>& p, Features& f) {
    const Point3 u = minus(p[1], p[0]), n = cross(u, minus(p[2], p[0]));
    const double square = dot(n, n), edge = length(u);
    f.base = times(plus(p[0], p[1]), 0.5);
    f.feature[0] = minus(f.base, p[2]);
    if (!(square > 0)) return;
    const Point3 up = times(n, 1 / std::sqrt(square)), away = cross(u, up);  // as long as the edge
    f.feature[1] = away;
    f.feature[2] =
        times(away, (length(minus(p[2], p[0])) + length(minus(p[2], p[1]))) / (2 * edge));
    const Point3 beyond = minus(p[3], f.base);
    f.feature[3] = minus(beyond, times(up, dot(beyond, up)));
    f.feature[kBorderHeight] = times(up, edge);
}

inline Point3 guess_by_leader(const std::array<Point3, kStencilSize>& p, bool maps) {
    return carried(p[11], {p[7], p[8], p[9], p[10]}, {p[0], p[1], p[2], p[3]}, maps);
}

// Of tet and border.
inline Features features_of_shape(const Stencil& stencil, const std::vector<Point3>& values,
                                  bool mirrored) {
    Features f;
    const auto p = points_of(stencil, values);
    if (stencil.configuration == Configuration::tet)
        tet_features(p, mirrored, f);
    else
        border_features(p, f);
    return f;
}

}  // namespace detail

// `values` are of all vertices so far; `mirrored`: tets, most of which are inside out.
inline Features features_of(const Stencil& stencil, const std::vector<Point3>& values,
                            bool mirrored) {
    const auto c = static_cast<std::size_t>(stencil.configuration);
    if (c >= kSumConfigurations) return detail::features_of_shape(stencil, values, mirrored);
    Features f;
    const auto p = detail::points_of(stencil, values);
    for (std::size_t k = 0; k <= kFeatureCount[weight_set_of(stencil)]; ++k) {
        const Sum& sum = kSums[c][k];
        if (detail::names_missing(sum, stencil)) continue;
        Point3& to = k == 0 ? f.base : f.feature[k - 1];
        for (std::size_t i = 0; i < kStencilSize; ++i)
            if (sum[i] != 0) to = detail::plus(to, detail::times(p[i], sum[i]));
    }
    return f;
}

// Guesses by given weights. But for tet and border a guess is a sum of factor * point over 4096, in
// the order of the stencil; factors are integers.
class Predictor {
  public:
    Predictor(const Weights& weights, bool mirrored, bool leaders_move = false)
        : weights_(weights), mirrored_(mirrored), leaders_move_(leaders_move) {
        for (auto& factors : known_) factors.fill({});
    }

    Point3 guess(const Stencil& stencil, const std::vector<Point3>& values) {
        if (stencil.configuration == Configuration::tet ||
            stencil.configuration == Configuration::border)
            return guess_by_features(stencil, values);
        if (stencil.configuration == Configuration::led)
            return detail::guess_by_leader(detail::points_of(stencil, values), !leaders_move_);
        if (stencil.configuration == Configuration::edge)
            return detail::times(detail::plus(values[stencil.at[0]], values[stencil.at[1]]), 0.5);
        Factors& factors = known_[weight_set_of(stencil)][missing_of(stencil)];
        if (!factors.known) find(stencil, factors);
        Point3 g{};
        for (std::size_t i = 0; i < factors.count; ++i)
            g = detail::plus(g, detail::times(values[stencil.at[factors.slot[i]]], factors.of[i]));
        return {g[0] / 4096, g[1] / 4096, g[2] / 4096};
    }

  private:
    // Factors depend on the weights, and on which of the points are missing that may be.
    static constexpr std::size_t kMissing = 16;
    struct Factors {
        bool known = false;
        std::uint8_t count = 0;
        std::array<std::uint8_t, kStencilSize> slot{};
        std::array<double, kStencilSize> of{};
    };

    static std::size_t missing_of(const Stencil& s) {
        const auto has = [&](std::size_t i) -> std::size_t { return s.at[i] != kNone; };
        if (s.configuration == Configuration::seed) return has(0) + has(1) + has(2);
        return has(3) + 2 * has(4) + 4 * has(5) + 8 * has(9);
    }

    void find(const Stencil& stencil, Factors& factors) const {
        const auto c = static_cast<std::size_t>(stencil.configuration);
        const std::size_t set = weight_set_of(stencil);
        std::array<std::int32_t, kStencilSize> total{};
        for (std::size_t k = 0; k <= kFeatureCount[set]; ++k) {
            const Sum& sum = kSums[c][k];
            if (detail::names_missing(sum, stencil)) continue;
            const std::int32_t weight = k == 0 ? 4096 : weights_[set][k - 1];
            for (std::size_t i = 0; i < kStencilSize; ++i) total[i] += weight * sum[i];
        }
        factors.known = true;
        for (std::size_t i = 0; i < kStencilSize; ++i)
            if (total[i] != 0) {
                factors.slot[factors.count] = static_cast<std::uint8_t>(i);
                factors.of[factors.count++] = total[i];
            }
    }

    Point3 guess_by_features(const Stencil& stencil, const std::vector<Point3>& values) const {
        const Features f = detail::features_of_shape(stencil, values, mirrored_);
        const std::size_t set = weight_set_of(stencil);
        Point3 sum{};
        for (std::size_t i = 0; i < kFeatureCount[set]; ++i)
            sum = detail::plus(sum, detail::times(f.feature[i], weights_[set][i]));
        return {f.base[0] + sum[0] / 4096, f.base[1] + sum[1] / 4096, f.base[2] + sum[2] / 4096};
    }

    Weights weights_;
    bool mirrored_, leaders_move_;
    std::array<std::array<Factors, kMissing>, kWeightSets> known_;
};

}  // namespace ravel
