#include "container/sections.h"

#include "base/checksum.h"

namespace ravel {

void write_start(ByteWriter& out, SectionMask mask) {
    out.raw(kMagic);
    out.u8(kVersion);
    out.u8(mask);
}

void write_section(ByteWriter& out, std::span<const std::byte> raw,
                   std::span<const std::byte> packed) {
    const bool use_packed = !packed.empty() && packed.size() + 2 < raw.size();
    const auto stored = use_packed ? packed : raw;
    out.varint(std::uint64_t{stored.size()} << 1 | (use_packed ? 1 : 0));
    if (use_packed) out.varint(raw.size());
    out.raw(stored);
}

Result<Section> read_section(ByteReader& in, SectionId id) {
    Section section;
    section.id = id;
    const auto start = in.at();
    const char* const where = in.left() == 0 ? "before" : "inside";
    const std::uint64_t size = in.varint();
    section.packed = (size & 1) != 0;
    section.raw_size = section.packed ? in.varint() : size >> 1;
    section.at = in.at();
    section.bytes = in.raw(size >> 1);
    if (!in.ok())
        return Error{Code::truncated, start,
                     std::string("the file ends ") + where + " section \"" + name_of(id) + "\""};
    return section;
}

void write_end(ByteWriter& out) {
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
