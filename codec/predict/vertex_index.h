// Vertices by place, for looking up what is near.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/complex.h"
#include "mesh/point3.h"

namespace ravel {

// Two grids of cubes, hashed: the sides of the large ones are 2^cube_bits long, those of the small
// ones an eighth of that. Where vertices are dense the small cubes tell them apart, where they are
// far from each other the large ones reach them. Vertices of other cubes with the same hash are
// looked at, too, so the hash is part of the format. Constant time.
class VertexIndex {
  public:
    VertexIndex(int cube_bits, std::size_t vertices)
        : side_(std::ldexp(1.0, cube_bits)), scale_(std::ldexp(1.0, kFiner + 1 - cube_bits)) {
        const std::size_t slots =
            std::bit_ceil(std::clamp(vertices, std::size_t{16}, std::size_t{1} << 24));
        newest_[kSmall].assign(slots, kNone);
        newest_[kLarge].assign(slots / 4, kNone);
    }

    double side() const { return side_; }
    void reserve(std::size_t vertices) { before_.reserve(vertices); }

    void insert(const Point3& p) {
        const Halves halves = halves_of(p);
        const auto v = static_cast<Id>(before_.size());
        before_.emplace_back();
        for (const Grid grid : {kSmall, kLarge}) {
            std::uint64_t hash = 0;
            for (std::size_t k = 0; k < 3; ++k)
                hash ^= static_cast<std::uint64_t>(halves[k] >> (kFiner * grid + 1)) * kFactor[k];
            Id& newest = newest_[grid][slot(grid, hash)];
            before_[v][grid] = newest;
            newest = v;
        }
    }
    // A vertex that is not to be found.
    void skip() { before_.emplace_back(); }

    struct Near {
        Id vertex = kNone;
        double distance = 0;  // the sum over the axes
    };
    // The nearest vertex less than half a small side away, or else half a large one, of those that
    // are looked at: the 24 newest of each of the 8 cubes about p. Where the large cubes are empty
    // the small ones are not looked at.
    Near nearest(const Point3& p, const std::vector<Point3>& values) const {
        const Halves halves = halves_of(p);
        const Cubes large = around(kLarge, halves);
        if (large.count == 0) return {};
        const Cubes small = around(kSmall, halves);
        const Near near = nearest_in(kSmall, small, side_ / (2 << kFiner), p, values);
        return near.vertex != kNone ? near : nearest_in(kLarge, large, side_ / 2, p, values);
    }

  private:
    enum Grid : std::size_t { kSmall, kLarge };
    static constexpr int kFiner = 3;  // bits
    static constexpr int kLooks = 24;
    static constexpr std::array<std::uint64_t, 3> kFactor{0x9E3779B97F4A7C15u, 0xC2B2AE3D27D4EB4Fu,
                                                          0x165667B19E3779F9u};

    // Per axis, in halves of small sides.
    using Halves = std::array<std::int64_t, 3>;
    Halves halves_of(const Point3& p) const {
        Halves halves;
        for (std::size_t k = 0; k < 3; ++k)
            halves[k] = whole_below(std::clamp(p[k] * scale_, -0x1p60, 0x1p60));
        return halves;
    }

    struct Cubes {
        std::array<Id, 8> newest;  // vertices of those that have any
        std::size_t count = 0;
    };
    // The cubes within half a side of p: two on each axis. None of them waits for what is found in
    // another.
    Cubes around(Grid grid, const Halves& halves) const {
        std::array<std::array<std::uint64_t, 2>, 3> parts;  // of the hash
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t half = std::int64_t{1} << kFiner * grid;
            const auto low = static_cast<std::uint64_t>((halves[k] - half) >> (kFiner * grid + 1));
            parts[k] = {low * kFactor[k], (low + 1) * kFactor[k]};
        }
        Cubes cubes;
        for (std::size_t i = 0; i < 8; ++i) {
            const std::uint64_t hash = parts[0][i & 1] ^ parts[1][i >> 1 & 1] ^ parts[2][i >> 2];
            const Id v = newest_[grid][slot(grid, hash)];
            cubes.newest[cubes.count] = v;
            cubes.count += v != kNone;
        }
        return cubes;
    }
    Near nearest_in(Grid grid, const Cubes& cubes, double reach, const Point3& p,
                    const std::vector<Point3>& values) const {
        Near best;
        best.distance = reach;
        for (std::size_t i = 0; i < cubes.count; ++i) {
            Id v = cubes.newest[i];
            for (int looks = 0; v != kNone && looks < kLooks; ++looks, v = before_[v][grid]) {
                const Point3& q = values[v];
                const double d =
                    std::abs(q[0] - p[0]) + std::abs(q[1] - p[1]) + std::abs(q[2] - p[2]);
                if (d < best.distance) best = {v, d};
            }
        }
        return best;
    }
    std::size_t slot(Grid grid, std::uint64_t hash) const {
        return static_cast<std::size_t>(hash >> 32) & (newest_[grid].size() - 1);
    }

    double side_, scale_;
    std::array<std::vector<Id>, 2> newest_;  // per grid and slot
    std::vector<std::array<Id, 2>> before_;  // per vertex and grid: what was newest there before
};

}  // namespace ravel
