// Parts that repeat. Where the walk has gone since its last seed exactly as it went after an
// earlier seed, a vertex follows the one at the same place of that course, its leader: its stencil
// is the leader's, so many vertices later. The leader is not always the last: left and right leaves
// take turns, and so do the arms of a lamp. What the leader's guess missed is carried over, turned
// as the stencil has turned; so parts may be moved, turned and stretched.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/point3.h"
#include "mesh/stencil.h"

namespace ravel {

// Is there a vertex so much earlier for each of the stencil's?
inline bool can_shift(const Stencil& stencil, Id by) {
    bool can = true;
    for (const Id v : stencil.at) can = can && (v == kNone || v >= by);
    return can;
}

// The stencil `by` vertices earlier.
inline Stencil shifted(const Stencil& stencil, Id by) {
    Stencil out = stencil;
    for (Id& v : out.at)
        if (v != kNone) v -= by;
    return out;
}

inline constexpr int kMostLag = 16;

// The courses of all seeds so far, as hashes, and the vertices that had each, last first. The
// `lag`-th of these leads.
class Courses {
  public:
    Courses(std::size_t vertices, int lag)
        : lag_(lag),
          last_(std::bit_ceil(std::clamp(vertices, std::size_t{16}, std::size_t{1} << 24)), kNone) {
        hash_.reserve(vertices);
        before_.reserve(vertices);
    }

    // The leader of vertex v, or none. Once per vertex that is coded. `prior`: what the vertex
    // before was a copy of, or none; the next one is preferred.
    Id next(const Stencil& stencil, Id v, Id prior) {
        const bool seed = stencil.configuration == Configuration::seed;
        if (seed && !in_seed_) course_ = 1, begin_ = v;
        in_seed_ = seed;
        course_ = course_ * 0x9E3779B97F4A7C15u + static_cast<std::uint64_t>(stencil.configuration);
        // Vertices of before the seed are no part of the course. The same as a product and a sum
        // for each in turn, but none waits for the one before.
        std::uint64_t ways = 0;
        for (std::size_t i = 0; i < kStencilSize; ++i) {
            const Id p = stencil.at[i];
            const bool known = p != kNone && p >= begin_;
            ways += (known ? v - p : 0) * kPowers[kStencilSize - 1 - i];
        }
        course_ = course_ * kPowers[kStencilSize] + ways;
        course_ ^= course_ >> 29;
        fresh_ = true;
        Id leader = last_[slot()];
        for (int i = 1; i < lag_ && before(leader) != kNone; ++i) leader = before(leader);
        if (prior != kNone && prior + 1 < v && hash_[prior + 1] == course_) leader = prior + 1;
        if (leader == kNone || hash_[leader] != course_) return kNone;
        return can_shift(stencil, v - leader) ? leader : kNone;
    }
    // The vertex in the slot before `leader`, if both have the course at hand; or none.
    Id before(Id leader) const {
        if (leader == kNone || hash_[leader] != course_) return kNone;
        const Id other = before_[leader];
        return other != kNone && hash_[other] == course_ ? other : kNone;
    }
    void insert(Id v) {
        hash_.push_back(fresh_ ? course_ : 0);
        before_.push_back(fresh_ ? last_[slot()] : kNone);
        if (fresh_) last_[slot()] = v;
        fresh_ = false;
    }

  private:
    static constexpr auto kPowers = [] {
        std::array<std::uint64_t, kStencilSize + 1> powers{1};
        for (std::size_t i = 0; i < kStencilSize; ++i)
            powers[i + 1] = powers[i] * 0xC2B2AE3D27D4EB4Fu;
        return powers;
    }();

    std::size_t slot() const {
        return static_cast<std::size_t>(course_ >> 32) & (last_.size() - 1);
    }

    int lag_;
    std::vector<Id> last_, before_;  // per slot; per vertex, that was last in its slot before
    std::vector<std::uint64_t> hash_;
    std::uint64_t course_ = 1;
    Id begin_ = 0;
    bool in_seed_ = false, fresh_ = false;
};

// guess + `missed`, turned and stretched from the frame of the stencil `from` to that of `to`.
inline Point3 carried(const std::vector<Point3>& values, const Stencil& to, const Stencil& from,
                      const Point3& missed, const Point3& guess) {
    Point3 out{guess[0] + missed[0], guess[1] + missed[1], guess[2] + missed[2]};
    if (to.at[0] == kNone || to.at[1] == kNone || to.at[2] == kNone ||
        to.configuration == Configuration::seed)
        return out;
    const auto edges = [&](const Stencil& s, Point3& a, Point3& b) {
        a = minus(values[s.at[1]], values[s.at[0]]);
        b = minus(values[s.at[2]], values[s.at[0]]);
    };
    Point3 a, b, c, d;
    edges(from, a, b);
    edges(to, c, d);
    if (a == c && b == d) return out;
    const Point3 n = cross(a, b), m = cross(c, d);
    const double area = dot(n, n), other = dot(m, m);
    if (!(area > 0) || !(other > 0)) return out;
    const double x = dot(cross(missed, b), n) / area, y = dot(cross(a, missed), n) / area;
    const double z = dot(missed, n) / area * std::sqrt(std::sqrt(area / other));
    Point3 turned;
    for (std::size_t k = 0; k < 3; ++k) {
        turned[k] = guess[k] + ((x * c[k] + y * d[k]) + z * m[k]);
        if (!(std::abs(turned[k]) <= 0x1p60)) return out;
    }
    return turned;
}

}  // namespace ravel
