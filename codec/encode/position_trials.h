// Formats of positions, tried out one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "encode/positions.h"

namespace ravel {

inline constexpr std::size_t kSmallPositions = 6000;  // vertices below which every byte counts

// What is to be tried out beside what was kept so far, if anything.
using Candidate = std::optional<PositionFormat>;
struct Proposal {
    std::function<Candidate(const PositionFormat& kept)> format;
    bool usual = false;   // is it taken more often than not? For how it is tried, not for whether
    double worth = 0.01;  // taken where it makes the bytes fewer by this share, or more by less
                          // than that if it is below 0
    bool has_price = false;   // small meshes, too, have to win that; else all that is fewer will do
    double* ratio = nullptr;  // if not null, where it is told how many times as many bytes it makes
};

// What is kept of `start` and the proposals, in their order. `leads`: see ChosenFormat. Where there
// are more threads the next ones are tried meanwhile, as if the one at hand went as usual; what
// comes of it is the same. A pass over the positions per proposal, of large meshes over a part.
PositionFormat try_in_turn(const CodedPositions& all, const std::vector<std::uint8_t>& leads,
                           PositionFormat start, const std::vector<Proposal>& proposals,
                           int threads);

}  // namespace ravel
