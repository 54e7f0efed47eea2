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
    std::uint32_t checksum = 0;
    std::span<const std::byte> bytes;
};

// The next section's header and bytes. Unknown ids are corrupt.
Result<Section> read_section(ByteReader& in);

// Are the bytes those that were written?
Status check_section(const Section& section);

}  // namespace ravel
