// The head of the section `positions`, and what the mesh gets of the values behind it.
#pragma once

#include <vector>

#include "base/bytes.h"
#include "container/head.h"
#include "decode/walk_driver.h"
#include "ravel/result.h"

namespace ravel {

// Errors: corrupt, truncated.
Result<PositionFormat> read_position_format(ByteReader& in, const Head& head);

// Coordinates of vertices that are points of their own, then of unused points; `points` of them in
// all. `copy_of`: per vertex the earlier one at the same point, or kNone; empty where there are
// none. Linear.
Array positions_of(const Head& head, const PositionCodes<ReadingCoder>& codes,
                   const std::vector<Id>& copy_of, std::size_t points);

}  // namespace ravel
