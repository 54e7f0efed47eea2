// Rows of the comparison as a report, and what they come to.
#pragma once

#include <string>
#include <vector>

#include "compare/compare.h"
#include "ravel/report.h"

namespace ravel::tool {

Json json_rows(const std::vector<compare::Row>& rows);

// What the viewer shows (see viewer_page.h): each mesh that ravel packed, with its rows.
Json viewer_data(const std::vector<compare::Row>& rows, const Json& facts,
                 const std::string& summary);

// Geometric means per kind of cell and codec, then ravel's ratio to each peer that matters, mesh by
// mesh, with the meshes where ravel is not smaller.
std::string summary_of(const std::vector<compare::Row>& rows);

}  // namespace ravel::tool
