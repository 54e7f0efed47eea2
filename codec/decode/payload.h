// Reads the sections beside connectivity and positions into a mesh in the strip's order.
#pragma once

#include "base/bytes.h"
#include "container/head.h"
#include "mesh/reorder.h"

namespace ravel {

Status read_names(ByteReader& in, Mesh& mesh);

// Where the strip's order came from; checked to be permutations.
Result<Reorder> read_order(ByteReader& in, const Mesh& mesh);

// The mesh in the order it was encoded from.
Mesh restore_order(const Mesh& mesh, const Reorder& order);

}  // namespace ravel
