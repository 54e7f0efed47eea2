// Sections out and in. Packing itself is the entropy room's; this room frames and checks.
#pragma once

#include <functional>
#include <span>

#include "base/bytes.h"
#include "container/layout.h"

namespace ravel {

// What stands before the first section.
void write_start(ByteWriter& out, SectionMask mask);
// `packed` must be what `raw` packs to; the smaller of both is stored.
void write_section(ByteWriter& out, std::span<const std::byte> raw,
                   std::span<const std::byte> packed);

struct Section {
    SectionId id = SectionId::count;
    std::uint64_t at = 0;  // offset of its bytes in the file
    bool packed = false;
    std::uint64_t raw_size = 0;
    std::span<const std::byte> bytes;
};

// The next section's header and bytes, `id` being which it is. Fails only where the bytes end.
Result<Section> read_section(ByteReader& in, SectionId id);

// After the last section.
void write_end(ByteWriter& out);
// All of a file up to the end of its last section, `at` bytes: does the checksum that follows say
// it is what was written? Linear.
Status check_end(std::span<const std::byte> file, std::uint64_t at);

}  // namespace ravel
