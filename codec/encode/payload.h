// The sections beside connectivity and positions, in the strip's order.
#pragma once

#include "base/bytes.h"
#include "ravel/mesh.h"

namespace ravel {

Bytes write_names(const Mesh& mesh);

}  // namespace ravel
