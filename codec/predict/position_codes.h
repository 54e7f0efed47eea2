// Codes the position of each new vertex where the walk meets it, on either side: `Coder` writes or
// reads flags and plain bits (see code_residual). Coordinates are numbers of a unit (numbers.h);
// guesses are made in IEEE doubles from values both sides know.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "mesh/point3.h"
#include "predict/border_codes.h"
#include "predict/earlier_codes.h"
#include "predict/echo_codes.h"
#include "predict/follows.h"
#include "predict/grid.h"
#include "predict/lead_codes.h"
#include "predict/level_codes.h"
#include "predict/numbers.h"
#include "predict/position_format.h"
#include "predict/position_guess.h"
#include "predict/predictor.h"
#include "predict/pricing.h"
#include "predict/residual_context.h"
#include "predict/rest_codes.h"
#include "predict/rice_codes.h"

namespace ravel {

template <class Coder>
class PositionCodes {
  public:
    // `vertices`: about how many there will be, unused points among them. `leads`: see LeadCodes.
    PositionCodes(Coder& coder, const PositionFormat& format, std::size_t vertices,
                  const std::vector<std::uint8_t>* leads = nullptr)
        : coder_(coder),
          format_(format),
          rounding_(format),
          keeps_exact_(format.keeps_exact()),
          earlier_(coder, format_),
          predictor_(format.weights, format.mirrored, format.leaders_move),
          sizes_(format.usual_start),
          levels_(coder, format.has_levels ? format.level_bits : 0, format.has_pairs, vertices),
          rest_(coder, format.numbers,
                !format.has_escapes ? 0
                : format.narrow     ? 32
                                    : 64) {
        if (!format_.echoes.empty()) echoes_.emplace(coder, format_, vertices);
        if (format_.has_along) border_.emplace(coder, format_);
        if (format_.has_follows) leads_.emplace(coder, vertices, leads);
        is_plain_ = format_.grid() && !format_.has_escapes && !format_.has_levels && !border_ &&
                    !leads_ && !echoes_;
    }

    void reserve(std::size_t vertices) {
        values_.reserve(vertices);
        if (keeps_exact_) exact_.reserve(vertices);
        sizes_.reserve(vertices);
        if (echoes_) echoes_->reserve(vertices);
        if (border_) border_->reserve(vertices);
    }

    // False: a value no encoder writes.
    bool next(const Stencil& stencil, const Position& truth) {
        if (is_plain_) return next_plain(stencil, truth);
        PositionGuess guess = guess_of(stencil);
        // The middle of an edge tells more than an echo.
        const bool edge = is_edge(stencil);
        Earlier found;
        bool told = false;     // by the vertex found
        bool stays = true;     // is it where that one is?
        bool follows = false;  // by the leader
        bool sane = true;
        std::optional<std::size_t> border;  // the writer's choice, if it has been made
        Id leader = kNone;
        if (leads_ && !edge) sane = leads_->next(stencil, next_vertex(), values_, false, leader);
        if (leader != kNone) {
            earlier_.begin_led(stencil);
            found = find_follow(stencil, leader, guess.at);
            bool better = false;
            if constexpr (Coder::kWrites)
                better = guess_takes_more(earlier_.price(found, true, truth) +
                                              earlier_.follow_price(found) + kFollowPrice,
                                          guess, truth, border);
            told = follows = earlier_.follows(found, better);
        }
        if (echoes_ && !told && !edge) {
            found = echoes_->find(stencil, guess.at, values_, exact_);
            if (found.vertex != kNone) {
                bool better = false;
                if constexpr (Coder::kWrites)
                    better = guess_takes_more(
                        earlier_.price(found, false, truth) + echoes_->price(found), guess, truth,
                        border);
                told = echoes_->is_told(found, better);
            }
            echoes_->looked(told);
            if (told) stays = echoes_->stays(found);
        }
        if (border_ && !told && stencil.borders != 0) {
            if constexpr (Coder::kWrites)
                if (!border) {
                    border.emplace();
                    least_price(guess, truth, *border);
                }
            if (border_->next(stencil, values_, border.value_or(kNoBorder))) guess = guess_along();
        }
        sizes_.begin(*guess.stencil);
        const bool levels = format_.has_levels && !edge;
        if (levels) levels_.begin(*guess.stencil);
        const bool all_same = told && earlier_.begin(found, follows, truth);
        Point3 value{}, exact{};
        for (std::size_t step = 0; step < 3 && sane; ++step) {
            const std::size_t axis = guess.axes[step];
            const bool carried = guess.along && step == 2;
            const double* const before = before_of(guess, axis, value);
            if (carried) guess.whole[axis] = whole_carried(guess, value);
            const std::int64_t whole = guess.whole[axis];
            Number number = truth[axis];
            std::int64_t missed = 0;
            bool same = false;
            const auto a = static_cast<std::uint32_t>(axis);
            if (told) {
                same = earlier_.same(found, axis, number);
                if (same) {
                    value[axis] = found.value[axis];
                    if (found.copies) exact[axis] = found.exact[axis];
                    sane = std::abs(value[axis]) < static_cast<double>(rounding_.most);
                } else {
                    number.whole =
                        sum_of(found.whole[axis],
                               earlier_.residual(found, axis, number.whole - found.whole[axis]));
                }
            } else {
                if (levels)
                    same = levels_.next(values_, axis, whole, before, [&](Id v) {
                        return is_value(format_, number, values_[v][axis], exact_or_0(v, axis));
                    });
                if (same) {
                    value[axis] = values_[levels_.vertex()][axis];
                    if (keeps_exact_) exact[axis] = exact_[levels_.vertex()][axis];
                } else {
                    const double part = carried ? 0 : rounding_.part_of(guess.at[axis], whole);
                    missed =
                        code_whole(carried ? sizes_.scale_off_plane() : sizes_.scale(axis, step),
                                   whole, number.whole, sign_by(axis, part));
                }
            }
            if (!same) {
                const bool tells = edge && missed == 0;  // the guess, of what is behind the point
                sane = number.whole < rounding_.most && number.whole > -rounding_.most &&
                       rest_.next(a, tells ? &guess.at[axis] : nullptr, number);
                if (number.escaped)
                    escapes_.push_back({number.rest, static_cast<Id>(values_.size()), a});
                const Scaled s = sane ? scaled_of(format_.numbers, number) : Scaled{};
                value[axis] = s.units;
                exact[axis] = s.exact;
            }
            // How far off the guess was, whatever told the coordinate.
            if ((told || same) && sane)
                missed = static_cast<std::int64_t>(value[axis] - static_cast<double>(whole));
            sizes_.coded_residual(axis, missed);
            if (carried)
                sizes_.coded_off_plane(
                    axis, static_cast<std::uint64_t>(std::abs(value[axis] - guess.at[axis]) + 0.5));
        }
        sizes_.push();
        if (told) earlier_.end();
        if (leads_ && !edge && leads_->in_seed())
            leads_->missed(next_vertex(), minus(value, guess.at));
        if (echoes_) echoes_->add_partner(&stencil, told && !follows ? found.vertex : kNone);
        add(value, exact, stays && found.copies && all_same);
        return sane;
    }

    // The same where a value is a residual on a grid and nothing else.
    bool next_plain(const Stencil& stencil, const Position& truth) {
        const Point3 g = guess_at(stencil);
        sizes_.begin(stencil);
        Point3 value{};
        bool sane = true;
        for (std::size_t axis = 0; axis < 3 && sane; ++axis) {
            std::int64_t whole = truth[axis].whole;
            const std::int64_t guess = rounding_.whole_of(g[axis]);
            const std::int64_t missed =
                code_whole(sizes_.scale(axis, axis), guess, whole,
                           sign_by(axis, rounding_.part_of(g[axis], guess)));
            sizes_.coded_residual(axis, missed);
            sane = whole < rounding_.most && whole > -rounding_.most;
            if (sane) value[axis] = static_cast<double>(whole);
        }
        sizes_.push();
        values_.push_back(value);
        return sane;
    }

    // A vertex that both sides know already; for trials.
    void skip(const Stencil& stencil, const Position& truth) {
        sizes_.begin(stencil);
        sizes_.push_half();
        const bool may_follow = leads_ && stencil.configuration != Configuration::edge;
        Id leader = kNone;
        if (may_follow) leads_->next(stencil, next_vertex(), values_, true, leader);
        Point3 value{}, exact{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Scaled s = scaled_of(format_.numbers, truth[axis]);
            value[axis] = s.units;
            exact[axis] = s.exact;
        }
        if (may_follow && leads_->in_seed())
            leads_->missed(next_vertex(), minus(value, guess_at(stencil)));
        const bool stays = leader != kNone && values_[leader] == value &&
                           (!keeps_exact_ || exact_[leader] == exact);
        if (echoes_) echoes_->add_partner(&stencil);
        add(value, exact, stays);
    }

    // A vertex at the place of an earlier one.
    void copy(Id of) {
        const Point3 value = values_[of];
        sizes_.push_nothing();
        if (echoes_) echoes_->add_partner(nullptr);
        add(value, keeps_exact_ ? exact_[of] : Point3{}, true);
    }

    const PositionFormat& format() const { return format_; }
    // In units.
    const std::vector<Point3>& values() const { return values_; }
    // A coordinate that is no grid's, as a double.
    double exact(std::size_t vertex, std::size_t axis) const {
        if (keeps_exact_) return exact_[vertex][axis];
        const double x = values_[vertex][axis];
        return format_.numbers.base == NumberBase::decimal
                   ? x / kTensAsDoubles[static_cast<std::size_t>(format_.numbers.places)]
                   : std::ldexp(x, -format_.numbers.places);
    }
    // In the order of the vertices.
    const std::vector<Escape>& escapes() const { return escapes_; }

  private:
    // Bits, to the writer: a leader that is hardly better makes others less sure.
    static constexpr double kFollowPrice = 1;

    static constexpr std::size_t kNoBorder = 3;

    Id next_vertex() const { return static_cast<Id>(values_.size()); }

    // `stays`: where an earlier vertex stands, which is enough for who looks for one.
    void add(const Point3& value, const Point3& exact, bool stays) {
        const Id v = next_vertex();
        values_.push_back(value);
        if (keeps_exact_) exact_.push_back(exact);
        if (echoes_ && stays) echoes_->skip();
        if (echoes_ && !stays) echoes_->insert(value);
        if (!stays) levels_.insert(value, v);
        if (border_) border_->insert(value);
        if (leads_) leads_->insert(v);
    }

    Point3 guess_at(const Stencil& stencil) {
        Point3 g = predictor_.guess(stencil, values_);
        for (double& x : g) x = rounding_.clamped(x);
        // A middle that was computed was rounded as the mesh's floats are.
        if (stencil.configuration == Configuration::edge && format_.narrow &&
            format_.numbers.base == NumberBase::binary)
            for (double& x : g) x = to_24_bits(x);
        return g;
    }
    PositionGuess guess_of(const Stencil& stencil) {
        const Point3 g = guess_at(stencil);
        return {&stencil,
                g,
                {rounding_.whole_of(g[0]), rounding_.whole_of(g[1]), rounding_.whole_of(g[2])},
                {0, 1, 2},
                false};
    }
    // Of a vertex that goes on with the border that was met last.
    PositionGuess guess_along() {
        PositionGuess guess = guess_of(border_->stencil());
        guess.at = border_->laid(guess.at);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            guess.at[axis] = rounding_.clamped(guess.at[axis]);
            guess.whole[axis] = rounding_.whole_of(guess.at[axis]);
        }
        guess.axes = border_->axes();
        guess.along = true;
        return guess;
    }
    // The last coordinate of such a vertex, the others of `value` being known.
    std::int64_t whole_carried(const PositionGuess& guess, const Point3& value) const {
        return rounding_.whole_of(rounding_.clamped(border_->carried(guess.at, value)));
    }
    auto sign_by(std::size_t axis, double part) const {
        return [this, axis, part](std::uint32_t size) { return sizes_.sign(size, axis, part); };
    }

    // The vertex as its leader stands among its neighbours.
    Earlier find_follow(const Stencil& stencil, Id leader, const Point3& g) {
        Earlier found;
        found.vertex = leader;
        const Stencil before = shifted(stencil, next_vertex() - leader);
        found.copies = true;
        for (std::size_t i = 0; i < 3 && stencil.at[i] != kNone; ++i)
            found.copies = found.copies && values_[stencil.at[i]] == values_[before.at[i]];
        if (found.copies) {
            found.value = values_[leader];
            if (keeps_exact_) found.exact = exact_[leader];
        } else {
            found.value =
                carried(values_, stencil, before, minus(values_[leader], guess_at(before)), g);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            found.value[k] = rounding_.clamped(found.value[k]);
            found.whole[k] = rounding_.whole_of(found.value[k]);
            if (format_.numbers.digits == 0 && !found.copies)
                found.value[k] = static_cast<double>(found.whole[k]);
        }
        return found;
    }
    // What the vertex would take by its guess, for the writer, or `enough` where it is that or
    // more: the least of that without a border, and with each of those beside it. `border`: which
    // that is.
    double least_price(const PositionGuess& guess, const Position& truth, std::size_t& border,
                       double enough = 1e300) {
        border = kNoBorder;
        double least = enough, no = 0;
        for (std::size_t e = 0; border_ && e < 3; ++e) {
            if (!border_->meet(*guess.stencil, e, values_)) continue;
            const double yes = no + coder_.cost(border_->context(), true);
            no += coder_.cost(border_->context(), false);
            const PositionGuess along = guess_along();
            const double bits = yes + price(along, truth, least - yes);
            if (!(bits < least)) continue;
            least = bits, border = e;
        }
        const double bits = no + price(guess, truth, least - no);
        if (bits < least) border = kNoBorder;
        return std::min(bits, least);
    }
    // The bits that its coordinates take, or at least `enough`.
    double price(PositionGuess guess, const Position& truth, double enough) {
        Pricing<Coder> pricing{coder_};
        const Point3 value = units_of(format_.numbers, truth);
        const auto answers = levels_.answers();
        sizes_.begin(*guess.stencil);
        const bool levels = format_.has_levels && !is_edge(*guess.stencil);
        if (levels) levels_.begin(*guess.stencil);
        for (std::size_t step = 0; step < 3 && pricing.bits < enough; ++step) {
            const std::size_t axis = guess.axes[step];
            const bool carried = guess.along && step == 2;
            if (carried) guess.whole[axis] = whole_carried(guess, value);
            const std::int64_t whole = guess.whole[axis], r = truth[axis].whole - whole;
            const auto has = [&](Id v) {
                return is_value(format_, truth[axis], values_[v][axis], exact_or_0(v, axis));
            };
            if (!levels || !levels_.next_by(pricing, values_, axis, whole,
                                            before_of(guess, axis, value), has)) {
                const double part = carried ? 0 : rounding_.part_of(guess.at[axis], whole);
                const Scale scale = carried ? sizes_.scale_off_plane() : sizes_.scale(axis, step);
                if (format_.has_rice)
                    rice_.code(pricing, scale, r);
                else
                    code_residual(pricing, scale, r, sign_by(axis, part));
                pricing.bits += rest_bits(format_.numbers, truth[axis].whole);
            }
            sizes_.coded_residual(axis, r);
        }
        levels_.take_back(answers);
        return pricing.bits;
    }
    // Would it take more by its guess than that?
    bool guess_takes_more(double bits, const PositionGuess& guess, const Position& truth,
                          std::optional<std::size_t>& border) {
        border.emplace();
        return !(least_price(guess, truth, *border, bits) < bits);
    }
    double exact_or_0(Id v, std::size_t axis) const { return keeps_exact_ ? exact_[v][axis] : 0; }

    // Returns by how much the guess was off.
    template <class Sign = NoSignQuestion>
    std::int64_t code_whole(const Scale& scale, std::int64_t guess, std::int64_t& whole,
                            const Sign& sign = {}) {
        std::int64_t r = whole - guess;
        if (format_.has_rice) {
            r = rice_.code(coder_, scale, r);
            rice_.learn(scale, r);
        } else {
            r = code_residual(coder_, scale, r, sign);
        }
        whole = sum_of(guess, r);
        return r;
    }

    Coder& coder_;
    const PositionFormat format_;
    const Rounding rounding_;
    const bool keeps_exact_;
    bool is_plain_ = false;
    EarlierCodes<Coder> earlier_;
    Predictor predictor_;
    ResidualSizes sizes_;
    RiceMeans rice_;
    LevelCodes<Coder> levels_;
    RestCodes<Coder> rest_;
    std::vector<Point3> values_, exact_;
    std::vector<Escape> escapes_;
    std::optional<BorderCodes<Coder>> border_;
    std::optional<EchoCodes<Coder>> echoes_;
    std::optional<LeadCodes<Coder>> leads_;
};

}  // namespace ravel
