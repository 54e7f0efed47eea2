// The sections beside connectivity and positions, in the strip's order.
#pragma once

#include "base/bytes.h"
#include "mesh/reorder.h"

namespace ravel {

Bytes write_names(const Mesh& mesh);
Bytes write_order(const Reorder& order, const std::vector<CompanionBlock>& companions);

}  // namespace ravel
