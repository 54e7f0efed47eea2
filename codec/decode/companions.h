// Reads the section of the companions into a mesh in the strip's order.
#pragma once

#include "container/head.h"
#include "predict/edge_points.h"
#include "predict/ground.h"
#include "walk/walk.h"

namespace ravel {

// `budget` is what may still be allocated; it shrinks. `mesh` is that of the ground. Sets `marked`
// to the facets that are companions, each as that of its earlier cell, and `turned` to how many
// cells of each block may be turned; they come first. `edges`: if they have points of their own.
Status read_companions(ByteReader& in, const Head& head, const BlockHead& block,
                       const Ground<Walked>& ground, std::uint64_t& budget, Mesh& mesh,
                       const EdgePoints& edges, std::vector<Id>& marked,
                       std::vector<Index>& turned);

}  // namespace ravel
