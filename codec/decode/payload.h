// Reads the sections beside connectivity and positions into a mesh in the strip's order.
#pragma once

#include "base/bytes.h"
#include "ravel/mesh.h"

namespace ravel {

Status read_names(ByteReader& in, Mesh& mesh);

}  // namespace ravel
