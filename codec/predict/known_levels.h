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
#include "predict/level_intervals.h"

namespace ravel {

inline constexpr int kMostLevelBits = 54;

// Levels in intervals of length 2^bits, hashed; intervals of the same hash share a list, so the
// hash is part of the format. A list has eight levels, those that were had last. Constant time,
// with few branches.
class KnownLevels {
  public:
    KnownLevels(int bits, std::size_t vertices)
        : intervals_(bits),
          mask_(std::bit_ceil(std::clamp(vertices / 16, std::size_t{16}, std::size_t{1} << 20)) -
                1),
          lists_(3 * (mask_ + 1)) {}

    struct Near {
        Id vertex = kNone;        // the first that had it
        std::uint32_t count = 0;  // vertices that had it
        double distance = 0;
        std::size_t list = 0, place = 0;
    };
    // The level nearest to x, less than half an interval away.
    Near nearest(std::size_t axis, double x) const {
        return intervals_.nearest<Near>(
            x, [&](std::int64_t i, Near& best) { look(slot(axis, i), x, best); });
    }
    void insert(std::size_t axis, double x, Id vertex) {
        const std::size_t slot_of_x = slot(axis, intervals_.of(x));
        List& list = lists_[slot_of_x];
        // Whether it is in the list, and which place is the oldest, is anyone's guess, so nothing
        // branches on either.
        unsigned same = 0, oldest = 0;
        std::uint32_t least = list.last[0];
        for (std::size_t i = 1; i < kPlaces; ++i) least = std::min(least, list.last[i]);
        for (std::size_t i = 0; i < kPlaces; ++i) {
            same |= (list.level[i] == x ? 1u : 0u) << i;
            oldest |= (list.last[i] == least ? 1u : 0u) << i;
        }
        const auto place = static_cast<std::size_t>(std::countr_zero(same != 0 ? same : oldest));
        list.vertex[place] = same != 0 ? list.vertex[place] : vertex;
        list.count[place] = same != 0 ? list.count[place] : 0;
        list.level[place] = x;
        count(slot_of_x, place);
    }
    // One more vertex has a level.
    void count(std::size_t slot, std::size_t place) {
        List& list = lists_[slot];
        ++list.count[place];
        list.last[place] = ++list.turn;
    }

  private:
    static constexpr std::size_t kPlaces = 8;
    struct alignas(kListAlignment) List {
        std::array<double, kPlaces> level = no_levels<kPlaces>();
        std::array<Id, kPlaces> vertex{};
        std::array<std::uint32_t, kPlaces> count{}, last{};  // last: the turn when it was had
        std::uint32_t turn = 0;
    };

    void look(std::size_t slot, double x, Near& best) const {
        const List& list = lists_[slot];
        std::array<double, kPlaces> d;
        for (std::size_t i = 0; i < kPlaces; ++i) d[i] = std::abs(list.level[i] - x);
        double least = d[0];
        for (std::size_t i = 1; i < kPlaces; ++i) least = d[i] < least ? d[i] : least;
        if (!(least < best.distance)) return;
        unsigned places = 0;  // a bit for each that is as near
        for (std::size_t i = 0; i < kPlaces; ++i) places |= (d[i] == least ? 1u : 0u) << i;
        const auto place = static_cast<std::size_t>(std::countr_zero(places));
        best = {list.vertex[place], list.count[place], least, slot, place};
    }
    std::size_t slot(std::size_t axis, std::int64_t interval) const {
        const std::uint64_t hash = static_cast<std::uint64_t>(interval) * 0x9E3779B97F4A7C15u;
        return 3 * (static_cast<std::size_t>(hash >> 32) & mask_) + axis;
    }

    LevelIntervals intervals_;
    std::size_t mask_;
    std::vector<List> lists_;
};

}  // namespace ravel
