// Parts that repeat. Where the walk has gone since its last seed exactly as it went after an
// earlier seed, a vertex may follow the one at the same place of that course, its leader: its
// stencil is the leader's, so many vertices later. Which of several such parts leads is told once
// (see lead_codes.h). What the leader's guess missed is carried over, turned as the stencil has
// turned; so parts may be moved, turned and stretched.
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
    Id least = kNone;  // which is above all others
    for (const Id v : stencil.at) least = std::min(least, v);
    return least >= by;
}

// The stencil `by` vertices earlier.
inline Stencil shifted(const Stencil& stencil, Id by) {
    Stencil out = stencil;
    for (Id& v : out.at)
        if (v != kNone) v -= by;
    return out;
}

// The courses of all seeds so far, as hashes; the vertices that had each, last first; and how much
// earlier the part is that leads the one at hand.
class Courses {
  public:
    explicit Courses(std::size_t vertices)
        : last_(std::bit_ceil(std::clamp(vertices, kFewest, std::size_t{1} << 24)), kNone) {
        hash_.reserve(vertices);
        before_.reserve(vertices);
    }

    // The course of vertex v. Once per vertex that is coded, or known to both sides.
    void enter(const Stencil& stencil, Id v) {
        const bool seed = stencil.configuration == Configuration::seed;
        if (seed && !in_seed_) course_ = 1, begin_ = v, is_led_ = false;
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
    }
    bool in_seed() const { return in_seed_; }
    std::uint64_t course() const { return course_; }

    // May u lead v, the vertex at hand? None may not.
    bool can_lead(Id u, const Stencil& stencil, Id v) const {
        return u < v && hash_[u] == course_ && can_shift(stencil, v - u);
    }
    // The vertices that had the course at hand, last first; of those that share a slot none may be
    // between them.
    Id last() const { return with_course(last_[slot()]); }
    Id before(Id u) const { return with_course(before_[u]); }

    // The vertex of the part that led so far, if it may lead on; or none.
    Id going_on(const Stencil& stencil, Id v) const {
        const Id u = by_ != 0 && by_ <= v ? v - by_ : kNone;
        return can_lead(u, stencil, v) ? u : kNone;
    }
    // The same, if the part at hand has been told its leader.
    Id led_by(const Stencil& stencil, Id v) const { return is_led_ ? going_on(stencil, v) : kNone; }
    void lead(Id u, Id v) {
        by_ = v - u;
        is_led_ = true;
    }

    // After each vertex.
    void insert(Id v) {
        hash_.push_back(fresh_ ? course_ : 0);
        before_.push_back(fresh_ ? last_[slot()] : kNone);
        if (fresh_) last_[slot()] = v;
        fresh_ = false;
    }

  private:
    static constexpr std::size_t kFewest = 256;  // slots
    static constexpr auto kPowers = [] {
        std::array<std::uint64_t, kStencilSize + 1> powers{1};
        for (std::size_t i = 0; i < kStencilSize; ++i)
            powers[i + 1] = powers[i] * 0xC2B2AE3D27D4EB4Fu;
        return powers;
    }();

    std::size_t slot() const {
        return static_cast<std::size_t>(course_ >> 32) & (last_.size() - 1);
    }
    Id with_course(Id u) const { return u != kNone && hash_[u] == course_ ? u : kNone; }

    std::vector<Id> last_, before_;  // per slot; per vertex, that was last in its slot before
    std::vector<std::uint64_t> hash_;
    std::uint64_t course_ = 1;
    Id begin_ = 0, by_ = 0;
    bool in_seed_ = false, fresh_ = false, is_led_ = false;
};

// Digits of what is missed by on one axis.
inline std::uint32_t digits_of(double missed) {
    return width_of(std::min(0x1p60, std::abs(missed) + 0.5));
}

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
