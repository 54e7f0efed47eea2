// Inputs: a path, or "-" for stdin.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ravel/mesh.h"
#include "ravel/result.h"

namespace ravel::tool {

Result<std::vector<std::byte>> read_bytes(const std::string& path);

// `ending` is the format of a mesh that comes by stdin; files tell it by their name.
Result<Mesh> read_mesh_input(const std::string& path, const std::string& ending);

// Does the name end in ".ravel"?
bool is_ravel_name(const std::string& path);

}  // namespace ravel::tool
