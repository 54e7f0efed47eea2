// Flat faces across an axis: a coordinate that several neighbours share, the next vertex often has,
// too. On either side: `Coder` writes or reads flags.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "mesh/point3.h"
#include "mesh/stencil.h"
#include "predict/residual_context.h"

namespace ravel {

template <class Coder>
class LevelCodes {
  public:
    explicit LevelCodes(Coder& coder) : coder_(coder) {}

    // Before the axes of a vertex: who its neighbours are.
    void begin(const Stencil& stencil) {
        configuration_ = static_cast<std::uint32_t>(stencil.configuration);
        count_ = 0;
        for (std::size_t i = 0; i < kStencil; ++i)
            if (stencil.at[i] != kNone) id_[count_++] = stencil.at[i];
    }
    // Has the vertex the coordinate that most of them share? Not asked where no two do. `guess`:
    // its whole part. `has(x)`: the writer's, has it this one?
    template <class Has>
    bool next(const std::vector<Point3>& values, std::size_t axis, std::int64_t guess,
              const Has& has) {
        // The first of those that most share. All are held against all: fewer steps would be more
        // branches that nobody foresees. What is not there equals nothing.
        std::array<double, 8> x;
        x.fill(std::numeric_limits<double>::quiet_NaN());
        for (std::size_t i = 0; i < count_; ++i) x[i] = values[id_[i]][axis];
        std::array<std::int64_t, 8> votes{};
        for (std::size_t j = 0; j < kStencil; ++j)
            for (std::size_t i = 0; i < 8; ++i) votes[i] += x[i] == x[j];
        std::size_t best = 0;
        for (std::size_t i = 1; i < kStencil; ++i) best = votes[i] > votes[best] ? i : best;
        const auto most = static_cast<std::uint32_t>(votes[best]);
        if (most < 2) return false;
        vertex_ = id_[best];
        const double level = values[vertex_][axis];
        const bool same =
            coder_.flag(ResidualContexts::level.at(configuration_, most, history_[axis],
                                                   guess == static_cast<std::int64_t>(level)),
                        Coder::kWrites && has(level));
        history_[axis] = (history_[axis] << 1 | (same ? 1u : 0u)) & 3;
        return same;
    }
    // Whose coordinate that was.
    Id vertex() const { return vertex_; }

  private:
    static constexpr std::size_t kStencil = 7;  // entries that are looked at

    Coder& coder_;
    std::uint32_t configuration_ = 0;
    std::array<std::uint32_t, 3> history_{};  // the last two answers per axis
    std::array<Id, kStencil> id_{};
    std::size_t count_ = 0;
    Id vertex_ = 0;
};

}  // namespace ravel
