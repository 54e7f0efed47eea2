// The walk and the positions of a file, read and told flag by flag.
#pragma once

#include "spec/trace.h"

namespace ravel::test {

// Adds to the trace; empty, or what is wrong with the streams.
std::string tell_walk(const Head& head, const BlockHead& block, const Bytes& connectivity,
                      const PositionFormat& format, std::span<const std::byte> position_bits,
                      Trace& trace, const TraceLimits& limits);

}  // namespace ravel::test
