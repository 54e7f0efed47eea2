// No file makes the decoder take more memory than the caller allows, nor much more than it has
// bytes for. operator new is replaced to keep the count.
#include "malformed/victims.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include "entropy/pack.h"

namespace {

std::atomic<std::size_t> live{0}, peak{0};

// The size stands 16 bytes in front of the block, and before it as much as keeps the alignment.
void* counted(std::size_t size, std::size_t alignment = 16) {
    const std::size_t whole = (size + 2 * alignment - 1) / alignment * alignment;
    auto* start = static_cast<char*>(std::aligned_alloc(alignment, whole));
    if (start == nullptr) throw std::bad_alloc();
    char* const block = start + alignment;
    *reinterpret_cast<std::size_t*>(block - 16) = size;
    const std::size_t now = live += size;
    if (now > peak) peak = now;
    return block;
}

void uncounted(void* p, std::size_t alignment = 16) {
    if (p == nullptr) return;
    live -= *reinterpret_cast<std::size_t*>(static_cast<char*>(p) - 16);
    std::free(static_cast<char*>(p) - alignment);
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(size);
}
void* operator new[](std::size_t size) {
    return counted(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return counted(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return counted(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* p, std::align_val_t alignment) noexcept {
    uncounted(p, static_cast<std::size_t>(alignment));
}
void operator delete(void* p, std::size_t, std::align_val_t alignment) noexcept {
    uncounted(p, static_cast<std::size_t>(alignment));
}
void operator delete(void* p, const std::nothrow_t&) noexcept {
    uncounted(p);
}
void operator delete[](void* p, const std::nothrow_t&) noexcept {
    uncounted(p);
}
void operator delete(void* p) noexcept {
    uncounted(p);
}
void operator delete[](void* p) noexcept {
    uncounted(p);
}
void operator delete(void* p, std::size_t) noexcept {
    uncounted(p);
}
void operator delete[](void* p, std::size_t) noexcept {
    uncounted(p);
}

using namespace ravel;

namespace {

// What decoding takes at its worst moment, beside the file.
std::size_t taken(const Bytes& file, const DecodeOptions& options) {
    const std::size_t before = live;
    peak = before;
    { const auto decoded = decode(file, options); }
    return peak - before;
}

// Models, contexts, messages: what the smallest mesh takes too.
constexpr std::size_t kFixed = 330'000;

Bytes huge_claim(CellKind kind, auto change) {
    const auto v = test::victim(kind == CellKind::tet ? "tiny:tet" : "tiny:quad");
    return test::with_block_head(v.file, kind, change);
}

}  // namespace

TEST_CASE("decoding stays within the memory limit, whatever the limit") {
    for (const auto& v : test::victims())
        for (std::uint64_t limit = 256; limit < std::uint64_t{64} << 20; limit *= 2) {
            DecodeOptions options;
            options.memory_limit = limit;
            INFO(v.name << " within " << limit);
            REQUIRE(taken(v.file, options) <= limit + kFixed);
        }
}

TEST_CASE("large meshes stay within the limit that lets them through") {
    for (const char* recipe :
         {"torus:quads=20000", "soup:polygons=5000,seed=1,attributes",
          "tets:box=14,attributes,companions", "soup:tets=5000,seed=2", "polygons:cap,size=3000",
          "tets:box=1,copies=600", "grid:size=1x1,copies=1000",
          "tets:box=8,companions with edge nodes"})
        for (const bool order : {false, true}) {
            EncodeOptions encoding;
            encoding.keep_order = order;
            encoding.level = 3;
            const std::string all = recipe, name = all.substr(0, all.find(' '));
            const auto v = test::victim(name, encoding, name != all);
            // The lowest limit that is enough, within 2 %.
            DecodeOptions options;
            options.memory_limit = 1000;
            while (!decode(v.file, options).ok())
                options.memory_limit += options.memory_limit / 50 + 1;
            INFO(recipe << ", limit " << options.memory_limit);
            CHECK(taken(v.file, options) <= options.memory_limit + kFixed);
        }
}

TEST_CASE("a file of some hundred bytes can't take more than a few megabytes") {
    const DecodeOptions options;  // 16 GiB
    const Index most = 0x7FFFFFFF;
    for (const Index n : {Index{1} << 16, Index{1} << 24, Index{1} << 28, most}) {
        for (const Bytes& file :
             {huge_claim(CellKind::polygon,
                         [&](BlockHead& b) { b.cells = n, b.uniform_degree = 1, b.corners = n; }),
              huge_claim(CellKind::polygon,
                         [&](BlockHead& b) { b.uniform_degree = n, b.corners = n; }),
              huge_claim(CellKind::polygon,
                         [&](BlockHead& b) {
                             b.uniform_degree = 0, b.corners = n, b.vertices = b.points = n;
                         }),
              huge_claim(CellKind::polygon,
                         [&](BlockHead& b) { b.cells = n, b.uniform_degree = 0; }),
              huge_claim(CellKind::polygon, [&](BlockHead& b) { b.unused_points = n; }),
              huge_claim(CellKind::tet,
                         [&](BlockHead& b) { b.cells = n / 4, b.vertices = b.points = n / 2; }),
              huge_claim(CellKind::tet,
                         [&](BlockHead& b) {
                             b.cells = n / 4, b.vertices = b.points = n / 4,
                             b.grid_count = {1, 1, static_cast<std::uint32_t>(n / 4)};
                         }),
              huge_claim(CellKind::polygon, [&](BlockHead& b) { b.companions = n; })}) {
            REQUIRE(file.size() < 160);
            INFO(n);
            CHECK_FALSE(decode(file, options).ok());
            CHECK(taken(file, options) < 64'000'000 + kFixed);
        }
    }
}

TEST_CASE("a limit below what a head claims is refused before anything is taken for it") {
    DecodeOptions options;
    options.memory_limit = 1'000'000;
    for (const CellKind kind : {CellKind::polygon, CellKind::tet}) {
        const Bytes file = huge_claim(kind, [&](BlockHead& b) {
            b.cells = 100'000'000, b.uniform_degree = 4, b.corners = 400'000'000,
            b.vertices = b.points = 100'000'000;
        });
        CHECK(test::code_of(file, options) == Code::limit_exceeded);
        CHECK(taken(file, options) < kFixed);
    }
}

TEST_CASE("zeros that unpack to lists of empty things stay within the limit") {
    // The worst growth from bytes to memory: names, notes, attributes and companion blocks of no
    // content.
    for (const SectionId id : {SectionId::head, SectionId::names, SectionId::companions,
                               SectionId::attributes, SectionId::order})
        for (const std::uint64_t count : {100u, 10'000u, 1'000'000u})
            for (const auto& recipe : {"tiny:tet", "tets:box=2x1x1,attributes,companions"}) {
                const auto v = test::victim(recipe);
                auto parts = *test::take_apart(v.file);
                bool there = false;
                for (auto& part : parts) {
                    if (part.id != id) continue;
                    there = true;
                    ByteWriter raw;
                    if (id == SectionId::head) raw.u8(5);
                    raw.varint(count);
                    raw.raw(Bytes(count * 5, std::byte{0}));
                    part.raw = raw.take();
                }
                if (!there) continue;
                const Bytes file = test::put_together(parts, 19);
                for (const std::uint64_t limit :
                     {std::uint64_t{100'000}, std::uint64_t{10'000'000}, std::uint64_t{1} << 30}) {
                    DecodeOptions options;
                    options.memory_limit = limit;
                    INFO(name_of(id) << " of " << count << " within " << limit);
                    CHECK(taken(file, options) <= limit + kFixed);
                }
            }
}
