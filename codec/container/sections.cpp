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
    out.raw(stored);
}

Result<Section> read_section(ByteReader& in) {
    Section section;
    const auto start = in.at();
    const std::uint8_t id = in.u8();
    if (!in.ok())
        return Error{Code::truncated, start, "the file ends where a section should begin"};
    section.id = static_cast<SectionId>(id);
    if (section.id == SectionId::end) return section;
    const std::uint64_t size = in.varint();
    section.packed = (size & 1) != 0;
    section.raw_size = section.packed ? in.varint() : size >> 1;
    section.at = in.at();
    section.bytes = in.raw(size >> 1);
    if (!in.ok())
        return Error{Code::truncated, start,
                     std::string("the file ends inside section \"") + name_of(section.id) + "\""};
    return section;
}

void write_end(ByteWriter& out) {
    out.u8(static_cast<std::uint8_t>(SectionId::end));
    out.u32(crc32c(out.bytes()));
}

Status check_end(std::span<const std::byte> file, std::uint64_t at) {
    ByteReader in(file.subspan(static_cast<std::size_t>(at)), at);
    const std::uint32_t checksum = in.u32();
    if (!in.ok()) return Error{Code::truncated, in.at(), "the file ends before its checksum does"};
    if (crc32c(file.first(static_cast<std::size_t>(at))) != checksum)
        return Error{Code::checksum_mismatch, at,
                     "the file is damaged: its checksum is that of other bytes"};
    if (in.left() != 0)
        return Error{Code::corrupt, in.at(),
                     std::to_string(in.left()) + " bytes follow the end of the file"};
    return Done{};
}

}  // namespace ravel
