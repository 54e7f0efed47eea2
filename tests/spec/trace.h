// What a reader does with a file, field by field and flag by flag, in words of spec/format.md.
#pragma once

#include <set>
#include <span>
#include <string>

#include "container/head.h"
#include "predict/position_codes.h"

namespace ravel::test {

// How much is told of the walk, and the most cells of a mesh that is listed: of a larger one there
// are checksums.
struct TraceLimits {
    int flags = 28, cells = 3;
    Index mesh_cells = 25;
};

// Sections with their bytes, the fields of the heads, the first codes of the walk and of positions,
// the strip and the mesh. Where the file is not valid, or this reader and codec/ disagree, it is
// not sound; the last line says why.
struct Trace {
    std::string text;
    std::set<std::string> blocks;  // of contexts that were asked for: "tet kNear"
    bool sound = false;
};
Trace trace_of(std::span<const std::byte> file, const TraceLimits& limits = {});

}  // namespace ravel::test
