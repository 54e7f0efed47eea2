// Writes the section of the order.
#pragma once

#include "base/bytes.h"
#include "mesh/reorder.h"
#include "predict/ground.h"
#include "walk/walk.h"

namespace ravel {

// `turned`: per companion block how many of its cells may be turned; they come first.
Bytes write_order(const Ground<Walked>& ground, const std::vector<Index>& turned, Reorder order);

}  // namespace ravel
