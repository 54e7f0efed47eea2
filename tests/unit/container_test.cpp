#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "container/head.h"
#include "container/sections.h"

using namespace ravel;

namespace {

Head rich_head(bool narrow) {
    Head head;
    head.kind = CellKind::tet;
    head.position_scalar = Scalar::f64;
    head.lossless = false;
    head.keeps_order = true;
    head.position_bits = 14;
    head.step = narrow ? 0.25 : 0.1;
    head.origin[0] = -3;
    head.origin[2] = 1e6;
    head.bound = 0.125;
    head.error = 0.0625;
    head.attributes.push_back({"", Place::mesh, Scalar::u8, 1, false, 0, {}});
    head.attributes.push_back(
        {"cell2node",
         Place::cell,
         Scalar::i64,
         65535,
         true,
         Index{1} << 50,
         {{0, Place::point, std::int64_t{1} << 40}, {65534, Place::cell, -1}}});
    return head;
}

BlockHead rich_block(CellKind kind) {
    BlockHead b;
    b.points = 70;
    b.cells = 100;
    b.corners = 400;
    b.vertices = 80;
    b.unused_points = 5;
    b.uniform_degree = kind == CellKind::polygon ? 4 : 0;
    b.companions = 3;
    b.components = 9;
    b.links = 12;
    b.has_border = false;
    b.has_flips = b.has_copies = true;
    if (kind == CellKind::tet) {
        b.mirrored = true;
        b.grid_side = 12345;
        b.grid_count = {3, 4, 5};
    } else {
        b.has_precedents = true;
    }
    return b;
}

bool refused(const BlockHead& block, CellKind kind) {
    const Bytes bytes = write_block_head(block, kind);
    ByteReader in(bytes);
    return !read_block_head(in, kind).ok();
}

bool refused(const Head& head) {
    const Bytes bytes = write_head(head);
    ByteReader in(bytes);
    return !read_head(in).ok();
}

}  // namespace

TEST_CASE("the plainest head comes back") {
    const Bytes bytes = write_head(Head{});
    CHECK(bytes.size() == 1);
    ByteReader in(bytes);
    const auto head = read_head(in);
    REQUIRE(head.ok());
    CHECK(head->kind == CellKind::polygon);
    CHECK(head->lossless);
    CHECK(head->attributes.empty());
}

TEST_CASE("heads come back field by field") {
    for (const bool narrow : {true, false}) {
        const Head given = rich_head(narrow);
        const Bytes bytes = write_head(given);
        ByteReader in(bytes);
        const auto head = read_head(in);
        REQUIRE(head.ok());
        CHECK(head->kind == given.kind);
        CHECK(head->position_scalar == given.position_scalar);
        CHECK(head->lossless == given.lossless);
        CHECK(head->keeps_order == given.keeps_order);
        CHECK(head->position_bits == given.position_bits);
        CHECK(head->step == given.step);
        for (int i = 0; i < 3; ++i) CHECK(head->origin[i] == given.origin[i]);
        CHECK(head->bound == given.bound);
        CHECK(head->error == kept_error(given.error, given.bound));
        REQUIRE(head->attributes.size() == 2);
        const AttributeHead &a = head->attributes[1], &b = given.attributes[1];
        CHECK(a.name == b.name);
        CHECK(a.place == b.place);
        CHECK(a.scalar == b.scalar);
        CHECK(a.arity == b.arity);
        CHECK(a.indexed == b.indexed);
        CHECK(a.tuples == b.tuples);
        REQUIRE(a.references.size() == 2);
        CHECK(a.references[1].component == 65534);
        CHECK(a.references[1].place == Place::cell);
        CHECK(a.references[1].base == -1);
        CHECK(a.references[0].base == std::int64_t{1} << 40);
    }
}

TEST_CASE("a head that makes no sense is refused") {
    const auto refused = [](const Head& head) {
        const Bytes bytes = write_head(head);
        ByteReader in(bytes);
        return !read_head(in).ok();
    };
    REQUIRE_FALSE(refused(rich_head(false)));
    Head head = rich_head(false);
    std::swap(head.attributes[1].references[0], head.attributes[1].references[1]);
    CHECK(refused(head));  // two references by one component could not be undone
    head = rich_head(false);
    head.bound = -1;
    CHECK(refused(head));
}

TEST_CASE("block heads come back field by field") {
    for (const CellKind kind : {CellKind::polygon, CellKind::tet}) {
        const BlockHead given = rich_block(kind);
        const Bytes bytes = write_block_head(given, kind);
        ByteReader in(bytes);
        const auto b = read_block_head(in, kind);
        REQUIRE(b.ok());
        CHECK(b->points == given.points);
        CHECK(b->cells == given.cells);
        CHECK(b->corners == given.corners);
        CHECK(b->vertices == given.vertices);
        CHECK(b->unused_points == given.unused_points);
        CHECK(b->uniform_degree == given.uniform_degree);
        CHECK(b->companions == given.companions);
        CHECK(b->components == given.components);
        CHECK(b->links == given.links);
        CHECK(b->has_border == given.has_border);
        CHECK(b->has_flips == given.has_flips);
        CHECK(b->has_copies == given.has_copies);
        CHECK(b->mirrored == given.mirrored);
        CHECK(b->has_precedents == given.has_precedents);
        CHECK(b->grid_side == given.grid_side);
        CHECK(b->grid_count == given.grid_count);
    }
}

TEST_CASE("every truncation of a head is refused, and every byte too many") {
    Bytes head = write_head(rich_head(false));
    for (std::size_t size = 0; size < head.size(); ++size) {
        ByteReader in(std::span<const std::byte>(head).first(size));
        CHECK_FALSE(read_head(in).ok());
    }
    head.push_back(std::byte{0});
    ByteReader in(head);
    CHECK_FALSE(read_head(in).ok());
    for (const CellKind kind : {CellKind::polygon, CellKind::tet}) {
        Bytes block = write_block_head(rich_block(kind), kind);
        for (std::size_t size = 0; size < block.size(); ++size) {
            ByteReader part(std::span<const std::byte>(block).first(size));
            CHECK_FALSE(read_block_head(part, kind).ok());
        }
        block.push_back(std::byte{0});
        ByteReader more(block);
        CHECK_FALSE(read_block_head(more, kind).ok());
    }
}

TEST_CASE("origins come back, whole steps or not") {
    for (const double step : {0.1, 0.25, 3e-5})
        for (const double steps : {0.0, 1.0, -8192.0, 0.5, -0x1p53, 0x1p60, 1e300}) {
            Head given = rich_head(false);
            given.step = step;
            given.origin[0] = steps * step;
            const Bytes bytes = write_head(given);
            ByteReader in(bytes);
            const auto head = read_head(in);
            REQUIRE(head.ok());
            for (int i = 0; i < 3; ++i) CHECK(head->origin[i] == given.origin[i]);
        }
}

TEST_CASE("of an error is kept a little more, but never more than the bound") {
    for (const double bound : {0.125, 0.1, 1e-300, 5e-324, 1e300, 0.0})
        for (int i = 0; i <= 1000; ++i) {
            const double error = bound * (i / 1000.0), kept = kept_error(error, bound);
            CHECK(kept >= error);
            CHECK(kept <= bound);
            CHECK(kept - error <= bound * 3 / 255 + 5e-324);
            CHECK(kept_error(kept, bound) == kept);
        }
}

TEST_CASE("a grid that no positions could be on is refused") {
    for (const double step : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
        Head head = rich_head(false);
        head.step = step;
        CHECK(refused(head));
    }
    Head head = rich_head(false);
    head.origin[1] = std::numeric_limits<double>::quiet_NaN();
    CHECK(refused(head));
    head = rich_head(false);
    head.bound = std::numeric_limits<double>::infinity();
    CHECK(refused(head));
}

TEST_CASE("an attribute of impossible shape is refused") {
    Head head = rich_head(true);
    head.attributes[0].arity = 0;
    CHECK(refused(head));
    head.attributes[0].arity = 65536;
    CHECK(refused(head));
    head = rich_head(true);
    head.attributes[1].references[0].component = 65535;
    CHECK(refused(head));
}

TEST_CASE("counts of a block that contradict each other are refused") {
    const auto with = [](auto change) {
        BlockHead b = rich_block(CellKind::polygon);
        change(b);
        return refused(b, CellKind::polygon);
    };
    CHECK_FALSE(with([](BlockHead&) {}));
    CHECK(with([](BlockHead& b) { b.points = b.vertices + 1; }));
    CHECK(with([](BlockHead& b) { b.vertices = 401; }));
    CHECK(with([](BlockHead& b) { b.components = 101; }));
    CHECK(with([](BlockHead& b) { b.links = 401; }));
    CHECK(with([](BlockHead& b) { b.cells = 0xFFFFFFFEu; }));
    CHECK(with([](BlockHead& b) { b.cells = 0x80000000u; }));  // times four corners
    CHECK(with([](BlockHead& b) { b.unused_points = 0xFFFFFFFEu; }));
    CHECK(with([](BlockHead& b) { b.uniform_degree = ~Index{0}; }));
    CHECK(with([](BlockHead& b) { b.uniform_degree = 0, b.corners = ~Index{0}; }));
}

TEST_CASE("a grid of more cubes than vertices need is refused") {
    BlockHead b = rich_block(CellKind::tet);
    for (const std::uint32_t n : {0u, 1000u, 0xFFFFFFFFu}) {
        b.grid_count = {n, n, n};
        CHECK(refused(b, CellKind::tet));
    }
    b.grid_count = {1, 1, 1};
    for (const Index side : {Index{0}, (Index{1} << 52) + 1, ~Index{0}}) {
        b.grid_side = side;
        CHECK(refused(b, CellKind::tet));
    }
}

TEST_CASE("sections come back, the smaller of both forms") {
    const Bytes raw(300, std::byte{9}), packed(20, std::byte{1});
    for (const Bytes& form : {Bytes{}, packed, Bytes(299, std::byte{2})}) {
        ByteWriter out;
        write_section(out, raw, form);
        ByteReader in(out.bytes());
        const auto section = read_section(in, SectionId::names);
        REQUIRE(section.ok());
        CHECK(section->id == SectionId::names);
        CHECK(section->packed == (form == packed));
        CHECK(section->raw_size == 300);
        CHECK(Bytes(section->bytes.begin(), section->bytes.end()) ==
              (form == packed ? packed : raw));
        CHECK(in.left() == 0);
    }
}

TEST_CASE("a cut section is truncated") {
    ByteWriter out;
    write_section(out, Bytes(50, std::byte{3}), {});
    Bytes bytes = out.take();
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        ByteReader in(std::span<const std::byte>(bytes).first(size));
        const auto section = read_section(in, SectionId::names);
        REQUIRE_FALSE(section.ok());
        CHECK(section.error().code == Code::truncated);
    }
}

TEST_CASE("the end of a file tells whether all before it is what was written") {
    ByteWriter out;
    write_section(out, Bytes(50, std::byte{3}), {});
    write_end(out);
    const Bytes bytes = out.take();
    const std::uint64_t end = bytes.size() - 4;
    CHECK(check_end(bytes, end).ok());
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        Bytes damaged = bytes;
        damaged[bit / 8] ^= static_cast<std::byte>(1u << bit % 8);
        REQUIRE_FALSE(check_end(damaged, end).ok());
        CHECK(check_end(damaged, end).error().code == Code::checksum_mismatch);
    }
    for (std::size_t size = end; size < bytes.size(); ++size)
        CHECK(check_end(std::span(bytes).first(size), end).error().code == Code::truncated);
    Bytes longer = bytes;
    longer.push_back(std::byte{0});
    CHECK(check_end(longer, end).error().code == Code::corrupt);
}
