// Sections out and in. Packing itself is the entropy room's; this room frames and checks.
#pragma once

#include <functional>
#include <span>

#include "base/bytes.h"
#include "container/layout.h"

namespace ravel {

// `packed` must be what `raw` packs to; the smaller of both is stored.
void write_section(ByteWriter& out, SectionId id, std::span<const std::byte> raw,
                   std::span<const std::byte> packed);

struct Section {
    SectionId id = SectionId::end;
    std::uint64_t at = 0;  // offset of its bytes in the file
    bool packed = false;
    std::uint64_t raw_size = 0;
    std::span<const std::byte> bytes;
};

// The next section's header and bytes, whatever its id. Fails only where the bytes end.
Result<Section> read_section(ByteReader& in);

// After the last section.
void write_end(ByteWriter& out);
// All of a file up to the end of its last section, `at` bytes: does the checksum that follows say
// it is what was written? Linear.
Status check_end(std::span<const std::byte> file, std::uint64_t at);

}  // namespace ravel
