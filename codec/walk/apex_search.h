// Looks among the vertices of the front for those whose spheres through a gate lie low.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "walk/apex_list.h"
#include "walk/sphere_family.h"
#include "walk/tet_front.h"
#include "walk/vertex_grid.h"

namespace ravel {

class ApexSearch {
  public:
    struct Near {
        double height, above;
        Id vertex;

        bool operator<(const Near& other) const {
            return height != other.height ? height < other.height : vertex < other.vertex;
        }
    };

    // Front vertices inside the lowest sphere so far, or inside a rather high one; from low spheres
    // to higher ones, until one holds a vertex. Where the sphere is large beside the grid's cubes
    // the search is not made, or ends early.
    void offer_near(const VertexGrid& grid, const std::array<Id, 3>& gate,
                    const SphereFamily& family, ApexList& list) {
        if (family.flat()) return;
        const std::size_t folds = list.size();  // what is found is none of the others found
        double lowest = 1e300;
        for (std::size_t i = 0; i < folds; ++i)
            if (list[i].above) lowest = std::min(lowest, list[i].height);
        for (const double multiple : {1.0, 2.0}) {
            const double height = std::min(multiple * family.unit(), lowest);
            bool found = false;
            for (const Near& near : below(grid, gate, family, height)) {
                if (list.holds(near.vertex, folds)) continue;
                ApexCandidate candidate;
                candidate.vertex = near.vertex;
                candidate.height = near.height;
                candidate.above = true;
                list.add(candidate);
                found = true;
            }
            if (found || height == lowest) return;
        }
    }

    // The front vertices whose spheres are not above `height`, in `near_`.
    std::span<Near> below(const VertexGrid& grid, const std::array<Id, 3>& gate,
                          const SphereFamily& family, double height) {
        const double twice = 2 * height;
        std::size_t seen = 0, count = 0;
        // Whether one is near enough is anyone's guess, so nothing branches on it.
        grid.around(family.centre_at(height), family.radius_at(height),
                    [&](Id v, const Point3& place) {
                        const SphereFamily::Lift lift = family.lift_of(place);
                        near_[count] = {lift.twice, lift.above, v};
                        count += (lift.above > 0) & (lift.twice <= twice * lift.above);
                        return ++seen < kMostLooked;
                    });
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const Near near = near_[i];
            near_[kept] = {near.height / (2 * near.above), near.above, near.vertex};
            kept += !is_in(gate, near.vertex);
        }
        return {near_.data(), kept};
    }

  private:
    static constexpr std::size_t kMostLooked = 256;  // vertices of a search

    std::vector<Near> near_ = std::vector<Near>(kMostLooked);
};

}  // namespace ravel
