// Least squares by the normal equations, at most ten unknowns; four rounds of reweighting by 1 /
// |error| bring it near least absolute error, which is nearer to what residuals cost. O(vertices).
#include "encode/fit.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "base/bytes.h"
#include "encode/linear_system.h"
#include "predict/border_plane.h"

namespace ravel {
namespace {

using Solution = Row<kFeatures>;

struct Sample {
    std::array<double, kFeatures> x;
    double y;  // wanted - base
};

bool is_finite(const Sample& s) {
    return std::isfinite(std::accumulate(s.x.begin(), s.x.end(), s.y));
}

double error_of(const Sample& s, const Solution& w, std::size_t n) {
    double e = s.y;
    for (std::size_t i = 0; i < n; ++i) e -= w[i] * s.x[i];
    return e;
}

// log2(x) for x >= 1, straight between powers of two: the same on every machine, which std::log2 is
// not.
double near_log2(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return exponent - 2 + 2 * mantissa;
}

// About what the residuals cost, in bits. Only whole steps cost anything.
double cost_of(const std::vector<Sample>& samples, const Solution& w, std::size_t n, double unit) {
    double bits = 0;
    for (const Sample& s : samples) {
        double e = std::abs(error_of(s, w, n));
        bits += near_log2(1 + std::nearbyint(e) / unit);
    }
    return bits;
}

// Least absolute errors, or nearly; `start` to begin with.
Solution best_for(const std::vector<Sample>& samples, const Solution& start, std::size_t n,
                  double unit) {
    Solution w = start;
    for (int round = 0; round < 5; ++round) {
        Rows<kFeatures> a{};
        Solution b{};
        for (const Sample& s : samples) {
            const double weight = 1 / (std::abs(error_of(s, w, n)) + unit);
            for (std::size_t i = 0; i < n; ++i) {
                for (std::size_t j = i; j < n; ++j) a[i][j] += weight * s.x[i] * s.x[j];
                b[i] += weight * s.x[i] * s.y;
            }
        }
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < i; ++j) a[i][j] = a[j][i];
        double trace = 0;
        for (std::size_t i = 0; i < n; ++i) trace += a[i][i];
        // A small ridge makes it safe.
        for (std::size_t i = 0; i < n; ++i) a[i][i] += 1e-6 * a[i][i] + 1e-9 * trace + 1e-30;
        w = solve(a, b, n);
    }
    return w;
}

using StoredWeights = std::array<std::int16_t, kFeatures>;

// In steps of 2^grain.
StoredWeights stored(const Solution& w, std::size_t n, int grain, const StoredWeights& otherwise) {
    StoredWeights all{};
    for (std::size_t i = 0; i < n; ++i) {
        const double steps = std::nearbyint(std::ldexp(w[i] * 4096, -grain));
        const double x = std::ldexp(steps, grain);
        all[i] = std::isfinite(x) ? static_cast<std::int16_t>(std::clamp(x, -32000.0, 32000.0))
                                  : otherwise[i];
    }
    return all;
}
Solution solution_of(const StoredWeights& weights) {
    Solution w{};
    for (std::size_t i = 0; i < kFeatures; ++i) w[i] = weights[i] / 4096.0;
    return w;
}

// What it takes to tell them, in bits.
double bits_of(const StoredWeights& weights, std::size_t n) {
    const int grain = grain_of(weights);
    std::size_t bytes = 1;
    for (std::size_t i = 0; i < n; ++i) bytes += varint_size(zigzag(weights[i] >> grain));
    return 8 * static_cast<double>(bytes);
}

// The default weights of a set, none, or fitted ones, whichever cost least with what storing them
// takes. The samples stand for `share` times as many.
void choose(const std::vector<Sample>& samples, std::size_t n, double share,
            StoredWeights& weights) {
    const StoredWeights preset = weights;
    const Solution start = solution_of(preset);
    std::vector<double> sizes;
    for (const Sample& s : samples) sizes.push_back(std::abs(error_of(s, start, n)));
    // What counts as no error: a fraction of a unit, or of a large error.
    const auto large = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
    std::nth_element(sizes.begin(), large, sizes.end());
    const double unit = std::max(*large / 4096, 0.25);
    double least = share * cost_of(samples, start, n, unit);
    const auto offer = [&](const StoredWeights& w) {
        const double bits = share * cost_of(samples, solution_of(w), n, unit) + bits_of(w, n);
        if (!(bits < least)) return;
        least = bits;
        weights = w;
    };
    if (preset != StoredWeights{}) offer({});
    if (samples.size() < 24 * n) return;
    const Solution best = best_for(samples, start, n, unit);
    for (const int grain : {2, 4, 6}) offer(stored(best, n, grain, preset));
}

// Of a vertex that goes on with a border: how far off it is within the plane, on the axes that are
// coded first, and, if that is asked for, how high above it, on the last.
void add_border(const Stencil& stencil, const std::vector<Point3>& values, const Point3& value,
                const Features& f, std::vector<Sample>& within, std::vector<Sample>* heights) {
    const BorderPlane plane(stencil, values);
    const auto [first, second, last] = plane.axes();
    const Point3 way = minus(value, f.base);
    const Point3& up = f.feature[kBorderHeight];
    const double height = dot(way, up) / dot(up, up);
    for (const std::size_t axis : {first, second}) {
        Sample sample{{}, way[axis] - height * up[axis]};
        for (std::size_t i = 0; i < kBorderHeight; ++i) sample.x[i] = f.feature[i][axis];
        if (is_finite(sample)) within.push_back(sample);
    }
    const double steep = dot(up, up) / up[last];
    const Sample sample{{steep}, height * steep};
    if (heights != nullptr && is_finite(sample)) heights->push_back(sample);
}

}  // namespace

int grain_of(const std::array<std::int16_t, kFeatures>& weights) {
    unsigned any = 0;
    for (const std::int16_t w : weights) any |= static_cast<std::uint16_t>(w);
    return any == 0 ? 0 : std::countr_zero(any);
}

Weights fit_weights(const std::vector<Stencil>& stencils, const std::vector<Point3>& values,
                    const std::vector<bool>& skip, bool mirrored, const RoundFaces* along) {
    constexpr std::size_t kVertices = 2048;  // of a set that are looked at, or a share
    Weights weights = kDefaultWeights;
    std::array<std::size_t, kWeightSets> total{}, seen{};
    for (const Stencil& s : stencils)
        if (s.configuration < Configuration::led) ++total[weight_set_of(s)];
    const auto stride_of = [&](const Stencil& s) {
        // How many go on with a border is not known before it is looked at.
        Stencil asked = s;
        if (s.configuration == Configuration::border) asked.configuration = Configuration::tet;
        return std::min<std::size_t>(total[weight_set_of(asked)] / kVertices, 31) + 1;
    };
    std::array<std::vector<Sample>, kWeightSets> samples;
    std::array<std::size_t, kWeightSets> stride{};
    std::vector<Sample> heights;
    for (std::size_t v = 0; v < stencils.size(); ++v) {
        const Stencil stencil =
            along != nullptr ? stencil_along(stencils[v], values, values[v], *along) : stencils[v];
        if (stencil.configuration == Configuration::seed ||
            stencil.configuration >= Configuration::led || (!skip.empty() && skip[v]))
            continue;
        const std::size_t c = weight_set_of(stencil);
        stride[c] = stride_of(stencil);
        if (seen[c]++ % stride[c] != 0) continue;
        const Features f = features_of(stencil, values, mirrored);
        if (stencil.configuration == Configuration::border) {
            add_border(stencil, values, values[v], f, samples[c],
                       along->of(stencil) == kNone ? &heights : nullptr);
            continue;
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Sample sample{{}, values[v][axis] - f.base[axis]};
            for (std::size_t i = 0; i < kFeatures; ++i) sample.x[i] = f.feature[i][axis];
            if (is_finite(sample)) samples[c].push_back(sample);
        }
    }
    for (std::size_t c = 0; c < samples.size(); ++c) {
        if (samples[c].empty()) continue;
        const auto share = static_cast<double>(stride[c]);
        if (c != kBorderSet) {
            choose(samples[c], kFeatureCount[c], share, weights[c]);
            continue;
        }
        choose(samples[c], kBorderHeight, share, weights[c]);
        StoredWeights height{};
        if (!heights.empty()) choose(heights, 1, share, height);
        weights[c][kBorderHeight] = height[0];
    }
    return weights;
}

}  // namespace ravel
