#include "container/sections.h"

#include "base/checksum.h"

namespace ravel {

void write_section(ByteWriter& out, SectionId id, std::span<const std::byte> raw,
                   std::span<const std::byte> packed) {
    const bool use_packed = !packed.empty() && packed.size() + 2 < raw.size();
    const auto stored = use_packed ? packed : raw;
    out.u8(static_cast<std::uint8_t>(id));
    out.varint(std::uint64_t{stored.size()} << 1 | (use_packed ? 1 : 0));
    if (use_packed) out.varint(raw.size());
    out.u32(crc32c(stored));
    out.raw(stored);
}

Result<Section> read_section(ByteReader& in) {
    Section section;
    const auto start = in.at();
    const std::uint8_t id = in.u8();
    if (!in.ok())
        return Error{Code::truncated, start, "the file ends where a section should begin"};
    if (id > kLastSection)
        return Error{
            Code::corrupt, start,
            std::string("section ") + std::to_string(id) + " is not known to this version"};
    section.id = static_cast<SectionId>(id);
    if (section.id == SectionId::end) return section;
    const std::uint64_t size = in.varint();
    section.packed = (size & 1) != 0;
    section.raw_size = section.packed ? in.varint() : size >> 1;
    section.checksum = in.u32();
    section.at = in.at();
    section.bytes = in.raw(size >> 1);
    if (!in.ok())
        return Error{Code::truncated, start,
                     std::string("the file ends inside section \"") + name_of(section.id) + "\""};
    return section;
}

Status check_section(const Section& section) {
    if (crc32c(section.bytes) == section.checksum) return Done{};
    return Error{Code::checksum_mismatch, section.at,
                 std::string("section \"") + name_of(section.id) + "\" is damaged"};
}

}  // namespace ravel
