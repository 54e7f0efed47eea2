// Behind the checksums: codes and positions that no encoder writes, so that the walk itself is
// attacked.
#include "malformed/victims.h"

#include "make/random.h"

using namespace ravel;

namespace {

Bytes random_bytes(make::Random& random, std::size_t size) {
    Bytes bytes(size);
    const std::uint64_t style = random.below(4);
    for (std::byte& b : bytes) {
        b = static_cast<std::byte>(random.next() >> 11);
        if (style == 1) b &= static_cast<std::byte>(random.next() >> 7);
        if (style == 2) b |= static_cast<std::byte>(random.next() >> 7);
        if (style == 3 && !random.one_in(8)) b = std::byte{0xFF};
    }
    return bytes;
}

}  // namespace

TEST_CASE("random codes lead a walk to an error or a mesh") {
    const auto all = test::victims();
    std::size_t meshes = 0;
    for (std::uint64_t seed = 0; seed < 8000; ++seed) {
        make::Random random{seed};
        const auto& v = all[seed % all.size()];
        auto parts = *test::take_apart(v.file);
        for (auto& part : parts) {
            if (part.id == SectionId::connectivity)
                part.raw = random_bytes(random, random.below(200));
            if (part.id == SectionId::positions && random.one_in(2)) {
                const std::size_t head =
                    std::min<std::size_t>(part.raw.size(), random.one_in(2) ? 2 : 4);
                const Bytes more = random_bytes(random, random.below(500));
                part.raw.resize(head);
                part.raw.insert(part.raw.end(), more.begin(), more.end());
            }
        }
        const Bytes file = test::put_together(parts);
        INFO(v.name << ", seed " << seed);
        REQUIRE(test::unsafe(file) == "");
        meshes += decode(file).ok();
    }
    INFO(meshes << " meshes");
    SUCCEED();
}

TEST_CASE("random codes under larger counts lead to an error or a mesh") {
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
        make::Random random{seed};
        const auto v = test::victim(seed % 2 == 0 ? "tiny:cube" : "tiny:two-tets");
        const Bytes larger = test::with_block_head(v.file, v.kind, [&](BlockHead& b) {
            b.cells = 1 + random.below(60);
            b.by_folds = v.kind == CellKind::tet && random.one_in(2);
            b.uniform_degree = random.one_in(2) ? 0 : 1 + random.below(6);
            b.corners = v.kind == CellKind::tet ? 4 * b.cells
                        : b.uniform_degree != 0 ? b.uniform_degree * b.cells
                                                : random.below(400);
            b.vertices = random.below(b.corners + 1);
            b.has_copies = random.one_in(3);
            b.points = b.has_copies ? random.below(b.vertices + 1) : b.vertices;
            b.has_flips = random.one_in(3);
            b.has_border = random.one_in(2);
            if (v.kind == CellKind::tet) {
                b.mirrored = random.one_in(2);
                b.grid_side = 1 + random.below(2000);
                b.shape_step = random.one_in(3) ? 0 : 1 + random.below(2000);
                b.leaders_move = random.one_in(2);
            } else {
                b.has_precedents = random.one_in(2);
            }
            b.unused_points = random.below(3);
            b.components = std::min<Index>(1 + random.below(5), b.cells);
            b.links = random.below(b.corners + 1);
        });
        auto parts = *test::take_apart(larger);
        for (auto& part : parts)
            if (part.id == SectionId::connectivity || part.id == SectionId::positions) {
                const Bytes more = random_bytes(random, random.below(300));
                part.raw.resize(std::min<std::size_t>(part.raw.size(),
                                                      part.id == SectionId::positions ? 2 : 0));
                part.raw.insert(part.raw.end(), more.begin(), more.end());
            }
        INFO("seed " << seed);
        REQUIRE(test::unsafe(test::put_together(parts)) == "");
    }
}

TEST_CASE("residuals of the largest size do not overflow") {
    EncodeOptions options;
    options.position_bits = 12;
    for (const char* recipe : {"torus:size=6x4", "tets:box=2x1x1"}) {
        const auto v = test::victim(recipe, options);
        for (const int byte : {0x00, 0x55, 0xAA, 0xFF})
            for (std::size_t from = 2; from < 60; ++from) {
                const Bytes bad = test::with_section(v.file, SectionId::positions, [&](Bytes& raw) {
                    for (std::size_t i = from; i < raw.size(); ++i)
                        raw[i] = static_cast<std::byte>(byte);
                });
                REQUIRE(test::unsafe(bad) == "");
            }
    }
}

TEST_CASE("a crowd of vertices in one cube of the grid comes back in bounded time") {
    // One point far away: all others share a cube, and nearly a place.
    Result<Mesh> mesh = make::make_mesh("tets:box=12,jitter=0.2,double");
    REQUIRE(mesh.ok());
    mesh->positions.as<double>()[0] = -1e9;
    for (const bool grid : {false, true}) {
        EncodeOptions options;
        options.level = 1;
        if (grid) options.position_bits = 20;
        const auto packed = encode(*mesh, options);
        REQUIRE(packed.ok());
        const auto again = decode(packed->bytes);
        REQUIRE(again.ok());
        CHECK(compare_meshes(*mesh, again->mesh, packed->order, packed->position_bound).equal);
    }
}
