// Few nodes of a graph whose strips are searched exhaustively.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/joiner.h"

namespace ravel {

// Nodes that hang together, from some given ones on, each time the one with most edges into the
// region: few edges lead out of such a region. Nodes that are `barred` stay out, and large ones.
std::vector<GraphId> grow_region(const Graph& graph, std::span<const GraphId> start,
                                 std::size_t size, const std::vector<std::uint8_t>& barred);

struct RegionSearch {
    std::size_t steps = 4000;   // after which it gives up
    bool part_has_path = true;  // a part that has none may get one
    std::uint32_t seed = 0;     // not 0: choices are tried in an arbitrary order
    bool sideways = false;      // any choice will do that leaves no more strips than there are
};

// Chooses the edges inside the region anew, while all outside stays as it is, so that the strips of
// its part become fewer. Asks for a joiner that has joined nothing yet, of the set as it is. False
// where nothing is changed.
bool merge_in_region(StripJoiner& joiner, std::span<const GraphId> region,
                     const RegionSearch& options, EdgeSet& set);

// The fewest closed strips and singletons that lie inside the region whatever the set is outside,
// where `ends` of the part's path's ends are in it. Where a search of `steps` can't tell, a number
// that is lower still.
GraphId fewest_inside(const Graph& graph, std::span<const GraphId> region, int ends,
                      std::size_t steps);

}  // namespace ravel
