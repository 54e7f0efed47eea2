// Rows 1 to 13 of chapter 14.
#include "container/sections.h"
#include "spec/invalid_maker.h"

namespace ravel::test {
namespace {

// A zstd frame with one raw block: the same bytes with every version of the library.
Bytes frame_of(const Bytes& raw) {
    ByteWriter out;
    out.u32(0xFD2FB528u);
    out.u8(0x20);  // one segment, its size in a byte
    out.u8(static_cast<std::uint8_t>(raw.size()));
    const auto head = static_cast<std::uint32_t>(raw.size() << 3 | 1);  // the last block, raw
    for (int i = 0; i < 3; ++i) out.u8(static_cast<std::uint8_t>(head >> (8 * i)));
    out.raw(raw);
    return out.take();
}

std::vector<FilePart> parts_of(const Bytes& file) {
    auto parts = take_apart(file);
    if (!parts) throw std::runtime_error("a file that can't be taken apart");
    return std::move(*parts);
}

// With one section stored as `write` does it.
template <class Write>
Bytes with_stored(const Bytes& file, SectionId id, const Write& write) {
    ByteWriter out;
    const std::vector<FilePart> parts = parts_of(file);
    write_start(out, mask_of(parts));
    for (const FilePart& part : parts) {
        if (part.id == id)
            write(out, part.raw);
        else
            write_section(out, part.raw, {});
    }
    write_end(out);
    return out.take();
}
void store(ByteWriter& out, const Bytes& stored, std::uint64_t raw_size) {
    out.varint(std::uint64_t{stored.size()} << 1 | 1);
    out.varint(raw_size);
    out.raw(stored);
}

}  // namespace

void InvalidMaker::container() {
    constexpr SectionId kBlock = SectionId::block;
    Bytes file = quads();
    file[3] = byte('2');
    add(1, "magic", "the fourth byte is 32", file, Code::not_a_ravel_file);
    add(1, "short", "three bytes", {byte('R'), byte('a'), byte('v')}, Code::not_a_ravel_file);
    file = quads();
    file[4] = byte(0);
    add(2, "version-0", "version 0", file, Code::unsupported_version);
    file.resize(4);
    add(3, "no-version", "nothing behind the magic", file, Code::truncated);
    file = quads();
    file.pop_back();
    add(3, "in-checksum", "the checksum is cut", file, Code::truncated);
    file.resize(file.size() - 4);
    add(3, "in-bytes", "the bytes of positions are cut", file, Code::truncated);
    file.resize(6);
    add(3, "in-a-head", "the size of head is missing", file, Code::truncated);
    file.resize(5);
    add(3, "no-sections", "nothing behind the version", file, Code::truncated);
    file = quads();
    file[6] = byte(0x80);
    file[7] = byte(0);
    add(4, "size", "the size of head is 80 00", file, Code::truncated);
    ByteWriter sixteen;
    write_start(sixteen, kAllSections + 1);
    for (const FilePart& part : parts_of(quads())) write_section(sixteen, part.raw, {});
    write_end(sixteen);
    add(5, "sections", "sections is 16", sixteen.take());
    file = quads();
    file.push_back(byte(0));
    add(7, "more", "a byte behind the checksum", file);
    add(9, "order", "an order that head does not announce",
        raw_changed("two-quads", SectionId::order, [](Bytes& raw) { raw.resize(6); }));
    add(9, "no-attributes", "attributes are announced and missing", [&] {
        auto all = parts_of(valid("attributes"));
        std::erase_if(all, [](const FilePart& p) { return p.id == SectionId::attributes; });
        return put_together(all);
    }());
    add(9, "no-companions", "companions are announced and missing", [&] {
        auto all = parts_of(valid("companions"));
        std::erase_if(all, [](const FilePart& p) { return p.id == SectionId::companions; });
        return put_together(all);
    }());
    file = quads();
    file[file.size() - 7] ^= byte(1);
    add(10, "bit", "a bit of positions is flipped", file, Code::checksum_mismatch);
    add(11, "no-frame", "block is packed, but no frame",
        with_stored(quads(), kBlock,
                    [](ByteWriter& out, const Bytes& raw) { store(out, raw, 8); }));
    add(11, "two-frames", "block is packed as two frames",
        with_stored(quads(), kBlock, [](ByteWriter& out, const Bytes& raw) {
            Bytes twice = frame_of({raw.begin(), raw.begin() + 4});
            const Bytes more = frame_of({raw.begin() + 4, raw.end()});
            twice.insert(twice.end(), more.begin(), more.end());
            store(out, twice, raw.size());
        }));
    add(11, "cut-frame", "the frame of block lacks its last byte",
        with_stored(quads(), kBlock, [](ByteWriter& out, const Bytes& raw) {
            Bytes frame = frame_of(raw);
            frame.pop_back();
            store(out, frame, raw.size());
        }));
    add(12, "less", "the frame of block unpacks to less than raw_size",
        with_stored(quads(), kBlock, [](ByteWriter& out, const Bytes& raw) {
            store(out, frame_of(raw), raw.size() + 1);
        }));
    add(12, "more", "the frame of block unpacks to more than raw_size",
        with_stored(quads(), kBlock, [](ByteWriter& out, const Bytes& raw) {
            store(out, frame_of(raw), raw.size() - 1);
        }));
    add(12, "much-more", "raw_size is above what the bytes can hold",
        with_stored(quads(), kBlock, [](ByteWriter& out, const Bytes& raw) {
            store(out, frame_of(raw), std::uint64_t{131072} * (raw.size() / 4 + 8));
        }));
    for (const SectionId id : {SectionId::head, SectionId::block})
        add(13, (std::string("more-") + name_of(id)).c_str(), "a byte too many",
            raw_changed("two-quads", id, [](Bytes& raw) { raw.push_back(byte(0)); }));
    add(13, "less", "block lacks its last byte",
        raw_changed("two-quads", kBlock, [](Bytes& raw) { raw.pop_back(); }));
    add(13, "varint", "links is 80 00", raw_changed("two-quads", kBlock, [](Bytes& raw) {
            raw.back() = byte(8);
            raw.push_back(byte(0x80));
            raw.push_back(byte(0));
        }));
}

}  // namespace ravel::test
