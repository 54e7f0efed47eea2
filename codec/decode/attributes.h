// Reads the section of the attributes into a mesh in the strip's order.
#pragma once

#include "container/head.h"
#include "predict/ground.h"
#include "walk/walk.h"

namespace ravel {

// `budget` is what may still be allocated; it shrinks. `mesh` is that of the ground.
// `marked`: facets that are companions.
Status read_attributes(ByteReader& in, const Head& head, const Ground<Walked>& ground,
                       const std::vector<Id>& marked, std::uint64_t& budget, Mesh& mesh);

}  // namespace ravel
