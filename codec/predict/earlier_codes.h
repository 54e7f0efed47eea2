// Vertices that an earlier one tells, as its echo or as its leader: which coordinates are as that
// one says, and by how much the others are off. On either side: `Coder` writes or reads flags.
#pragma once

#include <cstddef>
#include <cstdint>

#include "predict/follow_sizes.h"
#include "predict/position_format.h"
#include "predict/pricing.h"
#include "predict/residual_context.h"

namespace ravel {

template <class Coder>
class EarlierCodes {
  public:
    EarlierCodes(Coder& coder, const PositionFormat& format)
        : coder_(coder),
          format_(format),
          tells_whole_(format.numbers.digits == 0 && !format.numbers.has_minus_zero &&
                       !format.has_escapes) {}

    // Before a vertex that has a leader.
    void begin_led(const Stencil& stencil) { led_.sizes.begin(stencil); }
    // Does it follow the leader? `better`: the writer's answer.
    bool follows(const Earlier& found, bool better) {
        better = coder_.flag(follow_context(found), better);
        followed_ = (followed_ << 1 | (better ? 1u : 0u)) & 7;
        return better;
    }

    // A vertex that is told, before its axes. Is all of it the same, to the last bit?
    bool begin(const Earlier& found, bool follows, const Position& truth) {
        is_led_ = follows;
        sames_ = 0;
        all_same_ = may_be_same(found) && code_all_same(coder_, now(), found, truth);
        return all_same_;
    }
    bool same(const Earlier& found, std::size_t axis, const Number& truth) {
        return all_same_ || (may_be_same(found) && sames_ != 3 &&
                             code_same(coder_, now(), sames_, found, axis, truth));
    }
    // By how much an axis that is not the same is off.
    std::int64_t residual(const Earlier& found, std::size_t axis, std::int64_t r) {
        return code_off(coder_, now(), found, axis, r);
    }
    void end() {
        if (is_led_) led_.sizes.end();
    }

    // The bits that all this would take, for a writer.
    double price(const Earlier& found, bool follows, const Position& truth) const {
        Pricing<Coder> pricing{coder_};
        State state = follows ? led_ : echoed_;
        if (may_be_same(found) && code_all_same(pricing, state, found, truth)) return pricing.bits;
        std::uint32_t sames = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (!may_be_same(found) || sames == 3 ||
                !code_same(pricing, state, sames, found, axis, truth[axis])) {
                code_off(pricing, state, found, axis, truth[axis].whole - found.whole[axis]);
                pricing.bits += rest_bits(format_.numbers, truth[axis].whole);
            }
        return pricing.bits;
    }
    // And the flag, beyond what it takes to say no.
    double follow_price(const Earlier& found) const {
        const Context context = follow_context(found);
        return coder_.cost(context, true) - coder_.cost(context, false);
    }

  private:
    struct State {
        bool leads = false;
        std::uint32_t all_same = 0, same = 0;  // the last answers
        FollowSizes sizes;

        std::uint32_t far() const { return leads ? sizes.far() : 0; }
    };

    State& now() { return is_led_ ? led_ : echoed_; }
    bool may_be_same(const Earlier& found) const {
        return found.copies || format_.numbers.digits == 0;
    }
    Context follow_context(const Earlier& found) const {
        return ResidualContexts::follow.at(followed_, found.copies, led_.far());
    }

    template <class AnyCoder>
    bool code_all_same(AnyCoder& coder, State& state, const Earlier& found,
                       const Position& truth) const {
        bool same = Coder::kWrites;
        for (std::size_t axis = 0; axis < 3 && same; ++axis)
            same = is_value(format_, truth[axis], found.value[axis], found.exact[axis]);
        same = coder.flag(
            ResidualContexts::all_same.at(state.leads, state.all_same, found.copies, state.far()),
            same);
        state.all_same = (state.all_same << 1 | (same ? 1u : 0u)) & 7;
        return same;
    }
    // `sames`: a bit for each axis that is. The last one is not if the others are, as not all are.
    template <class AnyCoder>
    bool code_same(AnyCoder& coder, State& state, std::uint32_t& sames, const Earlier& found,
                   std::size_t axis, const Number& truth) const {
        using C = ResidualContexts;
        const auto a = static_cast<std::uint32_t>(axis);
        const Context context =
            state.leads ? C::follow_same.at(state.far(), a, state.same) : C::same.at(a, state.same);
        const bool same =
            coder.flag(context, Coder::kWrites &&
                                    is_value(format_, truth, found.value[axis], found.exact[axis]));
        state.same = (state.same << 1 | (same ? 1u : 0u)) & 3;
        sames |= (same ? 1u : 0u) << axis;
        return same;
    }
    template <class AnyCoder>
    std::int64_t code_off(AnyCoder& coder, State& state, const Earlier& found, std::size_t axis,
                          std::int64_t r) const {
        const Scale scale = state.leads ? state.sizes.scale(axis)
                                        : Scale{kEchoScale + static_cast<std::uint32_t>(axis), 2};
        r = code_residual(coder, scale, r, NoSignQuestion{}, may_be_same(found) && tells_whole_);
        if (state.leads) state.sizes.coded(r);
        return r;
    }

    Coder& coder_;
    const PositionFormat& format_;
    const bool tells_whole_;  // is a coordinate another only if its whole part is?
    State echoed_, led_ = [] {
        State led;
        led.leads = true;
        return led;
    }();
    bool is_led_ = false, all_same_ = false;  // the vertex that is being coded
    std::uint32_t sames_ = 0, followed_ = 0;
};

}  // namespace ravel
