// Each error code for what it is meant for.
#include "malformed/victims.h"

#include <cmath>

#include "base/checksum.h"
#include "container/sections.h"
#include "entropy/pack.h"
#include "support/same_mesh.h"

using namespace ravel;
using test::code_of;

TEST_CASE("nothing, other files and text are no ravel files") {
    CHECK(code_of({}) == Code::not_a_ravel_file);
    CHECK(code_of(Bytes(1000, std::byte{0})) == Code::not_a_ravel_file);
    Bytes bytes = test::victim("tiny:cube").file;
    bytes[0] ^= std::byte{1};
    CHECK(code_of(bytes) == Code::not_a_ravel_file);
}

TEST_CASE("another version is unsupported, and the error says which") {
    Bytes bytes = test::victim("tiny:cube").file;
    bytes[4] = std::byte{77};
    CHECK(code_of(bytes) == Code::unsupported_version);
    CHECK(decode(bytes).error().detail.find("77") != std::string::npos);
}

TEST_CASE("a file that ends behind its magic is truncated there") {
    Bytes bytes = test::victim("tiny:cube").file;
    bytes.resize(kMagic.size());
    const auto decoded = decode(bytes);
    REQUIRE_FALSE(decoded.ok());
    CHECK(decoded.error().code == Code::truncated);
    CHECK(decoded.error().at == kMagic.size());
    CHECK(inspect(bytes).error().code == Code::truncated);
}

TEST_CASE("a file without its last byte is truncated, at the place where it ends") {
    Bytes bytes = test::victim("tiny:cube").file;
    bytes.pop_back();
    const auto decoded = decode(bytes);
    REQUIRE_FALSE(decoded.ok());
    CHECK(decoded.error().code == Code::truncated);
    CHECK(decoded.error().at == bytes.size());
}

TEST_CASE("a damaged file is a checksum mismatch, for whoever reads its heads, too") {
    const Bytes file = test::victim("tiny:cube").file;
    Bytes bad = file;
    bad[bad.size() - 7] ^= std::byte{4};
    CHECK(code_of(bad) == Code::checksum_mismatch);
    CHECK(inspect(bad).error().code == Code::checksum_mismatch);
}

TEST_CASE("links other than there are are corrupt where the strip is read, and only there") {
    for (const char* recipe : {"torus:size=12x12", "tets:box=3"}) {
        const test::Victim v = test::victim(recipe);
        for (const std::uint64_t more : {std::uint64_t{1}, std::uint64_t{3}}) {
            const Bytes bad = test::with_block_head(v.file, v.kind,
                                                    [&](BlockHead& block) { block.links += more; });
            CHECK(code_of(bad) == Code::corrupt);
            const auto decoded = decode(bad);
            REQUIRE(decoded.ok());
            CHECK(test::difference(decoded->mesh, decode(v.file)->mesh).empty());
        }
    }
}

TEST_CASE("a kept order of 2^30 companions is corrupt, whatever each of them weighs") {
    EncodeOptions ordered;
    ordered.keep_order = true;
    const test::Victim v = test::victim("tiny:quad", ordered);
    const Bytes with_block = test::with_section(
        test::with_block_head(v.file, v.kind, [](BlockHead& block) { block.companions = 1; }),
        SectionId::companions, [](Bytes& raw) {
            ByteWriter out;
            out.varint(1);
            out.varint(7);  // polygons of no nodes
            out.varint(0);
            out.varint(std::uint64_t{1} << 30);
            out.u8(0);
            raw = out.take();
        });
    const Bytes bad = test::with_section(with_block, SectionId::order, [](Bytes& raw) {
        raw.insert(raw.begin() + 1, std::byte{0});
    });
    const auto decoded = decode(bad);
    REQUIRE_FALSE(decoded.ok());
    CHECK(decoded.error().code == Code::corrupt);
    CHECK(decoded.error().detail.find("order") != std::string::npos);
}

TEST_CASE("decode refuses bytes after the last section") {
    Bytes bytes = test::victim("tiny:cube").file;
    bytes.push_back(std::byte{0});
    CHECK(code_of(bytes) == Code::corrupt);
    CHECK_FALSE(inspect(bytes).ok());
}

TEST_CASE("sections of an unknown kind are corrupt") {
    const auto parts = *test::take_apart(test::victim("tiny:cube").file);
    for (const unsigned unknown : {16u, 128u, 240u}) {
        ByteWriter out;
        write_start(out, static_cast<SectionMask>(test::mask_of(parts) | unknown));
        for (const auto& part : parts) write_section(out, part.raw, {});
        write_end(out);
        CHECK(code_of(out.bytes()) == Code::corrupt);
    }
}

TEST_CASE("a mesh larger than the limit is refused as such") {
    DecodeOptions options;
    options.memory_limit = 1000;
    CHECK(code_of(test::victim("torus:size=12x12").file, options) == Code::limit_exceeded);
    options.memory_limit = 0;
    CHECK(code_of(test::victim("tiny:empty").file, options) == Code::limit_exceeded);
}

TEST_CASE("a packed section that says it holds too much, too little or nothing is refused") {
    const auto v = test::victim("torus:size=12x12");
    const auto parts = *test::take_apart(v.file);
    for (const SectionId id :
         {SectionId::head, SectionId::block, SectionId::connectivity, SectionId::positions})
        for (const std::uint64_t beyond : {std::uint64_t{1}, ~std::uint64_t{0},
                                           std::uint64_t{1} << 33, std::uint64_t{1} << 63}) {
            ByteWriter out;
            write_start(out, test::mask_of(parts));
            for (const auto& part : parts) {
                if (part.id != id) {
                    write_section(out, part.raw, {});
                    continue;
                }
                const Bytes packed = pack(part.raw, 3);
                out.varint(std::uint64_t{packed.size()} << 1 | 1);
                out.varint(part.raw.size() + beyond);
                out.raw(packed);
            }
            write_end(out);
            INFO(name_of(id) << " claims " << beyond << " more");
            const Code code = code_of(out.bytes());
            CHECK((code == Code::corrupt || code == Code::limit_exceeded));
        }
}

TEST_CASE("the size of a section can't wrap around") {
    for (const std::uint64_t size :
         {~std::uint64_t{0}, ~std::uint64_t{0} - 1, std::uint64_t{1} << 63}) {
        ByteWriter out;
        out.raw(kMagic);
        out.u8(kVersion);
        out.u8(1);
        out.varint(size);
        out.varint(3);
        out.u32(0);
        out.u32(0);
        CHECK(code_of(out.bytes()) == Code::truncated);
    }
}

TEST_CASE("heads and sections that contradict each other are corrupt") {
    const auto v = test::victim("tets:box=2x1x1,attributes,companions");
    CHECK(code_of(test::with_head(v.file, [](Head& h) { h.keeps_order = true; })) == Code::corrupt);
    CHECK(code_of(test::with_head(v.file, [](Head& h) { h.attributes.clear(); })) == Code::corrupt);
    CHECK(code_of(test::with_block_head(v.file, v.kind, [](BlockHead& b) { b.companions = 0; })) ==
          Code::corrupt);
    CHECK(code_of(test::with_block_head(v.file, v.kind, [](BlockHead& b) { b.companions = 9; })) ==
          Code::corrupt);
}

TEST_CASE("counts that the walk does not confirm are corrupt") {
    const auto v = test::victim("torus:size=6x4");
    const auto with = [&](auto change) {
        return code_of(test::with_block_head(v.file, v.kind, change));
    };
    CHECK(with([](BlockHead& b) { ++b.components; }) == Code::corrupt);
    CHECK(with([](BlockHead& b) { ++b.links; }) == Code::corrupt);
    CHECK(with([](BlockHead& b) { ++b.unused_points; }) == Code::corrupt);
    CHECK(with([](BlockHead& b) { ++b.cells, b.corners += 4; }) == Code::corrupt);
    CHECK(with([](BlockHead& b) { --b.cells, b.corners -= 4; }) == Code::corrupt);
    CHECK(with([](BlockHead& b) { ++b.vertices, ++b.points; }) == Code::corrupt);
    CHECK(with([](BlockHead& b) { --b.vertices, --b.points; }) == Code::corrupt);
}

TEST_CASE("points of edges that there can't be are corrupt") {
    const auto v = test::victim("tets:box=2x1x1", {}, true);
    const auto with = [&](auto change) {
        return code_of(test::with_block_head(v.file, v.kind, change));
    };
    CHECK(with([](BlockHead& b) { b.has_edge_points = false; }) == Code::corrupt);
    CHECK(with([](BlockHead& b) { b.unused_points = 3; }) == Code::corrupt);
    CHECK(with([](BlockHead& b) { b.unused_points += 100; }) == Code::corrupt);
    const auto surface = test::victim("torus:size=6x4");
    CHECK(code_of(test::with_block_head(surface.file, surface.kind, [](BlockHead& b) {
              b.has_edge_points = true;
          })) == Code::corrupt);
    const auto plain = test::victim("tets:box=2x1x1");
    CHECK(code_of(test::with_block_head(plain.file, plain.kind, [](BlockHead& b) {
              b.has_edge_points = true;
          })) == Code::corrupt);
    // The block of companions that follows from them: count, then type, nodes, cells, kind.
    for (const std::size_t field : {1u, 2u, 3u, 4u})
        CHECK(code_of(test::with_section(v.file, SectionId::companions, [&](Bytes& raw) {
                  raw[field] = static_cast<std::byte>(static_cast<unsigned>(raw[field]) - 1);
              })) == Code::corrupt);
}

TEST_CASE("an order that is no permutation is corrupt") {
    EncodeOptions options;
    options.keep_order = true;
    const auto v = test::victim("grid:size=3x3", options);
    for (const int byte : {0, 1, 2, 255})
        CHECK(code_of(test::with_section(v.file, SectionId::order, [&](Bytes& raw) {
                  std::fill(raw.begin(), raw.end(), static_cast<std::byte>(byte));
              })) == Code::corrupt);
}

TEST_CASE("references that no mesh may have are corrupt") {
    const auto v = test::victim("tets:box=2x1x1,attributes,companions");
    for (const std::int64_t base : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{1} << 62})
        CHECK(code_of(test::with_head(v.file, [&](Head& h) {
                  for (AttributeHead& a : h.attributes)
                      if (is_float(a.scalar)) a.references = {{0, Place::point, base}};
              })) == Code::corrupt);
}

TEST_CASE("bounds of attributes that no writer makes are corrupt") {
    const auto v = test::victim("tets:box=2x1x1,attributes,companions");
    const auto with = [&](double bound, double error, bool floats) {
        return code_of(test::with_head(v.file, [&](Head& h) {
            for (AttributeHead& a : h.attributes)
                if (is_float(a.scalar) == floats) a.bound = bound, a.error = error;
        }));
    };
    CHECK(with(1, 2, true) == Code::corrupt);
    CHECK(with(1, -1, true) == Code::corrupt);
    CHECK(with(1, std::nan(""), true) == Code::corrupt);
    CHECK(with(INFINITY, 1, true) == Code::corrupt);
    CHECK(with(1, 0.5, false) == Code::corrupt);
}

TEST_CASE("codings of attributes that this version does not know are corrupt") {
    EncodeOptions options;
    const auto v = test::victim("grid:size=5x5,attributes", options);
    // The first byte of the section tells how the first attribute is coded.
    for (const int kind : {3, 8, 0x14, 0xC8})
        CHECK(code_of(test::with_section(v.file, SectionId::attributes, [&](Bytes& raw) {
                  raw[0] = static_cast<std::byte>(kind);
              })) == Code::corrupt);
    // An order told in unknown ways.
    options.keep_order = true;
    const auto w = test::victim("grid:size=5x5", options);
    for (const int kind : {64, 128, 3, 5, 17, 24})
        CHECK(code_of(test::with_section(w.file, SectionId::order, [&](Bytes& raw) {
                  raw[0] = static_cast<std::byte>(kind);
              })) == Code::corrupt);
}
