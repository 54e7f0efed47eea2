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
#include "predict/level_pairs.h"
#include "predict/residual_context.h"

namespace ravel {

template <class Coder>
class LevelCodes {
  public:
    // `bits`: of the intervals in which known levels are looked for; 0: they are not. `pairs`: also
    // those beside the coordinate on the axis before.
    LevelCodes(Coder& coder, int bits, bool pairs, std::size_t vertices) : coder_(coder) {
        if (bits > 0) known_.emplace(bits, vertices);
        if (bits > 0 && pairs) pairs_.emplace(bits, vertices);
    }

    // Before the axes of a vertex: who its neighbours are.
    void begin(const Stencil& stencil) {
        configuration_ = static_cast<std::uint32_t>(stencil.configuration);
        count_ = 0;
        for (std::size_t i = 0; i < kStencil; ++i)
            if (stencil.at[i] != kNone) id_[count_++] = stencil.at[i];
    }
    // Has the vertex the known coordinate nearest to the guess, or the one that most of its
    // neighbours share? `guess`: its whole part; `before`: its coordinate on the axis before, if
    // that has been coded. `has(v)`: the writer's, has it that of v?
    template <class Has>
    bool next(const std::vector<Point3>& values, std::size_t axis, std::int64_t guess,
              const double* before, const Has& has) {
        return next_by(coder_, values, axis, guess, before, has);
    }
    // The same by another coder, such as one that tells a writer what it would take; `answers` and
    // `take_back` around all of a vertex leave everything as it was.
    template <class AnyCoder, class Has>
    bool next_by(AnyCoder& coder, const std::vector<Point3>& values, std::size_t axis,
                 std::int64_t guess, const double* before, const Has& has) {
        vertex_ = kNone;
        refused_.fill(std::numeric_limits<double>::quiet_NaN());
        return (pairs_ && before != nullptr &&
                next_pair(coder, values, axis, guess, *before, has)) ||
               (known_ && next_known(coder, values, axis, guess, has)) ||
               next_shared(coder, values, axis, guess, has);
    }
    // Whose coordinate that was.
    Id vertex() const { return vertex_; }

    struct Answers {
        std::array<std::uint32_t, 3> shared{};  // the last two per axis
        std::array<bool, 3> known{}, paired{};  // the last
        std::array<bool, 3> is_known{};         // has the vertex the level of near_?
    };
    const Answers& answers() const { return answers_; }
    void take_back(const Answers& answers) { answers_ = answers; }

    // After each vertex.
    void insert(const Point3& value, Id vertex) {
        for (std::size_t axis = 0; axis < 3 && known_; ++axis) {
            if (answers_.is_known[axis])
                known_->count(near_[axis].list, near_[axis].place);
            else
                known_->insert(axis, value[axis], vertex);
            answers_.is_known[axis] = false;
        }
        for (std::size_t axis = 1; axis < 3 && pairs_; ++axis)
            pairs_->insert(axis, value[axis - 1], value[axis], vertex);
    }

  private:
    static constexpr std::size_t kStencil = 7;  // entries that are looked at

    // Not asked where no two share one, or it is one that was just refused.
    template <class AnyCoder, class Has>
    bool next_shared(AnyCoder& coder, const std::vector<Point3>& values, std::size_t axis,
                     std::int64_t guess, const Has& has) {
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
        if (level == refused_[0] || level == refused_[1]) return false;
        vertex_ = id_[best];
        std::uint32_t& history = answers_.shared[axis];
        const bool same =
            coder.flag(ResidualContexts::level.at(configuration_, most, history,
                                                  guess == static_cast<std::int64_t>(level)),
                       Coder::kWrites && has(vertex_));
        history = (history << 1 | (same ? 1u : 0u)) & 3;
        return same;
    }
    template <class AnyCoder, class Has>
    bool next_known(AnyCoder& coder, const std::vector<Point3>& values, std::size_t axis,
                    std::int64_t guess, const Has& has) {
        const KnownLevels::Near& near = near_[axis] =
            known_->nearest(axis, static_cast<double>(guess));
        if (near.vertex == kNone) return false;
        const double level = refused_[1] = values[near.vertex][axis];
        if (level == refused_[0]) return false;
        vertex_ = near.vertex;
        const auto often = static_cast<std::uint32_t>(std::bit_width(near.count)) - 1;
        bool& before = answers_.known[axis];
        const std::uint32_t beside = 4 * before + std::min(votes_for(values, axis, level), 3u);
        return answers_.is_known[axis] = before = coder.flag(
                   ResidualContexts::known.at(width_of(near.distance), often, beside, count_ > 4),
                   Coder::kWrites && has(vertex_));
    }
    template <class AnyCoder, class Has>
    bool next_pair(AnyCoder& coder, const std::vector<Point3>& values, std::size_t axis,
                   std::int64_t guess, double other, const Has& has) {
        const LevelPairs::Near near = pairs_->nearest(axis, other, static_cast<double>(guess));
        if (near.vertex == kNone) return false;
        vertex_ = near.vertex;
        const double level = refused_[0] = values[vertex_][axis];
        bool& before = answers_.paired[axis];
        const std::uint32_t beside = 4 * before + std::min(votes_for(values, axis, level), 3u);
        return before = coder.flag(
                   ResidualContexts::pair.at(width_of(near.distance), std::min(near.place, 3u),
                                             beside, count_ > 4),
                   Coder::kWrites && has(vertex_));
    }
    std::uint32_t votes_for(const std::vector<Point3>& values, std::size_t axis,
                            double level) const {
        std::uint32_t votes = 0;
        for (std::size_t i = 0; i < count_; ++i) votes += values[id_[i]][axis] == level;
        return votes;
    }

    Coder& coder_;
    std::optional<KnownLevels> known_;
    std::optional<LevelPairs> pairs_;
    std::uint32_t configuration_ = 0;
    Answers answers_;
    std::array<double, 2> refused_{};  // of pairs, and known: found, but not the vertex's, or NaN
    std::array<KnownLevels::Near, 3> near_{};
    std::array<Id, kStencil> id_{};
    std::size_t count_ = 0;
    Id vertex_ = kNone;
};

}  // namespace ravel
