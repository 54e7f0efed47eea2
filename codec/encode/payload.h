// The sections beside connectivity and positions, in the strip's order.
#pragma once

#include "base/bytes.h"
#include "mesh/reorder.h"

namespace ravel {

Bytes write_companions(const Mesh& mesh, const Reorder& order, const std::vector<Index>& new_point,
                       const std::vector<Index>& new_cell);
Bytes write_names(const Mesh& mesh);
Bytes write_order(const Reorder& order);

}  // namespace ravel
