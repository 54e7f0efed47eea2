// Which vertex may lead the one at hand, where several earlier parts went the same way.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <vector>

#include "predict/follows.h"

namespace ravel {

// The first vertex to which the stencil of v can be shifted.
inline Id first_to_shift_to(const Stencil& stencil, Id v) {
    return v - std::min(v, *std::min_element(stencil.at.begin(), stencil.at.end()));
}

// The likeliest leaders of a vertex that is no seed: the part that led so far goes on, if it can;
// then, of the last kLooked vertices with its course, those whose triangles have sides of lengths
// most like its own.
class LeadList {
  public:
    static constexpr std::size_t kMostAlike = 16;

    LeadList(const Courses& courses, const Stencil& stencil, Id v)
        : stencil_(stencil), v_(v), on_(courses.going_on(stencil, v)) {
        const Id first = first_to_shift_to(stencil, v);
        Id u = courses.last();
        for (std::size_t i = 0; i < kLooked && u != kNone && u >= first;
             ++i, u = courses.before(u)) {
            others_[count_] = {0, static_cast<std::uint32_t>(count_), u};
            count_ += u != on_;
        }
    }
    std::size_t size() const {
        return (goes_on() ? 1 : 0) + std::min<std::size_t>(count_, kMostAlike);
    }
    // Is the first the part that led so far?
    bool goes_on() const { return on_ != kNone; }
    // The first `count` places are asked for.
    void sort(const std::vector<Point3>& values, std::size_t count) {
        count -= goes_on() ? 1 : 0;
        if (count == 0 || count_ < 2) return;
        const Lengths mine = lengths(0, values);
        for (std::size_t i = 0; i < count_; ++i) {
            const Lengths its = lengths(v_ - others_[i].vertex, values);
            for (std::size_t k = 0; k < 3; ++k)
                others_[i].unlike = others_[i].unlike + std::abs(its[k] - mine[k]);
        }
        std::partial_sort(others_.begin(), others_.begin() + static_cast<std::ptrdiff_t>(count),
                          others_.begin() + static_cast<std::ptrdiff_t>(count_));
    }
    Id operator[](std::size_t place) const {
        return place == 0 && goes_on() ? on_ : others_[place - (goes_on() ? 1 : 0)].vertex;
    }

  private:
    static constexpr std::size_t kLooked = 64;

    using Lengths = std::array<double, 3>;
    struct Alike {
        double unlike;
        std::uint32_t came;
        Id vertex;
        auto operator<=>(const Alike&) const = default;
    };

    // Of the sides between the first three vertices of the stencil `by` vertices earlier.
    Lengths lengths(Id by, const std::vector<Point3>& values) const {
        Lengths out{};
        for (std::size_t k = 0; k < 3; ++k) {
            const Id a = stencil_.at[k == 2 ? 1 : 0], b = stencil_.at[k == 0 ? 1 : 2];
            if (a == kNone || b == kNone) continue;
            out[k] = length(minus(values[b - by], values[a - by]));
        }
        return out;
    }

    const Stencil& stencil_;
    const Id v_, on_;
    std::array<Alike, kLooked> others_;
    std::size_t count_ = 0;
};

// Who leads a seed is not told, as little is known of its part yet: what has led best of late does,
// the part that led so far or the one that began so many parts ago.
class SeedLeads {
  public:
    SeedLeads() { misses_.fill(kUnknown); }
    // The leader of vertex v, or kNone.
    Id leader(const Courses& courses, const Stencil& stencil, Id v) {
        const Id on = courses.going_on(stencil, v);
        candidates_[0] = on != kNone ? place_of(on) : kNoSeed;
        const std::size_t oldest = seeds_.size() - std::min(seeds_.size(), kLooked);
        const Id first = first_to_shift_to(stencil, v);
        count_ = 1;
        for (std::size_t i = seeds_.size(); i > oldest && count_ < candidates_.size(); --i)
            if (seeds_[i - 1].course == courses.course() && seeds_[i - 1].vertex >= first)
                candidates_[count_++] = i - 1;
        std::size_t best = kNoSeed;
        for (std::size_t k = 0; k < count_; ++k)
            if (candidates_[k] != kNoSeed && (best == kNoSeed || misses_[k] < misses_[best]))
                best = k;
        return best == kNoSeed ? kNone : seeds_[candidates_[best]].vertex;
    }
    // By how much the guess of v, the vertex that was asked about last, was off.
    void missed(const Courses& courses, Id v, const Point3& by) {
        for (std::size_t k = 0; k < count_; ++k) {
            if (candidates_[k] == kNoSeed) continue;
            const Point3 off = minus(by, seeds_[candidates_[k]].missed);
            std::uint64_t bits = 0;
            for (const double x : off) bits += digits_of(x);
            misses_[k] = misses_[k] / 2 + (bits << 16);
        }
        seeds_.push_back({courses.course(), v, by});
    }

  private:
    static constexpr std::size_t kLooked = 96, kCandidates = 32, kNoSeed = ~std::size_t{0};
    static constexpr std::uint64_t kUnknown = 128 << 16;
    struct Seed {
        std::uint64_t course;
        Id vertex;
        Point3 missed;
    };

    std::size_t place_of(Id v) const {
        const auto at = std::lower_bound(seeds_.begin(), seeds_.end(), v,
                                         [](const Seed& s, Id u) { return s.vertex < u; });
        return at != seeds_.end() && at->vertex == v ? static_cast<std::size_t>(at - seeds_.begin())
                                                     : kNoSeed;
    }

    std::vector<Seed> seeds_;
    std::array<std::size_t, kCandidates + 1> candidates_;  // the first: what led so far, if any
    std::size_t count_ = 0;
    std::array<std::uint64_t, kCandidates + 1> misses_;  // the last weighs half
};

}  // namespace ravel
