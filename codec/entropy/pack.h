// zstd, the only general packer. The one room that knows it.
#pragma once

#include <cstdint>
#include <span>

#include "base/bytes.h"

namespace ravel {

// One zstd frame without checksum, dictionary or content size (the section header has it).
Bytes pack(std::span<const std::byte> raw, int level);

// Unpacks exactly `raw_size` bytes; the caller has checked raw_size against its limits.
Result<Bytes> unpack(std::span<const std::byte> packed, std::uint64_t raw_size, std::uint64_t at);

// Used by limits: no frame of `packed` bytes can hold more than this.
std::uint64_t most_unpacked(std::uint64_t packed);

}  // namespace ravel
