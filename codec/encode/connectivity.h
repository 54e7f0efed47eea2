// The section of the walk's answers: as they were coded when the walk was made, or by their
// precedents where that is smaller.
#pragma once

#include <future>

#include "base/bytes.h"
#include "container/head.h"
#include "encode/walk_driver.h"

namespace ravel {

struct Connectivity {
    Bytes bytes;  // not packed yet
    double ideal_bits = 0;
};

// `answers` of a surface by their precedents. Linear.
Connectivity by_precedents(const Answers& answers, const BlockHead& block);

// Sets `block.has_precedents`. `told`: what by_precedents returned, asked for only where it may
// matter; none of a block that is to have no precedents. `others`: bytes of the positions, packed;
// `level`: zstd's.
Connectivity choose_connectivity(const WalkCodes& codes, std::future<Connectivity> told,
                                 std::size_t others, int level, BlockHead& block);

}  // namespace ravel
