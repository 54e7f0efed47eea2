// The coordinates that vertices have so far, axis by axis: in meshes that people and programs draw,
// many vertices share the few levels that an axis has, whether they are neighbours or not.
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

inline constexpr int kMostLevelBits = 52;

// Levels in intervals of length 2^bits, hashed. A look takes two intervals, at most 12 levels each,
// latest first; what another interval with the same hash holds is among them, so the hash is part
// of the format. Constant time. There are no more levels than vertices.
class KnownLevels {
  public:
    KnownLevels(int bits, std::size_t vertices)
        : scale_(std::ldexp(1.0, -bits)),
          half_(std::ldexp(0.5, bits)),
          mask_(std::bit_ceil(std::clamp(vertices, std::size_t{16}, std::size_t{1} << 24)) - 1),
          heads_(3 * (mask_ + 1), kNone),
          most_(vertices) {
        levels_.reserve(vertices);
    }

    struct Near {
        Id vertex = kNone;        // the first that had it
        std::uint32_t count = 0;  // vertices that had it
        double distance = 0;
    };
    // The level nearest to x, less than half an interval away.
    Near nearest(std::size_t axis, double x) const {
        Near best;
        best.distance = half_;
        const std::int64_t low = whole_below(x * scale_ - 0.5);
        for (const std::int64_t interval : {low, low + 1})
            find(heads_[slot(axis, interval)], [&](const Level& level) {
                const double d = std::abs(level.x - x);
                if (d < best.distance) best = {level.vertex, level.count, d};
                return false;
            });
        return best;
    }
    void insert(std::size_t axis, double x, Id vertex) {
        Id& head = heads_[slot(axis, whole_below(x * scale_))];
        const Id known = find(head, [&](const Level& level) { return level.x == x; });
        if (known != kNone) {
            ++levels_[known].count;
            return;
        }
        if (levels_.size() == most_) return;
        levels_.push_back({x, vertex, 1, head});
        head = static_cast<Id>(levels_.size() - 1);
    }

  private:
    struct Level {
        double x = 0;
        Id vertex = 0;
        std::uint32_t count = 0;
        Id next = kNone;
    };

    // The place of the first of a list that `is` says yes to, or kNone.
    template <class Is>
    Id find(Id level, const Is& is) const {
        for (int looks = 0; level != kNone && looks < 12; ++looks, level = levels_[level].next)
            if (is(levels_[level])) return level;
        return kNone;
    }
    std::size_t slot(std::size_t axis, std::int64_t interval) const {
        const std::uint64_t hash = static_cast<std::uint64_t>(interval) * 0x9E3779B97F4A7C15u;
        return 3 * (static_cast<std::size_t>(hash >> 32) & mask_) + axis;
    }

    double scale_, half_;
    std::size_t mask_;
    std::vector<Id> heads_;
    std::vector<Level> levels_;
    std::size_t most_;
};

}  // namespace ravel
