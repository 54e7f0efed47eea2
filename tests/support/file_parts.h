// A ravel file taken apart into sections with their unpacked bytes, and put together again with
// checksums that fit: so that an attack gets behind them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "container/head.h"
#include "container/layout.h"
#include "ravel/ravel.h"

namespace ravel::test {

struct FilePart {
    SectionId id = SectionId::head;
    Bytes raw;
};

// Without looking at checksums; nothing where the bytes are no sequence of sections, or unpack to
// more than 16 MiB.
std::optional<std::vector<FilePart>> take_apart(std::span<const std::byte> file);

// What a file says of which sections it has.
SectionMask mask_of(const std::vector<FilePart>& parts);

// Meant for parts in the order of their ids, each once; others make files that are invalid. Stored
// unpacked where `level` is 0.
Bytes put_together(const std::vector<FilePart>& parts, int level = 0);

// A file whose block head was changed.
template <class Change>
Bytes with_block_head(const Bytes& file, CellKind kind, const Change& change) {
    auto parts = take_apart(file);
    for (FilePart& part : *parts) {
        if (part.id != SectionId::block) continue;
        ByteReader in(part.raw);
        auto block = read_block_head(in, kind);
        change(*block);
        part.raw = write_block_head(*block, kind);
    }
    return put_together(*parts);
}

template <class Change>
Bytes with_head(const Bytes& file, const Change& change) {
    auto parts = take_apart(file);
    for (FilePart& part : *parts) {
        if (part.id != SectionId::head) continue;
        ByteReader in(part.raw);
        auto head = read_head(in);
        change(*head);
        part.raw = write_head(*head);
    }
    return put_together(*parts);
}

// A file with one section's bytes changed, or with a section it did not have.
template <class Change>
Bytes with_section(const Bytes& file, SectionId id, const Change& change) {
    auto parts = take_apart(file);
    auto at = parts->begin();
    while (at != parts->end() && at->id < id) ++at;
    if (at == parts->end() || at->id != id) at = parts->insert(at, FilePart{id, {}});
    change(at->raw);
    return put_together(*parts);
}

// What must hold for any bytes: they give an error or a mesh with one step per cell, all of it
// within its own bounds. Empty, or what does not hold.
std::string unsafe(std::span<const std::byte> file, const DecodeOptions& options = {});

}  // namespace ravel::test
