// What may make the positions of a mesh smaller.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "encode/echoes.h"
#include "encode/position_trials.h"

namespace ravel {

// What a look at the mesh has shown.
struct Prospects {
    std::size_t vertices = 0;
    bool surface = false;
    Echoes echoes;
    bool may_share = false;                // neighbours share coordinates
    std::optional<Weights> along_weights;  // tets: if vertices go on with borders, those for that
    RoundFaceList rounds;                  // tets
    Weights round_weights{};               // those for them
    bool may_follow = false;
    bool has_triangles = false;
};

// The proposals to be tried, in their order.
class Proposals {
  public:
    explicit Proposals(Prospects prospects);
    // The list refers to this, and trials tell it how they went.
    Proposals(const Proposals&) = delete;
    Proposals& operator=(const Proposals&) = delete;

    const std::vector<Proposal>& list() const { return list_; }

  private:
    template <class When, class Change>
    Proposal& offer(bool usual, const When& when, const Change& change);
    void offer_rice();
    void offer_echoes();
    void offer_levels();
    void offer_levels_of_surface();
    void offer_less_echoes();
    template <class When>
    void offer_levels_instead(const When& when);
    void offer_borders();
    void offer_follows();
    bool is_small() const { return prospects_.vertices < kSmallPositions; }
    bool knows_echoes_alone(const PositionFormat& format) const;
    double levels_price() const;

    const Prospects prospects_;
    double echo_ratio_ = 1, level_ratio_ = 1;
    std::vector<Proposal> list_;
};

}  // namespace ravel
