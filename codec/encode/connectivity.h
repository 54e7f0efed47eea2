// The section of the walk's answers: as they were coded when the walk was made, or by their
// precedents where that is smaller.
#pragma once

#include "base/bytes.h"
#include "container/head.h"
#include "encode/walk_driver.h"

namespace ravel {

struct Connectivity {
    Bytes bytes;  // not packed yet
    double ideal_bits = 0;
};

// Sets `block.has_precedents`. `answers`: of a surface; none of a block that is to have no
// precedents. `others`: bytes of the positions, packed; `level`: zstd's. Linear.
Connectivity choose_connectivity(const WalkCodes& codes, const Answers& answers, std::size_t others,
                                 int level, BlockHead& block);

}  // namespace ravel
