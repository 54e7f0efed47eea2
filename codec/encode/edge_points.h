// Finds the quadratic tets whose mid-edge nodes follow from the edges.
#pragma once

#include "encode/walk_driver.h"
#include "mesh/reorder.h"
#include "predict/edge_points.h"

namespace ravel {

// Where some block of companions has every tet for a host once, and one point for every edge that
// nothing but the tets around that edge has as a node of theirs: the edges, and `order` then has
// these points first of those that no cell has, in the order of the edges. Otherwise nothing.
EdgePoints order_edge_points(const Mesh& mesh, const WalkRecord& record, Reorder& order);

// Is the block, of a mesh in the order of the strip, what follows from the edges, but for the order
// of its cells?
bool follows_from(const EdgePoints& edges, const CompanionBlock& block);

}  // namespace ravel
