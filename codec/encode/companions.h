// Writes the section of the companions, and orders them as they come back.
#pragma once

#include "base/bytes.h"
#include "encode/strip_mesh.h"

namespace ravel {

struct CompanionCodes {
    Bytes section;
    std::vector<Id> marked;     // facets that are companions, each as that of its earlier cell
    std::vector<Index> turned;  // per block: cells that may be turned; they come first
};

// Companions that are parts of the mesh come first in their block, in the order of the walk, and
// start where it has them; those that follow from `edges` are in the order of their hosts; `order`
// tells. Values at companions follow.
CompanionCodes write_companions(StripMesh& strip, const Walked& walked, const EdgePoints& edges,
                                Reorder& order);

// Where the companions of the mesh are once it has been decoded.
void map_companions(const Reorder& order, bool order_is_kept, OrderMaps& maps);

}  // namespace ravel
