#include "encode/lag.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "predict/follows.h"

namespace ravel {
namespace {

// Bits of what is missed, over the axes.
std::uint64_t size_of(const Point3& missed) {
    std::uint64_t bits = 0;
    for (const double x : missed)
        bits += static_cast<std::uint64_t>(
            std::bit_width(static_cast<std::uint64_t>(std::min(0x1p60, std::abs(x) + 0.5))));
    return bits;
}

}  // namespace

int best_lag(const WalkRecord& record, const std::vector<Point3>& places,
             const PositionFormat& format) {
    constexpr std::size_t kStretch = 256, kLooks = 8192;
    constexpr double kBetter = 0.98;  // than the last one
    const std::size_t stride = record.stencils.size() / kLooks + 1;
    Courses courses(record.stencils.size(), 1);
    Predictor predictor(format.weights, format.mirrored, format.leaders_move);
    std::array<std::uint64_t, kMostLag> bits{};
    for (std::size_t i = 0; i < record.stencils.size(); ++i) {
        const Stencil& stencil = record.stencils[i];
        const auto v = static_cast<Id>(i);
        if (record.copy_of[i] == kNone) {
            Id leader = courses.next(stencil, v, kNone);
            if (leader != kNone && i / kStretch % stride == 0) {
                const Point3 guess = predictor.guess(stencil, places);
                std::uint64_t size = 0;
                for (std::uint64_t& sum : bits) {
                    if (leader != kNone && can_shift(stencil, v - leader)) {
                        const Stencil before = shifted(stencil, v - leader);
                        const Point3 missed =
                            minus(places[leader], predictor.guess(before, places));
                        size = size_of(
                            minus(places[i], carried(places, stencil, before, missed, guess)));
                        leader = courses.before(leader);
                    }
                    sum += size;  // where there are not so many, the first one leads
                }
            }
        }
        courses.insert(v);
    }
    const auto least = std::min_element(bits.begin(), bits.end());
    return static_cast<double>(*least) < kBetter * static_cast<double>(bits[0])
               ? static_cast<int>(least - bits.begin()) + 1
               : 1;
}

}  // namespace ravel
