#include "encode/shape_step.h"

#include <algorithm>
#include <compare>

#include "walk/gate_shapes.h"
#include "walk/tet_front.h"

namespace ravel {
namespace {

// Facets from the side of the cell that they are of, those behind which one of some points is.
// Which points depends on where they are.
std::vector<Id> some_facets(const Complex& complex, const std::vector<Point3>& places) {
    constexpr std::size_t kFacets = 16384;  // about so many
    const std::uint64_t one_in = complex.twin.size() / kFacets + 1;
    std::vector<bool> is_taken(places.size());
    for (std::size_t p = 0; p < places.size(); ++p)
        is_taken[p] = hash_of(places[p], 1, 0) % one_in == 0;
    std::vector<Id> facets;
    for (Id f = 0; f < complex.twin.size(); ++f)
        if (complex.twin[f] != kNone && is_taken[complex.point[complex.vertex[f]]])
            facets.push_back(f);
    return facets;
}

struct Seen {
    std::uint64_t shape = 0, apex = 0;  // hashes; that of the apex stands for both

    auto operator<=>(const Seen&) const = default;
};

// What leaders would save less what the flags would cost, in bits. A tet that is not told by a
// leader takes about one. Of a shape's n facets, in random order, the sum of squares of how many
// have their apex at one place, divided by n, are led right.
double gain_of(std::vector<Seen>& seen) {
    constexpr double kSaved = 0.8, kMiss = 3;
    std::sort(seen.begin(), seen.end());
    double gain = 0;
    for (std::size_t i = 0; i < seen.size();) {
        const std::size_t first = i;
        double squares = 0;
        while (i < seen.size() && seen[i].shape == seen[first].shape) {
            const std::size_t begin = i;
            while (i < seen.size() && seen[i] == seen[begin]) ++i;
            squares += static_cast<double>(i - begin) * static_cast<double>(i - begin);
        }
        const auto n = static_cast<double>(i - first);
        const double led = squares / n - 1;
        gain += kSaved * led - kMiss * std::min(led, n - 1 - led);
    }
    return gain;
}

}  // namespace

Index choose_shape_step(const Complex& complex, const std::vector<Point3>& places,
                        Index grid_side) {
    constexpr double kWorth = 200;  // bits that it must save at those looked at
    const auto place = [&](Id v) -> const Point3& { return places[complex.point[v]]; };
    const std::vector<Id> facets = some_facets(complex, places);
    double most = kWorth;
    Index best = 0;
    std::vector<Seen> seen;
    for (const Index step : {grid_side / 2, Index{16}, Index{4}, Index{1}}) {
        if (step == 0 || step > grid_side) continue;
        seen.clear();
        for (const Id f : facets) {
            const Id base = f & ~Id{3};
            const auto& triple = kOutward[f & 3];
            const GateShape gate =
                shape_of({complex.vertex[base + triple[0]], complex.vertex[base + triple[1]],
                          complex.vertex[base + triple[2]]},
                         complex.vertex[f], 1 / static_cast<double>(step), place);
            const Point3 way = minus(place(complex.vertex[complex.twin[f]]), place(gate.corner));
            seen.push_back(
                {gate.shape, hash_of(way, 1 / static_cast<double>(grid_side), gate.shape)});
        }
        const double gain = gain_of(seen);
        if (gain > most) most = gain, best = step;
    }
    return best;
}

}  // namespace ravel
