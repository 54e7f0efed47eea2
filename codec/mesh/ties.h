// Pairs of vertices, in the order in which they came. Every vertex knows those it is tied to.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "mesh/complex.h"

namespace ravel {

class Ties {
  public:
    void reserve(std::size_t vertices) {
        latest_.reserve(vertices);
        ties_.reserve(2 * vertices);
    }
    // The next vertex; it has no ties yet.
    void add_vertex() { latest_.push_back(kNone); }
    // No vertex is tied to itself, and none to any once there are 2^31 - 1 ties.
    void tie(Id a, Id b) {
        if (a == b || ties_.size() >= kNone / 2) return;
        const auto at = static_cast<Id>(2 * ties_.size());
        ties_.push_back({{a, b}, {latest_[a], latest_[b]}});
        latest_[a] = at;
        latest_[b] = at + 1;
    }
    // Calls visit(u) for those v is tied to, latest first, at most so many.
    template <class Visit>
    void each(Id v, std::size_t most, const Visit& visit) const {
        Id end = latest_[v];
        for (std::size_t k = 0; k < most && end != kNone; ++k) {
            const Tie& tie = ties_[end / 2];
            visit(tie.end[1 - end % 2]);
            end = tie.before[end % 2];
        }
    }

  private:
    // An end of a tie is 2 * its number + 0 or 1.
    struct Tie {
        std::array<Id, 2> end;
        std::array<Id, 2> before;  // of either vertex the next older end, or kNone
    };
    std::vector<Tie> ties_;
    std::vector<Id> latest_;  // per vertex; its latest end
};

}  // namespace ravel
