// Least squares by the normal equations, at most ten unknowns; four rounds of reweighting by 1 /
// |error| bring it near least absolute error, which is nearer to what residuals cost. O(vertices).
#include "encode/fit.h"

#include <algorithm>
#include <cmath>

#include "predict/border_plane.h"

namespace ravel {
namespace {

using Solution = std::array<double, kFeatures>;

struct Sample {
    std::array<double, kFeatures> x;
    double y;  // wanted - base
};

// Solves A w = b for symmetric positive A (n by n) by elimination; A is made safe by a small ridge.
Solution solve(std::array<std::array<double, kFeatures>, kFeatures> a, Solution b, std::size_t n) {
    double trace = 0;
    for (std::size_t i = 0; i < n; ++i) trace += a[i][i];
    for (std::size_t i = 0; i < n; ++i) a[i][i] += 1e-6 * a[i][i] + 1e-9 * trace + 1e-30;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t r = i + 1; r < n; ++r) {
            const double f = a[r][i] / a[i][i];
            for (std::size_t c = i; c < n; ++c) a[r][c] -= f * a[i][c];
            b[r] -= f * b[i];
        }
    Solution w{};
    for (std::size_t i = n; i-- > 0;) {
        double sum = b[i];
        for (std::size_t c = i + 1; c < n; ++c) sum -= a[i][c] * w[c];
        w[i] = sum / a[i][i];
    }
    return w;
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

}  // namespace

Weights fit_weights(const std::vector<Stencil>& stencils, const std::vector<Point3>& values,
                    const std::vector<bool>& skip, bool mirrored, bool along) {
    constexpr std::size_t kVertices = 2048;  // of a configuration that are looked at, or a share
    Weights weights = kDefaultWeights;
    std::array<std::size_t, kFeatureCount.size()> total{}, seen{};
    for (const Stencil& s : stencils)
        if (s.configuration < Configuration::led)
            ++total[static_cast<std::size_t>(s.configuration)];
    total[static_cast<std::size_t>(Configuration::border)] =
        total[static_cast<std::size_t>(Configuration::tet)];
    std::array<std::vector<Sample>, kFeatureCount.size()> samples;
    for (std::size_t v = 0; v < stencils.size(); ++v) {
        const Stencil stencil = along ? stencil_along(stencils[v], values, values[v]) : stencils[v];
        if (stencil.configuration == Configuration::seed ||
            stencil.configuration >= Configuration::led || (!skip.empty() && skip[v]))
            continue;
        const auto c = static_cast<std::size_t>(stencil.configuration);
        const std::size_t stride = std::min<std::size_t>(total[c] / kVertices, 31) + 1;
        if (seen[c]++ % stride != 0) continue;
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
    for (std::size_t c = 0; c < samples.size(); ++c) {
        const std::size_t n = kFeatureCount[c];
        if (samples[c].size() < 24 * n) continue;
        Solution w{}, preset{};
        for (std::size_t i = 0; i < n; ++i) preset[i] = kDefaultWeights[c][i] / 4096.0;
        w = preset;
        std::vector<double> sizes;
        for (const Sample& s : samples[c]) sizes.push_back(std::abs(error_of(s, preset, n)));
        // What counts as no error: a fraction of a unit, or of a large error.
        const auto large = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
        std::nth_element(sizes.begin(), large, sizes.end());
        const double unit = std::max(*large / 4096, 0.25);
        for (int round = 0; round < 5; ++round) {
            std::array<std::array<double, kFeatures>, kFeatures> a{};
            Solution b{};
            for (const Sample& s : samples[c]) {
                const double weight = 1 / (std::abs(error_of(s, w, n)) + unit);
                for (std::size_t i = 0; i < n; ++i) {
                    for (std::size_t j = i; j < n; ++j) a[i][j] += weight * s.x[i] * s.x[j];
                    b[i] += weight * s.x[i] * s.y;
                }
            }
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < i; ++j) a[i][j] = a[j][i];
            w = solve(a, b, n);
        }
        Solution rounded{};
        for (std::size_t i = 0; i < n; ++i) {
            const double scaled =
                std::clamp(std::nearbyint(w[i] * 4096 / 4) * 4, -32000.0, 32000.0);
            rounded[i] = std::isfinite(scaled) ? scaled / 4096 : preset[i];
        }
        const double stored_bits = 16.0 * static_cast<double>(n) + 8;
        if (cost_of(samples[c], rounded, n, unit) + stored_bits <
            cost_of(samples[c], preset, n, unit))
            for (std::size_t i = 0; i < n; ++i)
                weights[c][i] = static_cast<std::int16_t>(std::lround(rounded[i] * 4096));
    }
    return weights;
}

}  // namespace ravel
