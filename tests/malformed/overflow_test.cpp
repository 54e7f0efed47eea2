// Numbers as large as a varint holds, wherever a file has a number: no product of them wraps,
// nothing is taken for them.
#include "malformed/victims.h"

#include <chrono>

#include "make/random.h"

using namespace ravel;

namespace {

const std::uint64_t kLarge[] = {0x7FFFFFFFu,         0x80000000u,         0xFFFFFFFFu,
                                0x100000000u,        0x2000000000000000u, 0x4000000000000001u,
                                0x7FFFFFFFFFFFFFFFu, 0x8000000000000000u, 0xFFFFFFFFFFFFFFFFu};

// Every varint of a section replaced, one at a time: wherever a byte could begin one.
void with_large_numbers(const test::Victim& v, SectionId id) {
    const auto parts = *test::take_apart(v.file);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (parts[p].id != id) continue;
        for (std::size_t at = 0; at < parts[p].raw.size(); ++at)
            for (const std::uint64_t large : kLarge) {
                std::size_t end = at;
                while (end + 1 < parts[p].raw.size() &&
                       (parts[p].raw[end] & std::byte{0x80}) != std::byte{0})
                    ++end;
                ByteWriter raw;
                raw.raw(std::span(parts[p].raw).first(at));
                raw.varint(large);
                raw.raw(std::span(parts[p].raw).subspan(end + 1));
                auto bad = parts;
                bad[p].raw = raw.take();
                DecodeOptions options;
                options.memory_limit = std::uint64_t{64} << 20;
                INFO(v.name << ", " << name_of(id) << " byte " << at << " is " << large);
                REQUIRE(test::unsafe(test::put_together(bad), options) == "");
            }
    }
}

}  // namespace

TEST_CASE("numbers of any size in any section give an error or a mesh") {
    EncodeOptions ordered, grid;
    ordered.keep_order = true;
    grid.position_bits = 9;
    for (const auto& v : {test::victim("tets:box=1,attributes,companions", ordered),
                          test::victim("polygons:mixed,size=2x2,attributes", grid),
                          test::victim("soup:tets=4,seed=2,attributes", ordered)})
        for (const SectionId id : {SectionId::head, SectionId::block, SectionId::companions,
                                   SectionId::attributes, SectionId::names, SectionId::order})
            with_large_numbers(v, id);
}

TEST_CASE("counts whose products wrap are refused") {
    const auto tets = test::victim("tiny:two-tets"), quads = test::victim("tiny:cube");
    for (const std::uint64_t n : kLarge) {
        CHECK(test::code_of(test::with_block_head(tets.file, tets.kind, [&](BlockHead& b) {
                  b.cells = n, b.corners = 4 * n;
              })) != Code::bad_mesh);
        CHECK_FALSE(decode(test::with_block_head(quads.file, quads.kind, [&](BlockHead& b) {
                        b.uniform_degree = n, b.corners = n * b.cells;
                    })).ok());
        CHECK_FALSE(decode(test::with_block_head(quads.file, quads.kind, [&](BlockHead& b) {
                        b.uniform_degree = 0, b.corners = n;
                    })).ok());
        CHECK_FALSE(decode(test::with_block_head(quads.file, quads.kind, [&](BlockHead& b) {
                        b.unused_points = n;
                    })).ok());
    }
    const auto rich = test::victim("tets:box=1,attributes,companions");
    for (const std::uint64_t n : kLarge) {
        INFO(n);
        CHECK_FALSE(decode(test::with_head(rich.file, [&](Head& h) {
                        for (AttributeHead& a : h.attributes) a.tuples = n;
                    })).ok());
        CHECK_FALSE(decode(test::with_head(rich.file, [&](Head& h) {
                        for (AttributeHead& a : h.attributes) a.tuples = n, a.arity = 65535;
                    })).ok());
    }
}

TEST_CASE("a text longer than its section is refused") {
    const auto v = test::victim("tiny:cube");
    for (const std::uint64_t size : kLarge) {
        const Bytes bad = test::with_section(v.file, SectionId::names, [&](Bytes& raw) {
            ByteWriter out;
            out.varint(1);
            out.varint(size);
            out.raw(Bytes(50, std::byte{'a'}));
            raw = out.take();
        });
        CHECK(test::code_of(bad) == Code::corrupt);
    }
}

TEST_CASE("pieces of a section cut out, doubled, moved or turned round give an error or a mesh") {
    make::Random random{77};
    for (const auto& v : test::victims()) {
        const auto parts = *test::take_apart(v.file);
        for (std::size_t p = 0; p < parts.size(); ++p)
            for (int i = 0; i < 60 && !parts[p].raw.empty(); ++i) {
                auto bad = parts;
                Bytes& raw = bad[p].raw;
                const std::size_t from = random.below(raw.size());
                const std::size_t to = from + 1 + random.below(raw.size() - from);
                const Bytes piece(raw.begin() + static_cast<std::ptrdiff_t>(from),
                                  raw.begin() + static_cast<std::ptrdiff_t>(to));
                const auto what = random.below(4);
                if (what == 3)
                    std::reverse(raw.begin() + static_cast<std::ptrdiff_t>(from),
                                 raw.begin() + static_cast<std::ptrdiff_t>(to));
                if (what == 0 || what == 2)
                    raw.erase(raw.begin() + static_cast<std::ptrdiff_t>(from),
                              raw.begin() + static_cast<std::ptrdiff_t>(to));
                if (what == 1 || what == 2) {
                    const auto at = static_cast<std::ptrdiff_t>(random.below(raw.size() + 1));
                    raw.insert(raw.begin() + at, piece.begin(), piece.end());
                }
                INFO(v.name << ", " << name_of(bad[p].id) << ", piece " << i);
                REQUIRE(test::unsafe(test::put_together(bad)) == "");
            }
    }
}

TEST_CASE("random codes for many cells take time in proportion to the bytes") {
    // Far above what any of them takes, far below what one quadratic step would.
    for (const char* recipe : {"tets:box=16,jitter=0.2", "torus:quads=40000", "soup:tets=8000"}) {
        const auto v = test::victim(recipe);
        auto parts = *test::take_apart(v.file);
        for (std::uint64_t seed = 0; seed < 12; ++seed) {
            make::Random random{seed};
            for (auto& part : parts)
                if (part.id == SectionId::connectivity)
                    for (std::byte& b : part.raw)
                        if (seed % 3 != 0 || random.one_in(500))
                            b = seed % 3 == 1 ? std::byte{0xFF}
                                              : static_cast<std::byte>(random.next());
            const auto start = std::chrono::steady_clock::now();
            INFO(recipe << ", seed " << seed);
            REQUIRE(test::unsafe(test::put_together(parts)) == "");
            CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
        }
    }
}
