#include "decode/file.h"

#include <algorithm>
#include <string>

#include "entropy/pack.h"

namespace ravel {

Result<Bytes> unpack_section(const Section& section, std::uint64_t& budget, std::uint64_t growth) {
    if (section.raw_size > budget / growth)
        return Error{
            Code::limit_exceeded, section.at,
            std::string("section \"") + name_of(section.id) + "\" needs more memory than allowed"};
    if (section.packed && section.raw_size > most_unpacked(section.bytes.size()))
        return Error{
            Code::corrupt, section.at,
            std::string("section \"") + name_of(section.id) + "\" can't hold as much as it says"};
    budget -= section.raw_size * growth;
    if (!section.packed) return Bytes(section.bytes.begin(), section.bytes.end());
    return unpack(section.bytes, section.raw_size, section.at);
}

namespace {

Status read_heads(FileSections& file, std::uint64_t& budget) {
    for (const SectionId id : {SectionId::head, SectionId::block}) {
        const Section& section = file[id];
        // Four bytes can ask for an attribute, which is as much here and later in the mesh.
        Result<Bytes> raw = unpack_section(section, budget, 64);
        if (!raw) return raw.error();
        ByteReader fields(*raw, section.at);
        if (id == SectionId::head) {
            Result<Head> head = read_head(fields);
            if (!head) return head.error();
            file.head = std::move(*head);
        } else {
            Result<BlockHead> block = read_block_head(fields, file.head.kind);
            if (!block) return block.error();
            file.block = *block;
        }
    }
    return Done{};
}

}  // namespace

Result<FileSections> open_file(std::span<const std::byte> bytes, std::uint64_t& budget) {
    if (bytes.size() < kMagic.size() || !std::equal(kMagic.begin(), kMagic.end(), bytes.begin()))
        return Error{Code::not_a_ravel_file, 0,
                     "this is not a ravel file (its first bytes are not \"Rav1\")"};
    ByteReader in(bytes);
    in.raw(kMagic.size());
    if (in.left() == 0)
        return Error{Code::truncated, kMagic.size(), "the file ends before its format version"};
    const std::uint8_t version = in.u8();
    if (version != kVersion)
        return Error{Code::unsupported_version, kMagic.size(),
                     std::string("format version ") + std::to_string(version) +
                         "; this program reads version " + std::to_string(kVersion)};
    FileSections file;
    const std::uint64_t mask_at = in.at();
    file.mask = in.u8();
    if (!in.ok()) return Error{Code::truncated, mask_at, "the file ends before its sections"};
    file.header_bytes = bytes.size();
    for (std::size_t i = 0; i < kSections; ++i) {
        const auto id = static_cast<SectionId>(i);
        if (!file.has(id)) continue;
        Result<Section> section = read_section(in, id);
        if (!section) return section.error();
        file.sections[i] = *section;
        if (id > SectionId::block) file.header_bytes -= section->bytes.size();
    }
    if (Status status = check_end(bytes, in.at()); !status) return status.error();
    if (file.mask > kAllSections)
        return Error{Code::corrupt, mask_at, "sections that are not known to this version"};
    if (Status status = read_heads(file, budget); !status) return status.error();
    if (file.has(SectionId::order) != file.head.keeps_order)
        return Error{Code::corrupt, bytes.size(),
                     "the head and the section \"order\" contradict each other"};
    return file;
}

Result<FileInfo> inspect(std::span<const std::byte> bytes) {
    std::uint64_t budget = std::uint64_t{1} << 30;
    Result<FileSections> file = open_file(bytes, budget);
    if (!file) return file.error();
    const Head& head = file->head;
    const BlockHead& block = file->block;
    FileInfo info;
    info.version = kVersion;
    info.kind = head.kind;
    info.points = block.points + block.unused_points;
    info.cells = block.cells;
    info.corners = block.corners;
    info.companions = block.companions;
    info.components = block.components;
    info.links = block.links;
    info.wants_mending = block.wants_mending;
    info.position_scalar = head.position_scalar;
    info.lossless_positions = head.lossless;
    info.keeps_order = head.keeps_order;
    info.position_bits = head.position_bits;
    info.grid_step = head.lossless ? 0 : head.step;
    info.position_bound = head.bound;
    info.position_error = head.error;
    info.file_bytes = bytes.size();
    info.header_bytes = file->header_bytes;
    for (const Section& section : file->sections)
        if (section.id > SectionId::block && section.id < SectionId::count)
            info.sections.push_back({name_of(section.id), section.bytes.size(), section.raw_size});
    for (const AttributeHead& a : head.attributes)
        info.attributes.push_back({a.name, a.place, a.scalar, a.arity, a.bound, a.error});
    return info;
}

}  // namespace ravel
