// Least squares by the normal equations, at most ten unknowns; four rounds of reweighting by 1 /
// |error| bring it near least absolute error, which is nearer to what residuals cost. O(vertices).
#include "encode/fit.h"

#include <algorithm>
#include <cmath>

#include "encode/linear_system.h"

namespace ravel {
namespace {

using Solution = Row<kFeatures>;

struct Sample {
    std::array<double, kFeatures> x;
    double y;  // wanted - base
};

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

// Least absolute errors, or nearly, in steps that weights are stored in; `start` to begin with.
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
    Solution rounded{};
    for (std::size_t i = 0; i < n; ++i) {
        const double scaled = std::clamp(std::nearbyint(w[i] * 4096 / 4) * 4, -32000.0, 32000.0);
        rounded[i] = std::isfinite(scaled) ? scaled / 4096 : start[i];
    }
    return rounded;
}

// The default weights of a set, none, or fitted ones, whichever cost least with what storing them
// takes. The samples stand for `share` times as many.
void choose(const std::vector<Sample>& samples, std::size_t n, double share,
            std::array<std::int16_t, kFeatures>& weights) {
    Solution preset{};
    for (std::size_t i = 0; i < n; ++i) preset[i] = weights[i] / 4096.0;
    std::vector<double> sizes;
    for (const Sample& s : samples) sizes.push_back(std::abs(error_of(s, preset, n)));
    // What counts as no error: a fraction of a unit, or of a large error.
    const auto large = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
    std::nth_element(sizes.begin(), large, sizes.end());
    const double unit = std::max(*large / 4096, 0.25);
    double least = share * cost_of(samples, preset, n, unit);
    const auto offer = [&](const Solution& w, double bits_each) {
        const double bits =
            share * cost_of(samples, w, n, unit) + bits_each * static_cast<double>(n) + 8;
        if (!(bits < least)) return;
        least = bits;
        for (std::size_t i = 0; i < n; ++i)
            weights[i] = static_cast<std::int16_t>(std::lround(w[i] * 4096));
    };
    if (preset != Solution{}) offer({}, 1);
    if (samples.size() >= 24 * n) offer(best_for(samples, preset, n, unit), 16);
}

}  // namespace

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
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Sample sample;
            sample.y = values[v][axis] - f.base[axis];
            double all = sample.y;
            for (std::size_t i = 0; i < kFeatures; ++i) {
                sample.x[i] = f.feature[i][axis];
                all += sample.x[i];
            }
            if (std::isfinite(all)) samples[c].push_back(sample);
        }
    }
    for (std::size_t c = 0; c < samples.size(); ++c)
        if (!samples[c].empty())
            choose(samples[c], kFeatureCount[c], static_cast<double>(stride[c]), weights[c]);
    return weights;
}

}  // namespace ravel
