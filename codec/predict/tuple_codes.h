// Codes which tuple of a pool an element has. Tuples are numbered in the order of their first use,
// so that a new one costs no number; most elements have the tuple of a neighbour. On either side:
// `Coder` writes or reads.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "predict/attribute_contexts.h"

namespace ravel {

// The tuples of an element's neighbours, each once, in the order they were added.
class Candidates {
  public:
    struct One {
        Id tuple;
        std::uint32_t kind, hint, votes;
    };
    void clear() { count_ = votes_ = 0; }
    // `kind`: how the neighbour lies. kNone is a tuple, too: that of elements that lack one.
    void add(Id tuple, std::uint32_t kind, std::uint32_t hint) {
        ++votes_;
        for (std::size_t i = 0; i < count_; ++i)
            if (of_[i].tuple == tuple) {
                ++of_[i].votes;
                return;
            }
        if (count_ < of_.size()) of_[count_++] = {tuple, kind, hint, 1};
    }
    bool holds(Id tuple) const {
        for (std::size_t i = 0; i < count_; ++i)
            if (of_[i].tuple == tuple) return true;
        return false;
    }
    std::size_t size() const { return count_; }
    std::uint32_t votes() const { return votes_; }
    const One& operator[](std::size_t i) const { return of_[i]; }

  private:
    std::array<One, kMostBeside> of_;
    std::size_t count_ = 0;
    std::uint32_t votes_ = 0;
};

template <class Coder>
class TupleCodes {
  public:
    // At most `tuples` different ones; `may_lack`: elements may have none.
    TupleCodes(Coder& coder, Id tuples, bool may_lack)
        : coder_(coder), most_(tuples), may_lack_(may_lack) {}

    // The writer's numbers of tuples are its own; these are by order of use.
    Id used() const { return used_; }
    Id number_of(Id truth) const {
        return truth == kNone ? kNone : truth < number_.size() ? number_[truth] : kUnknown;
    }
    // Sets `tuple` to that of the next element, or to kNone. False: no encoder writes this.
    bool code(const Candidates& candidates, std::uint32_t hint, Id truth, Id& tuple) {
        const Id goal = Coder::kWrites ? number_of(truth) : kNone;
        std::uint32_t against = candidates.votes();
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            const Candidates::One& one = candidates[i];
            against -= one.votes;
            if (coder_.flag(AttributeContexts::same.at(one.kind, one.hint, one.votes - 1, against),
                            Coder::kWrites && one.tuple == goal))
                return done(tuple = one.tuple);
        }
        if (may_lack_ && !candidates.holds(kNone)) {
            lacked_ = coder_.flag(AttributeContexts::lacks.at(lacked_, candidates.size() > 0),
                                  Coder::kWrites && goal == kNone);
            if (lacked_) {
                tuple = kNone;
                return true;
            }
        }
        if (used_ < most_ &&
            (used_ == 0 || coder_.flag(AttributeContexts::fresh.at(
                                           static_cast<std::uint32_t>(candidates.size()), hint),
                                       Coder::kWrites && goal == kUnknown))) {
            if constexpr (Coder::kWrites) {
                if (truth >= number_.size()) number_.resize(std::size_t{truth} + 1, kUnknown);
                number_[truth] = used_;
            }
            return done(tuple = used_++);
        }
        std::uint32_t rank = 0;
        for (const Id recent : recent_) {
            if (recent == kNone || candidates.holds(recent)) continue;
            if (coder_.flag(AttributeContexts::recent.at(rank++), Coder::kWrites && recent == goal))
                return done(tuple = recent);
        }
        if (used_ == 0) return false;
        tuple = static_cast<Id>(
            coder_.plain(Coder::kWrites ? goal : 0, static_cast<int>(std::bit_width(used_ - 1))));
        return tuple < used_ && done(tuple);
    }

  private:
    static constexpr Id kUnknown = kNone - 1;

    bool done(Id tuple) {
        if (tuple == kNone) return true;
        auto at = std::find(recent_.begin(), recent_.end(), tuple);
        if (at == recent_.end()) --at;
        std::move_backward(recent_.begin(), at, at + 1);
        recent_.front() = tuple;
        return true;
    }

    Coder& coder_;
    const Id most_;
    const bool may_lack_;
    Id used_ = 0;
    bool lacked_ = false;
    std::array<Id, 8> recent_ = [] {
        std::array<Id, 8> none{};
        none.fill(kNone);
        return none;
    }();
    std::vector<Id> number_;  // the writer's: its number -> number by use
};

// Where the tuples of late go on as they did before: the longest way back is kept as long as it
// holds, then the last place is taken where the same three came together.
class TupleEcho {
  public:
    explicit TupleEcho(std::size_t elements)
        : seen_(std::bit_ceil(std::clamp<std::size_t>(elements, 16, 1 << 20)), kNone) {}

    // The element whose tuple may come next, or kNone; and how many have held, by classes of 8.
    Id at() const { return at_; }
    std::uint32_t held() const {
        return std::min(static_cast<std::uint32_t>(std::bit_width(held_ >> 1)), kHints - 1);
    }
    void next(const std::vector<Id>& tuple, Id element) {
        const bool held = at_ != kNone && tuple[at_] == tuple[element];
        held_ = held ? held_ + 1 : 0;
        hash_ = (hash_ << 10) * 0x9E3779B1u + tuple[element];
        const std::uint32_t mixed = hash_ * 0x85EBCA77u;
        Id& last = seen_[(mixed ^ mixed >> 15) & (seen_.size() - 1)];
        at_ = held ? at_ + 1 : last;
        last = element + 1;
    }

  private:
    std::vector<Id> seen_;  // by the hash of the last tuples: the element after them
    std::uint32_t hash_ = 0, held_ = 0;
    Id at_ = kNone;
};

// Element after element. `tuple` has the writer's numbers before, numbers by use after.
template <class Coder>
bool code_tuples(TupleCodes<Coder>& codes, const Around& around, std::vector<Id>& tuple) {
    constexpr std::uint32_t kFirm = 4;  // an echo that has held so long is asked for first
    Candidates candidates;
    TupleEcho echo(tuple.size());
    for (std::size_t e = 0; e < tuple.size(); ++e) {
        const Beside beside = around.beside(static_cast<Id>(e), tuple.data());
        candidates.clear();
        const bool echoes = echo.at() != kNone;
        if (echoes && echo.held() >= kFirm) candidates.add(tuple[echo.at()], 3, echo.held());
        for (std::uint32_t i = 0; i < beside.count; ++i)
            candidates.add(tuple[beside.at[i]], beside.kind[i], beside.hint);
        if (echoes && echo.held() < kFirm) candidates.add(tuple[echo.at()], 3, echo.held());
        if (!codes.code(candidates, beside.hint, tuple[e], tuple[e])) return false;
        echo.next(tuple, static_cast<Id>(e));
    }
    return true;
}

}  // namespace ravel
