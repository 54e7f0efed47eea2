// Rows 47 to 53 and 56 to 58 of chapter 14, and one of row 13: what rides along.
#include "encode/bits_writer.h"
#include "predict/numbering_codes.h"
#include "spec/invalid_maker.h"

namespace ravel::test {
namespace {

using C = AttributeContexts;

// Flags of some blocks as they are forced to be, and numbers as they are or of ones alone.
struct ForcedWriter : BitsWriter {
    std::vector<std::pair<ContextBlock, bool>> forced;
    bool all_ones = false;

    bool flag(Context context, bool truth) {
        for (const auto& [block, answer] : forced)
            if (context >= block.base && context < block.end()) truth = answer;
        return BitsWriter::flag(context, truth);
    }
    std::uint64_t plain(std::uint64_t truth, int count) {
        const std::uint64_t most = (std::uint64_t{1} << count) - 1;
        return BitsWriter::plain(all_ones ? most : truth & most, count);
    }
};

// The stream that `tell` writes.
template <class Tell>
Bytes stream_of(const Tell& tell) {
    FlagEncoder bits;
    ForcedWriter out{{bits}, {}, false};
    tell(out);
    return bits.finish();
}

// Residuals of elements that have one component, each beside the one before.
void tell_residuals(ForcedWriter& out, const std::vector<std::int64_t>& residuals) {
    ResidualSizes sizes;
    Id e = 0;
    for (const std::int64_t r : residuals) {
        Stencil near;
        near.configuration = static_cast<Configuration>(e > 0 ? 1 : 0);
        if (e > 0) near.at[0] = e - 1;
        sizes.begin(near);
        sizes.coded(0, magnitude(code_residual(out, sizes.scale(0, 0), r)));
        sizes.push();
        ++e;
    }
}

// Two quads with companions: the heads of all blocks, then what follows them.
struct Blocks {
    struct One {
        std::uint64_t vtk_type, nodes, cells;
        std::uint8_t kind;
        std::uint64_t marks = 0;
    };
    std::vector<One> heads;
    std::vector<std::int64_t> deltas;
    Bytes stream;
};
Bytes with_companions(const Bytes& file, const Blocks& blocks) {
    ByteWriter out;
    out.varint(blocks.heads.size());
    for (const Blocks::One& b : blocks.heads) {
        out.varint(b.vtk_type);
        out.varint(b.nodes);
        out.varint(b.cells);
        out.u8(b.kind);
        if (b.kind == 2) out.varint(b.marks);
    }
    for (const std::int64_t d : blocks.deltas) out.varint(zigzag(d));
    out.raw(blocks.stream);
    return with_section(with_block_head(file, CellKind::polygon,
                                        [&](BlockHead& b) { b.companions = blocks.heads.size(); }),
                        SectionId::companions, [&](Bytes& raw) { raw = out.take(); });
}

Bytes with_attribute(const Bytes& file, const AttributeHead& head, const Bytes& coding,
                     const Bytes& stream) {
    return with_section(with_head(file, [&](Head& h) { h.attributes = {head}; }),
                        SectionId::attributes, [&](Bytes& raw) {
                            raw = coding;
                            raw.insert(raw.end(), stream.begin(), stream.end());
                        });
}

// An order of a file that kept none.
Bytes with_order(const Bytes& file, unsigned told, const Bytes& stream) {
    return with_section(with_head(file, [](Head& h) { h.keeps_order = true; }), SectionId::order,
                        [&](Bytes& raw) {
                            raw = {byte(told)};
                            raw.insert(raw.end(), stream.begin(), stream.end());
                        });
}

// Elements of which each lies beside the one before, as unlinked companions do.
struct InARow final : Around {
    Beside beside(Id element, const Id*) const override {
        Beside b;
        if (element > 0) b.add(element - 1, 1);
        return b;
    }
};

}  // namespace

void InvalidMaker::companions() {
    const auto block = [&](int row, const char* name, const char* says, Blocks::One head,
                           std::vector<std::int64_t> deltas) {
        add(row, name, says, with_companions(quads(), {{head}, std::move(deltas), {}}));
    };
    block(13, "more-companions", "a byte too many", {1, 1, 1, 0}, {0, 0});
    add(47, "count", "one companion block more than there are",
        block_changed("companions", CellKind::tet, [](BlockHead& b) { ++b.companions; }));
    block(47, "type", "vtk_type is 65536", {65536, 1, 1, 0}, {0});
    block(47, "kind", "kind is 4", {1, 1, 1, 4}, {0});
    block(47, "cells", "two cells of one byte", {1, 1, 2, 0}, {0});
    block(47, "marks", "two marks of one cell", {1, 1, 1, 2, 2}, {0});
    block(47, "parts", "31 marks in a mesh of 30 corners and points", {1, 1, 31, 2, 31}, {0});
    block(48, "node", "a node at point 6 of 6", {1, 1, 1, 0}, {6});
    block(48, "host", "a host that is cell 2 of 2", {1, 1, 1, 1}, {0, 2});
    // All points of two quads are on the border.
    constexpr Context kPoint = C::mark_point.at(0, 1), kBlock = C::mark_block.at(2);
    constexpr Blocks::One kOne{1, 1, 1, 2, 1};
    const auto marks = [&](const char* name, const char* says, std::vector<Blocks::One> heads,
                           const auto& tell) {
        add(56, name, says, with_companions(quads(), {std::move(heads), {}, stream_of(tell)}));
    };
    marks("endless", "a mark that no point is", {kOne}, [](ForcedWriter& out) {
        for (int p = 0; p < 6; ++p) out.flag(kPoint, false);
    });
    marks("full", "two marks of a block of one", {kOne, kOne}, [](ForcedWriter& out) {
        for (int p = 0; p < 2; ++p) out.flag(kPoint, true), out.flag(kBlock, true);
    });
    marks("open", "a mark of block 3 of three", {kOne, kOne, kOne}, [](ForcedWriter& out) {
        out.flag(kPoint, true);
        out.flag(kBlock, false);
        out.plain(3, 2);
    });
    marks("polygons", "a mark of three nodes on polygons", {{5, 3, 1, 2, 1}},
          [](ForcedWriter& out) { out.plain(0, 8); });
    add(58, "points", "more edges than points",
        block_changed("two-tets", CellKind::tet, [](BlockHead& b) { b.has_edge_points = true; }));
    add(58, "kind", "nodes on edges without edge_points",
        block_changed("edge-points", CellKind::tet,
                      [](BlockHead& b) { b.has_edge_points = false; }));
    const auto on_edges = [&](const char* name, const char* says, std::size_t at, unsigned value) {
        add(58, name, says, raw_changed("edge-points", SectionId::companions, [=](Bytes& raw) {
                raw[at] = byte(value);
            }));
    };
    on_edges("type", "vtk_type is 5", 1, 5);
    on_edges("nodes", "nodes_per_cell is 3", 2, 3);
    on_edges("cells", "one cell less than tets", 3, 11);
}

void InvalidMaker::attributes() {
    add(49, "tuples", "one tuple more than points",
        head_changed("attributes", [](Head& h) { ++h.attributes[0].tuples; }));
    add(49, "coding", "bit 3 of coding",
        raw_changed("attributes", SectionId::attributes, [](Bytes& raw) { raw[0] |= byte(8); }));
    add(49, "flooded", "points that are flooded",
        with_attribute(quads(), {"a", Place::point, Scalar::u8, 1, false, 6, {}},
                       {byte(2), byte(1)},
                       stream_of([](ForcedWriter& out) { tell_residuals(out, {0}); })));
    const AttributeHead of_cells{"a", Place::cell, Scalar::u8, 1, false, 2, {}};
    add(50, "none", "a pool of no tuples",
        with_attribute(quads(), of_cells, {byte(1), byte(0)}, {}));
    add(50, "unused", "a pool of two tuples, of which cells have the first",
        with_attribute(quads(), of_cells, {byte(1), byte(2)}, stream_of([](ForcedWriter& out) {
                           out.flag(C::same.at(0, 0, 0, 0), true);
                           tell_residuals(out, {0, 0});
                       })));
    // The last companion has neither a new tuple nor one that it is asked for.
    const Bytes row = with_companions(quads(), {{{1, 1, 4, 0}}, {0, 0, 0, 0}, {}});
    add(50, "number", "tuple 3 of three",
        with_attribute(row, {"a", Place::companion, Scalar::u8, 1, false, 4, {}},
                       {byte(1), byte(3)}, stream_of([](ForcedWriter& out) {
                           out.all_ones = true;
                           TupleCodes<ForcedWriter> codes(out, 3, false);
                           std::vector<Id> tuple{0, 1, 2, 3};
                           if (code_tuples(codes, InARow(), tuple))
                               throw std::runtime_error("a fourth tuple of three");
                       })));
    const auto names = [&](const char* name, const char* says, auto change) {
        add(51, name, says, raw_changed("attributes", SectionId::names, change));
    };
    names("count", "name_count is 100", [](Bytes& raw) { raw[0] = byte(100); });
    names("dimension", "dimension is 4", [](Bytes& raw) { raw[8] = byte(8); });
    constexpr std::int64_t kMost = std::int64_t{1} << 53;
    // The residuals of the first tuple.
    const auto tuple = [](std::initializer_list<std::int64_t> residuals) {
        return stream_of([&](ForcedWriter& out) {
            ResidualSizes sizes;
            sizes.begin({});
            std::size_t slot = 0;
            for (const std::int64_t r : residuals) {
                sizes.coded(slot, magnitude(code_residual(out, sizes.scale(slot, slot), r)));
                ++slot;
            }
        });
    };
    add(57, "number", "2^53 binary units",
        with_attribute(quads(), {"a", Place::point, Scalar::f64, 1, false, 6, {}},
                       {byte(2 << 6), byte(0), byte(0)}, tuple({kMost})));
    add(57, "direction", "4 in a square of 3",
        with_attribute(quads(), {"a", Place::point, Scalar::f32, 3, false, 6, {}},
                       {byte(3 << 6), byte(32), byte(3)}, tuple({4, 0})));
}

void InvalidMaker::orders() {
    const auto told = [&](const char* name, const char* says, const char* file, unsigned value) {
        add(52, name, says,
            raw_changed(file, SectionId::order, [=](Bytes& raw) { raw[0] = byte(value); }));
    };
    told("turns", "cells_first, and turns_by_points", "order", 1 | 2);
    told("guesses", "cells_first, and guesses_points", "order", 1 | 4);
    told("cells-first", "cells_first, and cells_by lowest", "order", 1 | 1 << 4);
    told("cells-by", "guesses_cells, and cells_by first", "order", 8 | 3 << 4);
    told("edges-by", "edges_by ends, where edges have no points", "tet-order", 1 << 6);
    add(52, "by", "by is 5 of a block with hosts",
        raw_changed("edge-points-order", SectionId::order, [](Bytes& raw) { raw[1] = byte(5); }));
    add(52, "hosts", "by hosts, of a block that has none",
        with_section(with_order(with_companions(quads(), {{{1, 1, 1, 0}}, {0}, {}}), 0, {}),
                     SectionId::order, [](Bytes& raw) { raw.push_back(byte(4)); }));
    // The numbers of points come first; the last of these is told by a residual.
    const auto numbers = [&](const char* name, const char* says, const std::vector<Id>& points) {
        const Bytes stream = stream_of([&](ForcedWriter& out) {
            NumberingCodes<ForcedWriter> codes(out, 6, 6);
            for (std::size_t i = 0; i < points.size(); ++i) {
                const bool last = i + 1 == points.size();
                if (last) out.forced = {{C::number_next, false}, {C::number_near, true}};
                Stencil near;
                if (i > 0) near.at[0] = static_cast<Id>(i - 1);
                Id number = 0;
                if (codes.code(nullptr, near, points[i], number) == last)
                    throw std::runtime_error("an order without fault");
            }
        });
        add(52, name, says, with_order(quads(), 0, stream));
    };
    numbers("came", "a point at number 1, which has come", {0, 1, 1});
    numbers("beyond", "a point at number 6 of 6", {0, 1, 6});
    add(53, "turn", "turn 15 of a polygon of 11 corners",
        with_order(valid("polygon-of-11"), 1, stream_of([](ForcedWriter& out) {
                       for (std::uint32_t k = 0; k < 8; ++k) out.flag(C::turn.at(8, 0, k), false);
                       out.plain(15, 4);
                   })));
}

}  // namespace ravel::test
