// The viewer's page, which tools/viewer/build makes, and what it is given to show.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "ravel/report.h"
#include "ravel/result.h"

namespace ravel::tool {

// The page with `data` in it: {"files": [{"name", "data" (base64) or "url", "rows"}], "summary"}.
// Unreadable where the page was not built; the sentence says how it is.
Result<std::string> viewer_page(const Json& data);

std::string base64_of(std::span<const std::byte> bytes);

}  // namespace ravel::tool
