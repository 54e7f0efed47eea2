// Rows 14 to 28, 54 and 55 of chapter 14.
#include <cmath>
#include <limits>

#include "spec/invalid_maker.h"

namespace ravel::test {

void InvalidMaker::heads() {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const auto flags = [&](const char* name, SectionId id, unsigned bits) {
        return raw_changed(name, id, [&](Bytes& raw) { raw[0] |= byte(bits); });
    };
    add(14, "coarse-origin", "coarse_origin without whole_origin",
        raw_changed("two-quads", SectionId::head, [](Bytes& raw) {
            raw[0] &= ~byte(32);
            raw[1] |= byte(128);
            raw.insert(raw.begin() + 6, 9, byte(0));  // the origin's three bytes become floats
        }));
    add(14, "narrow", "narrow_head with lossless", flags("quad", SectionId::head, 16));
    add(14, "whole-origin", "whole_origin with lossless", flags("quad", SectionId::head, 32));
    add(14, "half-step", "half_step with lossless", flags("quad", SectionId::head, 64));
    const auto grid = [&](const char* name, const char* says, auto change) {
        add(15, name, says, head_changed("two-quads", change));
    };
    grid("bits", "position_bits is 65", [](Head& h) { h.position_bits = 65; });
    grid("step", "step is 0", [](Head& h) { h.step = 0; });
    grid("step-nan", "step is no number", [](Head& h) { h.step = kNan; });
    grid("origin", "origin is infinite", [](Head& h) { h.origin[1] = -HUGE_VAL; });
    grid("bound", "bound is negative", [](Head& h) { h.bound = h.error = -1; });
    add(15, "steps", "origin is 2^53 steps",
        raw_changed("two-quads", SectionId::head, [](Bytes& raw) {
            const std::size_t at = 6;  // flags, position_bits and step before it
            raw.erase(raw.begin() + at);
            const unsigned steps[] = {0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x20};
            for (std::size_t i = 0; i < 8; ++i)
                raw.insert(raw.begin() + static_cast<std::ptrdiff_t>(at + i), byte(steps[i]));
        }));
    add(16, "attributes", "attribute_count is 200",
        raw_changed("quad", SectionId::head, [](Bytes& raw) {
            raw[0] |= byte(128);
            raw.insert(raw.end(), {byte(200), byte(1)});
        }));
    const auto attribute = [&](int row, const char* name, const char* says, auto change) {
        add(row, name, says, head_changed("attributes", [&](Head& h) { change(h.attributes[0]); }));
    };
    attribute(17, "place", "place is 5", [](AttributeHead& a) { a.place = static_cast<Place>(5); });
    attribute(17, "scalar", "scalar is 10",
              [](AttributeHead& a) { a.scalar = static_cast<Scalar>(10); });
    attribute(17, "arity", "arity is 0", [](AttributeHead& a) { a.arity = 0; });
    attribute(18, "component", "a reference to component 1 of one", [](AttributeHead& a) {
        a.scalar = Scalar::u32;
        a.references = {{1, Place::point, 0}};
    });
    attribute(18, "scalar", "a reference by f32", [](AttributeHead& a) {
        a.references = {{0, Place::point, 0}};
    });
    const auto bound = [&](const char* name, const char* says, auto change) {
        attribute(55, name, says, [&](AttributeHead& a) { a.bound = a.error = 1, change(a); });
    };
    bound("bound", "bound is infinite", [](AttributeHead& a) { a.bound = HUGE_VAL; });
    bound("error", "error is above bound", [](AttributeHead& a) { a.error = 2; });
    add(55, "integers", "a bound of integers", head_changed("attributes", [](Head& h) {
            for (AttributeHead& a : h.attributes)
                if (!is_float(a.scalar)) a.bound = 1;
        }));
    add(19, "leaders-move", "leaders_move with polygons", flags("two-quads", SectionId::block, 64));
    add(19, "edge-points", "edge_points with polygons", flags("two-quads", SectionId::block, 32));
    add(19, "mirrored", "mirrored with polygons", flags("two-quads", SectionId::block, 8));
}

void InvalidMaker::counts() {
    constexpr CellKind kPolygon = CellKind::polygon, kTet = CellKind::tet;
    const auto block = [&](int row, const char* name, const char* says, auto change) {
        add(row, name, says, block_changed("two-quads", kPolygon, change));
    };
    add(6, "told", "told is 16, of polygons",
        raw_changed("two-quads", SectionId::block, [](Bytes& raw) { raw.back() = byte(16); }));
    add(6, "told-of-tets", "told is 32",
        raw_changed("two-tets", SectionId::block, [](Bytes& raw) { raw[3] = byte(32); }));
    block(20, "cells", "2^32 - 2 cells", [](BlockHead& b) { b.cells = 0xFFFFFFFE; });
    block(20, "vertices", "more vertices than corners",
          [](BlockHead& b) { b.vertices = b.points = 9; });
    block(20, "components", "more components than cells", [](BlockHead& b) { b.components = 3; });
    block(20, "links", "more links than corners", [](BlockHead& b) { b.links = 9; });
    block(20, "unused", "2^32 - 8 unused points",
          [](BlockHead& b) { b.unused_points = 0xFFFFFFF8; });
    const auto grid = [&](const char* name, const char* says, auto change) {
        add(21, name, says, block_changed("two-tets", kTet, change));
    };
    grid("side", "grid_side is 0", [](BlockHead& b) { b.grid_side = 0; });
    grid("none", "a grid_count is 0", [](BlockHead& b) { b.grid_count[1] = 0; });
    grid("many", "65 is the most blocks of cubes of 5 vertices", [](BlockHead& b) {
        b.grid_count = {261, 1, 1};
    });
    grid("shapes", "shape_step is 2^52 + 1",
         [](BlockHead& b) { b.shape_step = (Index{1} << 52) + 1; });
    block(22, "cells", "a million cells", [](BlockHead& b) { b.cells = 1000000; });
    add(23, "connectivity", "connectivity is empty",
        raw_changed("two-quads", SectionId::connectivity, [](Bytes& raw) { raw.clear(); }));
    add(23, "positions", "positions end behind their head",
        raw_changed("two-quads", SectionId::positions, [](Bytes& raw) { raw.resize(2); }));
    add(24, "more", "a byte 00 behind connectivity",
        raw_changed("two-quads", SectionId::connectivity,
                    [](Bytes& raw) { raw.push_back(byte(0)); }));
    add(24, "padding", "the last bit of connectivity is 1",
        raw_changed("two-quads", SectionId::connectivity,
                    [](Bytes& raw) { raw.back() |= byte(1); }));
    add(25, "cells", "one cell less than there are",
        block_changed("torus", kPolygon, [](BlockHead& b) { --b.cells; }));
    block(26, "more", "one vertex less than there are",
          [](BlockHead& b) { b.points = --b.vertices; });
    block(26, "less", "one vertex more than there are",
          [](BlockHead& b) { b.points = ++b.vertices; });
    add(27, "components", "one component less than there are",
        block_changed("two-apart", kPolygon, [](BlockHead& b) { --b.components; }));
    add(27, "points", "one point less than there are",
        block_changed("moebius", kPolygon, [](BlockHead& b) { --b.points; }));
    block(28, "links", "one link more than there are", [](BlockHead& b) { ++b.links; });
    add(54, "memory", "for a reader that may take 1000 bytes", valid("torus"),
        Code::limit_exceeded);
}

}  // namespace ravel::test
