// Points as elements with values: those of the stencil are beside a point, the ends beside that of
// an edge.
#pragma once

#include "predict/around.h"
#include "predict/ground.h"
#include "predict/predictor.h"

namespace ravel {

template <class Walk>
class PointsAround final : public Around {
  public:
    explicit PointsAround(const Ground<Walk>& ground) : ground_(ground) { give_hints(); }

    Beside beside(Id p, const Id*) const override {
        Beside b;
        b.hint = hint_[p];
        if (p >= ground_.stencils.size()) {
            if (p > 0) b.add(p - 1);
            return b;
        }
        const Stencil& stencil = ground_.stencils[p];
        if (stencil.configuration == Configuration::edge) {
            for (std::uint8_t i = 0; i < 2; ++i) b.add(ground_.point[stencil.at[i]], i);
            return b;
        }
        // The parallelogram, where there is one; features come after the base.
        const bool led = stencil.configuration == Configuration::led;
        const Sum* const base = led || stencil.configuration == Configuration::tet
                                    ? nullptr
                                    : &kSums[static_cast<std::size_t>(stencil.configuration)][0];
        const bool whole = base != nullptr && !detail::names_missing(*base, stencil);
        // What a leader has is not near by.
        for (std::size_t i = 0; i < (led ? 7 : kStencilSize); ++i)
            if (stencil.at[i] != kNone)
                b.add(ground_.point[stencil.at[i]], i == 0 ? 0 : 1,
                      whole ? (*base)[i] : std::int8_t{0});
        return b;
    }
    Point3 place(Id p) const override { return ground_.place_of_point(p); }
    Point3 normal(Id p, bool) const override { return normals_[p]; }
    // The sums of those of all corners at a point.
    void prepare_normals(bool by_angle) override {
        normals_.assign(hint_.size(), {});
        for (Id c = 0; c < ground_.walk.vertex.size(); ++c) {
            const Point3 n = ground_.normal_at_corner(c, by_angle);
            for (std::size_t k = 0; k < 3; ++k) normals_[ground_.point_at(c)][k] += n[k];
        }
    }

  private:
    // Bits 0 and 1: the lowest dimension of the companions that have the point, 3 for none; bit 2:
    // the mesh ends there.
    void give_hints() {
        const Walk& walk = ground_.walk;
        hint_.assign(ground_.mesh.point_count(), 3);
        for (const CompanionBlock& block : ground_.mesh.companions) {
            if (!block.hosts.empty() || block.nodes_per_cell == 0) continue;
            const auto dimension =
                static_cast<std::uint8_t>(std::min<std::uint32_t>(block.nodes_per_cell, 4) - 1);
            for (const Index node : block.nodes) hint_[node] = std::min(hint_[node], dimension);
        }
        for (Id f = 0; f < walk.vertex.size(); ++f) {
            if (walk.twin[f] != kNone) continue;
            if (walk.kind == CellKind::tet) {
                for (Id c = f & ~Id{3}; c < (f & ~Id{3}) + 4; ++c)
                    if (c != f) hint_[ground_.point_at(c)] |= 4;
            } else {
                hint_[ground_.point_at(f)] |= 4;
                hint_[ground_.point_at(walk.next_in_cell(f))] |= 4;
            }
        }
    }

    const Ground<Walk>& ground_;
    std::vector<std::uint8_t> hint_;
    std::vector<Point3> normals_;
};

}  // namespace ravel
