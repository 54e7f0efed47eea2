// Flat faces across an axis: a coordinate that several neighbours share, the next vertex often has,
// too; or one that is known from elsewhere. On either side: `Coder` writes or reads flags.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <optional>
#include <vector>

#include "mesh/point3.h"
#include "mesh/stencil.h"
#include "predict/known_levels.h"
#include "predict/residual_context.h"

namespace ravel {

template <class Coder>
class LevelCodes {
  public:
    // `bits`: of the intervals in which known levels are looked for; 0: they are not.
    LevelCodes(Coder& coder, int bits, std::size_t vertices) : coder_(coder) {
        if (bits > 0) known_.emplace(bits, vertices);
    }

    // Before the axes of a vertex: who its neighbours are.
    void begin(const Stencil& stencil) {
        configuration_ = static_cast<std::uint32_t>(stencil.configuration);
        count_ = 0;
        for (std::size_t i = 0; i < kStencil; ++i)
            if (stencil.at[i] != kNone) id_[count_++] = stencil.at[i];
    }
    // Has the vertex the known coordinate nearest to the guess, or the one that most of its
    // neighbours share? `guess`: its whole part. `has(v)`: the writer's, has it that of v?
    template <class Has>
    bool next(const std::vector<Point3>& values, std::size_t axis, std::int64_t guess,
              const Has& has) {
        vertex_ = kNone;
        return (known_ && next_known(values, axis, guess, has)) ||
               next_shared(values, axis, guess, has);
    }
    // Whose coordinate that was.
    Id vertex() const { return vertex_; }

    // After each vertex.
    void insert(const Point3& value, Id vertex) {
        for (std::size_t axis = 0; axis < 3 && known_; ++axis) {
            if (is_known_[axis])
                known_->count(near_[axis].list, near_[axis].place);
            else
                known_->insert(axis, value[axis], vertex);
            is_known_[axis] = false;
        }
    }

  private:
    static constexpr std::size_t kStencil = 7;  // entries that are looked at

    // Not asked where no two share one, or it is the known one that was just refused.
    template <class Has>
    bool next_shared(const std::vector<Point3>& values, std::size_t axis, std::int64_t guess,
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
        const double level = x[best];
        if (vertex_ != kNone && values[vertex_][axis] == level) return false;
        vertex_ = id_[best];
        const bool same =
            coder_.flag(ResidualContexts::level.at(configuration_, most, history_[axis],
                                                   guess == static_cast<std::int64_t>(level)),
                        Coder::kWrites && has(vertex_));
        history_[axis] = (history_[axis] << 1 | (same ? 1u : 0u)) & 3;
        return same;
    }
    template <class Has>
    bool next_known(const std::vector<Point3>& values, std::size_t axis, std::int64_t guess,
                    const Has& has) {
        const KnownLevels::Near& near = near_[axis] =
            known_->nearest(axis, static_cast<double>(guess));
        if (near.vertex == kNone) return false;
        vertex_ = near.vertex;
        const double level = values[vertex_][axis];
        std::uint32_t votes = 0;
        for (std::size_t i = 0; i < count_; ++i) votes += values[id_[i]][axis] == level;
        const auto far =
            static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint64_t>(near.distance)));
        const auto often = static_cast<std::uint32_t>(std::bit_width(near.count)) - 1;
        bool& before = was_known_[axis];
        const std::uint32_t beside = 4 * before + std::min(votes, 3u);
        return is_known_[axis] = before =
                   coder_.flag(ResidualContexts::known.at(far, often, beside, count_ > 4),
                               Coder::kWrites && has(vertex_));
    }

    Coder& coder_;
    std::optional<KnownLevels> known_;
    std::uint32_t configuration_ = 0;
    std::array<std::uint32_t, 3> history_{};  // the last two answers per axis
    std::array<bool, 3> was_known_{};         // the last answer
    std::array<KnownLevels::Near, 3> near_{};
    std::array<bool, 3> is_known_{};  // has the vertex the level of near_?
    std::array<Id, kStencil> id_{};
    std::size_t count_ = 0;
    Id vertex_ = kNone;
};

}  // namespace ravel
