#include "encode/position_proposals.h"

#include <utility>

namespace ravel {
namespace {

// What helps one mesh costs another a flag per vertex, and costs time: it stays where it makes the
// bytes fewer, of all but small meshes by a hundredth at least. What takes much of the time to
// decode stays where it is worth its price.
constexpr std::size_t kLarge = 200000;  // vertices from which fewer things are tried
constexpr double kSlow = 0.02;          // of what costs more time
constexpr double kHopeless = 1.02;      // where levels make more, other kinds are no help either
constexpr double kSurely = 0.9;         // where echoes make less, levels are no help without them
// Of surfaces; of small ones half as much, and nothing.
constexpr double kLevelsPrice = 0.04, kEchoesPrice = 0.01;
// Of models for residuals, beside Rice codes: a hundredth of it is what runs of flags take more
// than trials count.
constexpr double kModelsPrice = 0.025;
constexpr bool kTaken = true, kRefused = false;  // as usual

bool always(const PositionFormat&) {
    return true;
}
void take_levels(PositionFormat& f) {
    f.has_levels = true;
}
// Pairs may be known where single levels tell nothing.
void take_pairs(PositionFormat& f) {
    if (f.level_bits == 0) f.level_bits = f.cube_bits;
    f.has_levels = f.has_pairs = true;
}
bool knows_levels(const PositionFormat& f) {
    return f.level_bits > 0;
}
void widen_intervals(PositionFormat& f) {
    ++f.level_bits;
}
void drop_pairs(PositionFormat& f) {
    f.has_pairs = false;
}
void drop_known_levels(PositionFormat& f) {
    drop_pairs(f);
    f.level_bits = 0;
}
void drop_levels(PositionFormat& f) {
    drop_known_levels(f);
    f.has_levels = false;
}
void drop_echoes(PositionFormat& f) {
    f.echoes.clear();
}
void take_levels_instead(PositionFormat& f) {
    drop_echoes(f);
    take_pairs(f);
}
void set_price(Proposal& proposal, double price) {
    proposal.worth = price;
    proposal.has_price = true;
}

}  // namespace

Proposals::Proposals(Prospects prospects) : prospects_(std::move(prospects)) {
    offer_echoes();
    if (prospects_.surface)
        offer_levels_of_surface();
    else
        offer_levels();
    offer_less_echoes();
    offer_borders();
    if (prospects_.may_follow) offer_follows();
    // Where parts repeat, a guess from fewer points is carried over with fewer roundings.
    if (prospects_.has_triangles)
        offer(
            kRefused, [](const PositionFormat& f) { return f.has_follows || !f.echoes.empty(); },
            [](PositionFormat& f) { f.weights = without_triangles(f.weights); })
            .worth = 0;
    if (prospects_.surface) offer_rice();
}

// `when`: is there anything to try? `change`: what is other than in the format kept so far.
template <class When, class Change>
Proposal& Proposals::offer(bool usual, const When& when, const Change& change) {
    Proposal& proposal = list_.emplace_back();
    proposal.format = [when, change](const PositionFormat& kept) -> Candidate {
        if (!when(kept)) return std::nullopt;
        PositionFormat format = kept;
        change(format);
        return format;
    };
    proposal.usual = usual;
    return proposal;
}

// Residuals take less time without models, and hardly more bytes where few of them are 0.
void Proposals::offer_rice() {
    set_price(offer(kRefused, always, [](PositionFormat& f) { f.has_rice = true; }), -kModelsPrice);
}

void Proposals::offer_echoes() {
    const Echoes& echoes = prospects_.echoes;
    if (!echoes.likely.empty())
        offer(kTaken, always, [this](PositionFormat& f) {
            f.echoes = prospects_.echoes.likely;
        }).ratio = &echo_ratio_;
    if (!echoes.more.empty() && prospects_.vertices < kLarge)
        offer(kRefused, always, [this](PositionFormat& f) {
            for (const Echo& echo : prospects_.echoes.more)
                if (f.echoes.size() < kMostEchoes) f.echoes.push_back(echo);
        });
    if (is_small())
        offer(
            kRefused, [](const PositionFormat& f) { return !f.echoes.empty(); },
            [](PositionFormat& f) { ++f.cube_bits; });
}

void Proposals::offer_levels() {
    if (prospects_.may_share) offer(kTaken, always, take_levels);
    offer(kTaken, always, [](PositionFormat& f) {
        f.has_levels = true;
        f.level_bits = f.cube_bits;
    }).ratio = &level_ratio_;
    if (prospects_.vertices < kLarge / 4) offer(kRefused, knows_levels, widen_intervals);
    offer(
        kTaken,
        [&](const PositionFormat& f) {
            return level_ratio_ < kHopeless && (knows_levels(f) || prospects_.vertices < kLarge);
        },
        take_pairs)
        .worth = kSlow;
}

double Proposals::levels_price() const {
    return is_small() ? kLevelsPrice / 2 : kLevelsPrice;
}

// All at once: where that tells too little for its time, a part of it mostly does, too.
void Proposals::offer_levels_of_surface() {
    Proposal& pairs = offer(kTaken, always, take_pairs);
    pairs.ratio = &level_ratio_;
    set_price(pairs, levels_price());
    set_price(offer(kRefused, knows_levels, drop_pairs), -levels_price() / 2);
    if (prospects_.may_share) {
        set_price(offer(kRefused, knows_levels, drop_known_levels), -levels_price() / 2);
        set_price(
            offer(
                kRefused,
                [&](const PositionFormat& f) { return !f.has_levels && level_ratio_ < kHopeless; },
                take_levels),
            levels_price() / 2);
    }
    if (prospects_.vertices < kLarge / 4) offer(kRefused, knows_levels, widen_intervals);
}

// Echoes, and no levels but those that neighbours share.
bool Proposals::knows_echoes_alone(const PositionFormat& format) const {
    return !knows_levels(format) && !format.echoes.empty() && prospects_.vertices < kLarge &&
           (is_small() || echo_ratio_ > kSurely);
}

template <class When>
void Proposals::offer_levels_instead(const When& when) {
    Proposal& instead = offer(kRefused, when, take_levels_instead);
    if (prospects_.surface) set_price(instead, levels_price());
}

// What was taken first may be no help beside levels, and what was not taken may be better in its
// place.
void Proposals::offer_less_echoes() {
    Proposal& without = offer(
        kRefused,
        [&](const PositionFormat& f) {
            return knows_levels(f) && !f.echoes.empty() && (is_small() || echo_ratio_ > kSurely);
        },
        drop_echoes);
    if (prospects_.surface) without.worth = -kEchoesPrice;
    offer_levels_instead([&](const PositionFormat& f) { return knows_echoes_alone(f); });
}

void Proposals::offer_borders() {
    if (prospects_.along_weights)
        offer(kTaken, always, [&](PositionFormat& f) {
            f.has_along = true;
            f.weights = *prospects_.along_weights;
        });
    if (prospects_.rounds.empty()) return;
    offer(kTaken, always, [&](PositionFormat& f) {
        f.has_along = true;
        f.rounds = prospects_.rounds;
    });
    offer(
        kTaken, [](const PositionFormat& f) { return !f.rounds.empty(); },
        [&](PositionFormat& f) { f.weights = prospects_.round_weights; });
    offer(
        kRefused, [](const PositionFormat& f) { return !f.rounds.empty() && !f.echoes.empty(); },
        drop_echoes);
}

// Who follows asks for neither echoes nor levels, so that costs less time than others, and leaves
// less for these to tell.
void Proposals::offer_follows() {
    Proposal& follows = offer(kTaken, always, [](PositionFormat& f) { f.has_follows = true; });
    follows.worth /= 4;
    offer_levels_instead(
        [&](const PositionFormat& f) { return f.has_follows && knows_echoes_alone(f); });
    if (!prospects_.surface) return;
    offer(
        kRefused, [](const PositionFormat& f) { return f.has_follows && !f.echoes.empty(); },
        drop_echoes)
        .worth = -kEchoesPrice;
    set_price(offer(
                  kRefused, [](const PositionFormat& f) { return f.has_follows && f.has_levels; },
                  drop_levels),
              -levels_price());
}

}  // namespace ravel
