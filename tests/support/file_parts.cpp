#include "support/file_parts.h"

#include <algorithm>

#include "container/sections.h"
#include "entropy/pack.h"

namespace ravel::test {

std::optional<std::vector<FilePart>> take_apart(std::span<const std::byte> file) {
    if (file.size() < kMagic.size() + 2) return {};
    ByteReader in(file.subspan(kMagic.size() + 1));
    const SectionMask mask = in.u8();
    std::vector<FilePart> parts;
    for (std::size_t i = 0; i < kSections; ++i) {
        const auto id = static_cast<SectionId>(i);
        if (!has_section(mask, id)) continue;
        const Result<Section> section = read_section(in, id);
        if (!section) return {};
        FilePart part{section->id, {}};
        if (section->packed) {
            if (section->raw_size > std::uint64_t{16} << 20) return {};
            Result<Bytes> raw = unpack(section->bytes, section->raw_size, 0);
            if (!raw) return {};
            part.raw = std::move(*raw);
        } else {
            part.raw.assign(section->bytes.begin(), section->bytes.end());
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

SectionMask mask_of(const std::vector<FilePart>& parts) {
    SectionMask mask = 0;
    for (const FilePart& part : parts) mask |= bit_of(part.id);
    return mask;
}

Bytes put_together(const std::vector<FilePart>& parts, int level) {
    ByteWriter out;
    write_start(out, mask_of(parts));
    for (const FilePart& part : parts)
        write_section(out, part.raw, level > 0 ? pack(part.raw, level) : Bytes{});
    write_end(out);
    return out.take();
}

std::string unsafe(std::span<const std::byte> file, const DecodeOptions& options) {
    const Result<FileInfo> info = inspect(file);
    DecodeOptions all = options;
    all.steps = true;
    const Result<Decoded> decoded = decode(file, all);
    if (!decoded) return decoded.error().detail.empty() ? "an error without words" : "";
    if (!info) return "inspect refuses what decode takes";
    const Mesh& mesh = decoded->mesh;
    if (const Status status = check_mesh(mesh); !status)
        return "broken mesh: " + status.error().detail;
    if (info->cells != mesh.cell_count() || info->points != mesh.point_count() ||
        info->corners != mesh.corners.size())
        return "inspect counts otherwise";
    if (decoded->steps.size() != mesh.cell_count()) return "not one step per cell";
    std::vector<bool> seen(mesh.cell_count(), false);
    for (const StripStep& step : decoded->steps) {
        if (step.cell >= mesh.cell_count() || seen[step.cell]) return "a step to no new cell";
        seen[step.cell] = true;
        if (step.from == kNoIndex) continue;
        if (step.from >= mesh.cell_count() || !seen[step.from])
            return "a step from no visited cell";
        if (step.exit >= mesh.cell(step.from).size() || step.entry >= mesh.cell(step.cell).size())
            return "a step through no facet";
    }
    return {};
}

}  // namespace ravel::test
