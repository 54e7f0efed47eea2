// Tables 1 and 2 of [DiazGopi2005], with our rows next to the paper's.
#pragma once

#include <string>

#include "ravel/mesh.h"
#include "ravel/report.h"
#include "ravel/result.h"

namespace ravel::tool {

// Adds to `rows` the paper's model of like size, if there is one (within a quarter more or less),
// and our strips of the mesh: by the paper's method with fans only, by ours in full.
Status add_table_rows(const std::string& model, const Mesh& mesh, Json& rows);

// The columns of the paper's table for a kind.
std::vector<std::string> table_columns(CellKind kind);

}  // namespace ravel::tool
