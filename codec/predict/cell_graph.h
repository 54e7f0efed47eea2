// Cells linked by their facets, for floods; and cells as elements with values.
#pragma once

#include "mesh/flatness.h"
#include "predict/around.h"
#include "predict/flood_codes.h"
#include "predict/ground.h"

namespace ravel {

template <class Walk>
class CellGraph final : public FloodGraph {
  public:
    // Parts may well end at the facets `marked`.
    CellGraph(const Ground<Walk>& ground, const std::vector<Id>& marked)
        : FloodGraph(ground.walk.vertex.size()),
          ground_(ground),
          walled_(ground.walk.vertex_count, 0) {
        for (const Id f : marked) set_former(f);
    }

    Id size() const override { return ground_.walk.cell_count(); }
    Id begin(Id cell) const override { return ground_.walk.begin(cell); }
    Id end(Id cell) const override { return ground_.walk.end(cell); }
    Id twin(Id facet) const override { return ground_.walk.twin[facet]; }
    Id element_of(Id facet) const override { return ground_.walk.cell_of(facet); }

    // The straightest way on from the walls about the edges (ends) of the facet, and from how many
    // of them.
    std::uint32_t walls_about(Id facet, const std::vector<std::uint8_t>& known) const override {
        const Walk& walk = ground_.walk;
        const bool tets = walk.kind == CellKind::tet;
        // A wall about an edge has both of its ends.
        const Id base = facet & ~Id{3};
        std::array<bool, 4> at{};
        std::uint32_t ends = 0;
        if (tets) {
            for (Id k = 0; k < 4; ++k) {
                at[k] = k != (facet & 3) && walled_[walk.vertex[base + k]];
                ends += at[k];
            }
            if (ends < 2) return 0;
        } else {
            at[0] = walled_[walk.vertex[facet]];
            at[1] = walled_[walk.vertex[walk.next_in_cell(facet)]];
            if (!at[0] && !at[1]) return 0;
        }
        const Point3 own = tets ? ground_.normal_of(facet) : ground_.way_of(facet);
        std::uint32_t straightest = 0, walls = 0;
        const auto enter = [&](Id cell) { return known[cell] != 0; };
        const auto visit = [&](Id g) {
            if (!is_wall(g)) return true;
            ++walls;
            straightest = std::max(straightest,
                                   flatness(own, tets ? ground_.normal_of(g) : ground_.way_of(g)));
            return false;
        };
        if (tets) {
            for (Id local = 0; local < 4; ++local)
                if (local != (facet & 3) && ends - at[local] == 2)
                    ground_.turn_about_edge(facet, local, enter, visit);
        } else {
            if (at[0]) ground_.turn_about_end(facet, false, enter, visit);
            if (at[1]) ground_.turn_about_end(facet, true, enter, visit);
        }
        return 3 * straightest + std::min(walls, 2u);
    }
    void note_start() override { walled_.assign(walled_.size(), 0); }
    void note_wall(Id facet) override {
        const Walk& walk = ground_.walk;
        if (walk.kind == CellKind::tet) {
            for (Id k = facet & ~Id{3}; k < (facet | 3) + 1; ++k)
                if (k != facet) walled_[walk.vertex[k]] = 1;
        } else {
            walled_[walk.vertex[facet]] = walled_[walk.vertex[walk.next_in_cell(facet)]] = 1;
        }
    }

  private:
    const Ground<Walk>& ground_;
    std::vector<std::uint8_t> walled_;  // per vertex: is it on a wall?
};

template <class Walk>
class CellsAround final : public Around {
  public:
    explicit CellsAround(const Ground<Walk>& ground) : ground_(ground) {}

    // The cell behind the gate, then the other earlier neighbours.
    Beside beside(Id cell, const Id*) const override {
        const Walk& walk = ground_.walk;
        Beside b;
        const Id gate = walk.gate[cell];
        if (gate != kNone) b.add(walk.cell_of(gate));
        for (Id f = walk.begin(cell); f < walk.end(cell) && b.count < kMostBeside; ++f) {
            const Id g = walk.twin[f];
            if (g != kNone && g != gate && walk.cell_of(g) < cell) b.add(walk.cell_of(g), 1);
        }
        if (b.count == 0 && cell > 0) b.add(cell - 1, 2);
        return b;
    }
    Point3 place(Id cell) const override {
        const Walk& walk = ground_.walk;
        // Of very large polygons a part will do.
        const Id begin = walk.begin(cell), end = std::min(walk.end(cell), begin + kMostLinks);
        Point3 sum{};
        for (Id c = begin; c < end; ++c) {
            const Point3 p = ground_.place_of_corner(c);
            for (std::size_t k = 0; k < 3; ++k) sum[k] += p[k];
        }
        for (double& x : sum) x /= static_cast<double>(end - begin);
        return sum;
    }
    Point3 normal(Id cell, bool) const override { return ground_.normal_of_polygon(cell); }

  private:
    const Ground<Walk>& ground_;
};

}  // namespace ravel
