// The vertices that may be the apex beyond a gate, likeliest first.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "mesh/complex.h"
#include "walk/sphere_family.h"

namespace ravel {

struct ApexCandidate {
    Id vertex = kNone;
    double height = 0;   // of its sphere
    bool above = false;  // is it on the right side of the gate, and the gate no degenerate one?
    bool beyond_border = false;
    std::uint8_t fan = 0;     // most tets round one of the edges it folds onto
    std::uint32_t times = 0;  // edges of the gate it folds onto
};

// In the order of height, where each fold makes up for 1/32 of the gate's circumradius: in regular
// meshes several vertices lie on one sphere. Equal ones stay in the order they came.
class ApexList {
  public:
    // What is beyond those asked for is let go, or a crowd of vertices would make each tet cost the
    // square of the crowd.
    static constexpr std::size_t kMost = 12;

    void clear(double height_of_radius) {
        size_ = 0;
        worth_ = height_of_radius / 32;
    }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const ApexCandidate& operator[](std::size_t i) const { return list_[i]; }
    bool holds(Id vertex) const { return place_of(vertex) < size_; }

    void offer(const ApexCandidate& candidate) {
        const double rank = rank_of(candidate);
        std::size_t i = size_;
        if (i == kMost) {
            if (!(rank < rank_[kMost - 1])) return;
            --i;
        } else {
            ++size_;
        }
        for (; i > 0 && rank < rank_[i - 1]; --i) {
            list_[i] = list_[i - 1];
            rank_[i] = rank_[i - 1];
        }
        list_[i] = candidate;
        rank_[i] = rank;
    }
    // Removes and returns the candidate of a vertex; a fresh one where there is none.
    ApexCandidate take(Id vertex) {
        const std::size_t i = place_of(vertex);
        if (i == size_) {
            ApexCandidate fresh;
            fresh.vertex = vertex;
            fresh.beyond_border = true;
            return fresh;
        }
        const ApexCandidate known = list_[i];
        --size_;
        for (std::size_t k = i; k < size_; ++k) {
            list_[k] = list_[k + 1];
            rank_[k] = rank_[k + 1];
        }
        return known;
    }

  private:
    std::size_t place_of(Id vertex) const {
        std::size_t i = 0;
        while (i < size_ && list_[i].vertex != vertex) ++i;
        return i;
    }
    // What is not above comes last, more folds first.
    double rank_of(const ApexCandidate& c) const {
        return c.above ? c.height - worth_ * c.times : 1e300 / (1 + c.times);
    }

    std::array<ApexCandidate, kMost> list_;
    std::array<double, kMost> rank_{};
    std::size_t size_ = 0;
    double worth_ = 0;
};

}  // namespace ravel
