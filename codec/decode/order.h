// The order a mesh had before it was encoded: read, and restored.
#pragma once

#include "base/bytes.h"
#include "mesh/reorder.h"
#include "predict/ground.h"
#include "walk/walk.h"

namespace ravel {

// Where the strip's order came from. `turned`: per companion block how many of its cells may be
// turned; they come first. `budget` is what may still be allocated; it shrinks.
Result<Reorder> read_order(ByteReader& in, const Ground<Walked>& ground,
                           const std::vector<Index>& turned, std::uint64_t& budget);

// Puts a mesh into the order it was encoded from.
void restore_order(Mesh& mesh, const Reorder& order);

}  // namespace ravel
