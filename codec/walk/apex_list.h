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
    double height = 0;       // of its sphere
    bool above = false;      // is it on the right side of the gate, and the gate no degenerate one?
    std::uint8_t fan = 0;    // most tets round one of the edges it folds onto
    std::uint8_t times = 0;  // edges of the gate it folds onto
};

// In the order of rank: of height, where each fold makes up for 1/32 of the gate's circumradius
// (in regular meshes several vertices lie on one sphere); what is not above comes last, more folds
// first. Of equal ranks the one that came first. Mostly the first two are all that is asked for, so
// `lift_two` puts only them in their places.
class ApexList {
  public:
    // What is beyond those asked for is let go.
    static constexpr std::size_t kMost = 12;

    void clear(double height_of_radius) {
        size_ = 0;
        worth_ = height_of_radius / 32;
    }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const ApexCandidate& operator[](std::size_t i) const { return list_[i].candidate; }

    // Those of the first kMost, kNone where there are no more.
    std::array<Id, kMost> vertices() const {
        std::array<Id, kMost> all;
        for (std::size_t i = 0; i < kMost; ++i)
            all[i] = i < size_ ? list_[i].candidate.vertex : kNone;
        return all;
    }
    // Is it one of the first `among`?
    bool holds(Id vertex, std::size_t among) const {
        bool is = false;
        for (std::size_t i = 0; i < among; ++i) is |= list_[i].candidate.vertex == vertex;
        return is;
    }
    void add(const ApexCandidate& candidate) {
        if (size_ == list_.size()) list_.resize(2 * size_ + 16);
        list_[size_] = {rank_of(candidate), static_cast<std::uint32_t>(size_), candidate};
        ++size_;
    }
    // The candidate of a vertex, which is changed before it is ranked; a new one where there is
    // none.
    template <class Change>
    void change(Id vertex, const Change& change) {
        std::size_t i = 0;
        while (i < size_ && list_[i].candidate.vertex != vertex) ++i;
        if (i == size_) {
            ApexCandidate candidate;
            candidate.vertex = vertex;
            add(candidate);
        }
        change(list_[i].candidate);
        list_[i].rank = rank_of(list_[i].candidate);
    }
    // Puts the first two in their places, while all stand as they came.
    void lift_two() {
        if (size_ < 2) return;
        std::size_t first = 0, second = 1;
        if (list_[1].rank < list_[0].rank) std::swap(first, second);
        for (std::size_t i = 2; i < size_; ++i) {
            const double rank = list_[i].rank;
            const bool is_first = rank < list_[first].rank, is_second = rank < list_[second].rank;
            second = is_first ? first : is_second ? i : second;
            first = is_first ? i : first;
        }
        std::swap(list_[0], list_[first]);
        std::swap(list_[1], list_[second == 0 ? first : second]);
    }
    // Lets go all but the first kMost, and puts these in their places.
    void sort() {
        const std::size_t kept = std::min(size_, kMost);
        std::partial_sort(list_.begin(), list_.begin() + static_cast<std::ptrdiff_t>(kept),
                          list_.begin() + static_cast<std::ptrdiff_t>(size_));
        size_ = kept;
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
    std::size_t size_ = 0;
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
// By how many edges it folds onto, and whether three tets or more are around one of them.
inline std::uint32_t folds_class(const ApexCandidate& candidate) {
    return candidate.times == 0 ? 0u : (candidate.times > 1 ? 3u : 1u) + (candidate.fan > 2);
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
