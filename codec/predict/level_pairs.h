// The coordinates on one axis that vertices with the same coordinate on the axis before have so
// far: in what is drawn on a plan, or swept along an axis, pairs repeat more than chance would have
// it.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/complex.h"
#include "predict/level_intervals.h"

namespace ravel {

// Levels in intervals of length 2^bits, axis by axis, hashed together with the other coordinate;
// whatever has the same hash shares a list, so the hash is part of the format. A list has the five
// levels that were had last, the last one first. Constant time.
class LevelPairs {
  public:
    LevelPairs(int bits, std::size_t vertices)
        : intervals_(bits),
          mask_(std::bit_ceil(std::clamp(vertices / 4, std::size_t{16}, std::size_t{1} << 21)) - 1),
          lists_(2 * (mask_ + 1)) {}

    struct Near {
        Id vertex = kNone;  // the first that had it
        std::uint32_t place = 0;
        double distance = 0;
    };
    // The level nearest to x on `axis`, beside `other` on the axis before, less than half an
    // interval away.
    Near nearest(std::size_t axis, double other, double x) const {
        const std::uint64_t key = key_of(other);
        return intervals_.nearest<Near>(
            x, [&](std::int64_t i, Near& best) { look(slot(axis, key, i), x, best); });
    }
    void insert(std::size_t axis, double other, double x, Id vertex) {
        List& list = lists_[slot(axis, key_of(other), intervals_.of(x))];
        // Where it is in the list, if at all, is anyone's guess, so nothing branches on it.
        std::size_t place = kPlaces - 1;
        for (std::size_t i = kPlaces; i-- > 0;) place = list.level[i] == x ? i : place;
        vertex = list.level[place] == x ? list.vertex[place] : vertex;
        for (std::size_t i = kPlaces - 1; i > 0; --i) {
            const std::size_t from = i <= place ? i - 1 : i;
            list.level[i] = list.level[from];
            list.vertex[i] = list.vertex[from];
        }
        list.level[0] = x;
        list.vertex[0] = vertex;
    }

  private:
    static constexpr std::size_t kPlaces = 5;
    struct alignas(kListAlignment) List {
        std::array<double, kPlaces> level = no_levels<kPlaces>();
        std::array<Id, kPlaces> vertex{};
    };

    void look(std::size_t slot, double x, Near& best) const {
        const List& list = lists_[slot];
        std::array<double, kPlaces> d;
        for (std::size_t i = 0; i < kPlaces; ++i) d[i] = std::abs(list.level[i] - x);
        std::size_t place = 0;
        for (std::size_t i = 1; i < kPlaces; ++i) place = d[i] < d[place] ? i : place;
        if (d[place] < best.distance)
            best = {list.vertex[place], static_cast<std::uint32_t>(place), d[place]};
    }
    // Zeros of either sign are one.
    static std::uint64_t key_of(double other) {
        const std::uint64_t key = std::bit_cast<std::uint64_t>(other + 0.0) * 0xC2B2AE3D27D4EB4Fu;
        return key ^ key >> 29;
    }
    std::size_t slot(std::size_t axis, std::uint64_t key, std::int64_t interval) const {
        const std::uint64_t hash =
            (static_cast<std::uint64_t>(interval) ^ key) * 0x9E3779B97F4A7C15u;
        return 2 * (static_cast<std::size_t>(hash >> 32) & mask_) + axis - 1;
    }

    LevelIntervals intervals_;
    std::size_t mask_;
    std::vector<List> lists_;
};

}  // namespace ravel
