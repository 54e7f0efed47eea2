#include "spec/trace.h"

#include "container/sections.h"
#include "entropy/pack.h"
#include "ravel/ravel.h"
#include "spec/tell_fields.h"
#include "spec/tell_mesh.h"
#include "spec/tell_walk.h"

namespace ravel::test {

Trace trace_of(std::span<const std::byte> file, const TraceLimits& limits) {
    Trace trace;
    std::string& out = trace.text;
    const auto broken = [&](const std::string& why) {
        out += "broken: " + why + "\n";
        return trace;
    };
    constexpr std::size_t kMaskAt = kMagic.size() + 1;
    if (file.size() <= kMaskAt) return broken("the file ends before its sections");
    const auto mask = static_cast<SectionMask>(file[kMaskAt]);
    out = "0  " + hex(file.subspan(0, kMaskAt)) + "  magic, version\n" + std::to_string(kMaskAt) +
          "  " + hex(file.subspan(kMaskAt, 1)) + "  sections\n";
    ByteReader in(file.subspan(kMaskAt + 1));
    Head head;
    BlockHead block;
    PositionFormat format;
    Bytes connectivity, positions;
    std::size_t bits_at = 0;
    for (std::size_t i = 0; i < kSections; ++i) {
        const auto id = static_cast<SectionId>(i);
        if (!has_section(mask, id)) continue;
        const std::size_t at = file.size() - in.left();
        const Result<Section> section = read_section(in, id);
        if (!section) return broken(section.error().detail);
        const std::size_t end = file.size() - in.left();
        out += std::to_string(at) + "  " + hex(file.subspan(at, end - at - section->bytes.size())) +
               "  section " + name_of(section->id) + ", " + std::to_string(section->bytes.size()) +
               " bytes" +
               (section->packed ? ", unpacked " + std::to_string(section->raw_size) : "") + "\n";
        Bytes raw(section->bytes.begin(), section->bytes.end());
        if (section->packed) {
            out += "  packed: " + data_hex(raw) + "\n";
            Result<Bytes> unpacked = unpack(section->bytes, section->raw_size, at);
            if (!unpacked) return broken(unpacked.error().detail);
            raw = std::move(*unpacked);
        }
        Fields fields(raw, out);
        ByteReader again(raw);
        switch (section->id) {
            case SectionId::head:
                tell_head(fields);
                head = *read_head(again);
                break;
            case SectionId::block:
                tell_block(fields, head.kind == CellKind::tet);
                block = *read_block_head(again, head.kind);
                break;
            case SectionId::positions: {
                format = tell_position_head(fields, head, block);
                const auto rest = fields.rest();
                bits_at = raw.size() - rest.size();
                out += "  +" + std::to_string(bits_at) + "  " + data_hex(rest) + "  bits\n";
                positions = raw;
                break;
            }
            case SectionId::connectivity:
                connectivity = raw;
                [[fallthrough]];
            default:
                out += "  +0  " + data_hex(raw) + "\n";
        }
    }
    out +=
        "\nthe walk, as it is read from connectivity (c) and positions (p)\n"
        "  flags: context, class, bits of a run that starts here, answer\n"
        "  plain bits: how many, bits, value\n";
    const std::string wrong = tell_walk(head, block, connectivity, format,
                                        std::span(positions).subspan(bits_at), trace, limits);
    if (!wrong.empty()) return broken(wrong);
    DecodeOptions options;
    options.steps = true;
    const Result<Decoded> decoded = decode(file, options);
    if (!decoded) return broken(decoded.error().detail);
    tell_mesh(*decoded, limits.mesh_cells, out);
    trace.sound = true;
    return trace;
}

}  // namespace ravel::test
