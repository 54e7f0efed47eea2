// The vertices that may be the apex beyond a gate, likeliest first.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/complex.h"

namespace ravel {

struct ApexCandidate {
    Id vertex = kNone;
    double height = 0;   // of its sphere
    bool above = false;  // is it on the right side of the gate, and the gate no degenerate one?
    bool beyond_border = false;
    std::uint8_t fan = 0;     // most tets round one of the edges it folds onto
    std::uint32_t times = 0;  // edges of the gate it folds onto
};

// In the order of rank: of height, where each fold makes up for 1/32 of the gate's circumradius
// (in regular meshes several vertices lie on one sphere); what is not above comes last, more folds
// first. Of equal ranks the one that came first. Mostly the first two are all that is asked for, so
// only they are put in their places
// until `sort`.
class ApexList {
  public:
    // What is beyond those asked for is let go.
    static constexpr std::size_t kMost = 12;

    void clear(double height_of_radius) {
        list_.clear();
        worth_ = height_of_radius / 32;
    }
    std::size_t size() const { return list_.size(); }
    bool empty() const { return list_.empty(); }
    const ApexCandidate& operator[](std::size_t i) const { return list_[i].candidate; }

    // Is it one of the first `among`?
    bool holds(Id vertex, std::size_t among) const {
        return std::any_of(list_.begin(), list_.begin() + static_cast<std::ptrdiff_t>(among),
                           [&](const Ranked& r) { return r.candidate.vertex == vertex; });
    }
    void add(const ApexCandidate& candidate) {
        list_.push_back({rank_of(candidate), static_cast<std::uint32_t>(list_.size()), candidate});
    }
    // The candidate of a vertex, which is changed before it is ranked; a new one where there is
    // none.
    template <class Change>
    void change(Id vertex, const Change& change) {
        std::size_t i = 0;
        while (i < list_.size() && list_[i].candidate.vertex != vertex) ++i;
        if (i == list_.size()) {
            list_.push_back({0, static_cast<std::uint32_t>(i), {}});
            list_[i].candidate.vertex = vertex;
            list_[i].candidate.beyond_border = true;
        }
        change(list_[i].candidate);
        list_[i].rank = rank_of(list_[i].candidate);
    }
    // Puts the first `count` in their places; of those that are in their places none moves.
    void lift(std::size_t count) {
        for (std::size_t place = 0; place < count && place < list_.size(); ++place) {
            std::size_t least = place;
            for (std::size_t i = place + 1; i < list_.size(); ++i)
                least = list_[i] < list_[least] ? i : least;
            std::swap(list_[place], list_[least]);
        }
    }
    // Lets go all but the first kMost, and puts these in their places.
    void sort() {
        lift(kMost);
        if (list_.size() > kMost) list_.resize(kMost);
    }

  private:
    struct Ranked {
        double rank;
        std::uint32_t came;
        ApexCandidate candidate;

        bool operator<(const Ranked& other) const {
            return rank != other.rank ? rank < other.rank : came < other.came;
        }
    };
    double rank_of(const ApexCandidate& c) const {
        return c.above ? c.height - worth_ * c.times : 1e300 / (1 + c.times);
    }

    std::vector<Ranked> list_;
    double worth_ = 0;
};

// Heights in classes, for contexts; `unit` is the height that equals the gate's circumradius.
inline constexpr std::uint32_t kNotAbove = 13;
inline std::uint32_t height_class(const ApexCandidate& candidate, double unit) {
    static constexpr std::array<double, 12> kBounds{-0.5, 0.0, 0.2, 0.35, 0.5, 0.67,
                                                    0.9,  1.2, 1.6, 2.2,  3.5, 7.7};
    if (!candidate.above) return kNotAbove;
    const double h = candidate.height / unit;
    std::uint32_t c = 0;
    for (const double bound : kBounds) c += h > bound;
    return c;
}
// How far the second candidate lies above the first: 0 for next to nothing, 3 for far or none.
inline std::uint32_t gap_class(const ApexList& list, double unit) {
    if (list.size() < 2 || !list[1].above) return 3;
    const double gap = (list[1].height - list[0].height) / unit;
    return (gap >= 0.03) + (gap >= 0.12) + (gap >= 0.35);
}
inline std::uint32_t second_class(const ApexList& list, double unit) {
    if (list.size() < 2 || !list[1].above) return 5;
    const double h = list[1].height / unit;
    return (h >= 0.35) + (h >= 0.67) + (h >= 1.2) + (h >= 2.2);
}

}  // namespace ravel
