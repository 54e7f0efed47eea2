#include "spec/invalid_files.h"

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "base/checksum.h"
#include "container/sections.h"
#include "spec/twist.h"
#include "spec/valid_files.h"
#include "support/file_parts.h"

namespace ravel::test {
namespace {

std::byte byte(unsigned value) {
    return static_cast<std::byte>(value);
}

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

class Maker {
  public:
    Maker() {
        for (ValidFile& file : valid_files())
            valid_[file.name] = put_together(parts_of(file.bytes));
    }

    std::vector<InvalidFile> take() { return std::move(made_); }

    void make() {
        container();
        heads();
        counts();
        walks();
        positions();
        riders();
    }

  private:
    const Bytes& valid(const char* name) const {
        const auto found = valid_.find(name);
        if (found == valid_.end()) throw std::runtime_error(std::string("no valid file ") + name);
        return found->second;
    }
    void add(int row, const char* name, const char* says, Bytes bytes, Code code = Code::corrupt) {
        made_.push_back({row, (row < 10 ? "0" : "") + std::to_string(row) + "-" + name, code, says,
                         std::move(bytes)});
    }
    // With one section stored as `write` does it.
    template <class Write>
    Bytes with_stored(SectionId id, const Write& write) const {
        ByteWriter out;
        out.raw(kMagic);
        out.u8(kVersion);
        const std::vector<FilePart> parts = parts_of(quads());
        for (const FilePart& part : parts) {
            if (part.id == id)
                write(out, part.raw);
            else
                write_section(out, part.id, part.raw, {});
        }
        out.u8(0);
        return out.take();
    }
    static void store(ByteWriter& out, SectionId id, const Bytes& stored, std::uint64_t raw_size) {
        out.u8(static_cast<std::uint8_t>(id));
        out.varint(std::uint64_t{stored.size()} << 1 | 1);
        out.varint(raw_size);
        out.u32(crc32c(stored));
        out.raw(stored);
    }
    const Bytes& quads() const { return valid("two-quads"); }
    Bytes raw_changed(const char* name, SectionId id,
                      const std::function<void(Bytes&)>& change) const {
        return with_section(valid(name), id, change);
    }
    template <class Change>
    Bytes head_changed(const char* name, const Change& change) const {
        return with_head(valid(name), change);
    }
    template <class Change>
    Bytes block_changed(const char* name, CellKind kind, const Change& change) const {
        return with_block_head(valid(name), kind, change);
    }

    void container() {
        constexpr SectionId kBlock = SectionId::block;
        Bytes file = quads();
        file[3] = byte('2');
        add(1, "magic", "the fourth byte is 32", file, Code::not_a_ravel_file);
        add(1, "short", "three bytes", {byte('R'), byte('a'), byte('v')}, Code::not_a_ravel_file);
        file = quads();
        file[4] = byte(0);
        add(2, "version-0", "version 0", file, Code::unsupported_version);
        file.resize(4);
        add(2, "no-version", "nothing behind the magic", file, Code::unsupported_version);
        file = quads();
        file.pop_back();
        add(3, "no-end", "the byte 0 is missing", file, Code::truncated);
        file.resize(file.size() - 2);
        add(3, "in-bytes", "the bytes of positions are cut", file, Code::truncated);
        file.resize(8);
        add(3, "in-a-head", "the checksum of head is cut", file, Code::truncated);
        file = quads();
        file[6] = byte(0x80);
        file[7] = byte(0);
        add(4, "size", "the size of head is 80 00", file, Code::truncated);
        file = quads();
        file.back() = byte(9);
        add(5, "id", "a section 9 in the place of end", file);
        auto parts = parts_of(quads());
        std::swap(parts[2], parts[3]);
        add(6, "order", "positions before connectivity", put_together(parts));
        std::swap(parts[2], parts[3]);
        parts.push_back(parts[3]);
        add(6, "twice", "positions twice", put_together(parts));
        file = quads();
        file.push_back(byte(0));
        add(7, "more", "a byte behind end", file);
        for (std::size_t k = 0; k < 4; ++k) {
            parts = parts_of(quads());
            const std::string name = std::string("no-") + name_of(parts[k].id);
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
            add(8, name.c_str(), "a section that every file has is missing", put_together(parts));
        }
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
        file[file.size() - 3] ^= byte(1);
        add(10, "bit", "a bit of positions is flipped", file, Code::checksum_mismatch);
        add(11, "no-frame", "block is packed, but no frame",
            with_stored(kBlock,
                        [](ByteWriter& out, const Bytes& raw) { store(out, kBlock, raw, 8); }));
        add(11, "two-frames", "block is packed as two frames",
            with_stored(kBlock, [](ByteWriter& out, const Bytes& raw) {
                Bytes twice = frame_of({raw.begin(), raw.begin() + 4});
                const Bytes more = frame_of({raw.begin() + 4, raw.end()});
                twice.insert(twice.end(), more.begin(), more.end());
                store(out, kBlock, twice, raw.size());
            }));
        add(11, "cut-frame", "the frame of block lacks its last byte",
            with_stored(kBlock, [](ByteWriter& out, const Bytes& raw) {
                Bytes frame = frame_of(raw);
                frame.pop_back();
                store(out, kBlock, frame, raw.size());
            }));
        add(12, "less", "the frame of block unpacks to less than raw_size",
            with_stored(kBlock, [](ByteWriter& out, const Bytes& raw) {
                store(out, kBlock, frame_of(raw), raw.size() + 1);
            }));
        add(12, "more", "the frame of block unpacks to more than raw_size",
            with_stored(kBlock, [](ByteWriter& out, const Bytes& raw) {
                store(out, kBlock, frame_of(raw), raw.size() - 1);
            }));
        add(12, "much-more", "raw_size is above what the bytes can hold",
            with_stored(kBlock, [](ByteWriter& out, const Bytes& raw) {
                store(out, kBlock, frame_of(raw), std::uint64_t{131072} * (raw.size() / 4 + 8));
            }));
        for (const SectionId id : {SectionId::head, SectionId::block})
            add(13, (std::string("more-") + name_of(id)).c_str(), "a byte too many",
                raw_changed("two-quads", id, [](Bytes& raw) { raw.push_back(byte(0)); }));
        add(13, "less", "block lacks its last byte",
            raw_changed("two-quads", kBlock, [](Bytes& raw) { raw.pop_back(); }));
        add(13, "varint", "links is 80 00", raw_changed("two-quads", kBlock, [](Bytes& raw) {
                raw.back() = byte(0x80);
                raw.push_back(byte(0));
            }));
    }

    void heads() {
        constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
        const auto flags = [&](const char* name, SectionId id, unsigned bits) {
            return raw_changed(name, id, [&](Bytes& raw) { raw[0] |= byte(bits); });
        };
        add(14, "flags", "bit 5 of flags", flags("two-quads", SectionId::head, 32));
        add(14, "narrow", "narrow_head with lossless", flags("quad", SectionId::head, 16));
        const auto grid = [&](const char* name, const char* says, auto change) {
            add(15, name, says, head_changed("two-quads", change));
        };
        grid("bits", "position_bits is 65", [](Head& h) { h.position_bits = 65; });
        grid("step", "step is 0", [](Head& h) { h.step = 0; });
        grid("step-nan", "step is no number", [](Head& h) { h.step = kNan; });
        grid("origin", "origin is infinite", [](Head& h) { h.origin[1] = -HUGE_VAL; });
        grid("bound", "bound is negative", [](Head& h) { h.bound = h.error = -1; });
        grid("error", "error is above bound", [](Head& h) { h.error = 2 * h.bound; });
        add(16, "attributes", "attribute_count is 200",
            raw_changed("quad", SectionId::head, [](Bytes& raw) {
                raw[1] = byte(200);
                raw.insert(raw.begin() + 2, byte(1));
            }));
        const auto attribute = [&](int row, const char* name, const char* says, auto change) {
            add(row, name, says,
                head_changed("attributes", [&](Head& h) { change(h.attributes[0]); }));
        };
        attribute(17, "place", "place is 5",
                  [](AttributeHead& a) { a.place = static_cast<Place>(5); });
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
        add(19, "flags", "bit 5 of flags", flags("two-quads", SectionId::block, 32));
        add(19, "mirrored", "mirrored with polygons", flags("two-quads", SectionId::block, 8));
    }

    void counts() {
        constexpr CellKind kPolygon = CellKind::polygon, kTet = CellKind::tet;
        const auto block = [&](int row, const char* name, const char* says, auto change) {
            add(row, name, says, block_changed("two-quads", kPolygon, change));
        };
        block(20, "cells", "2^32 - 2 cells", [](BlockHead& b) { b.cells = 0xFFFFFFFE; });
        block(20, "vertices", "more vertices than corners",
              [](BlockHead& b) { b.vertices = b.points = 9; });
        block(20, "components", "more components than cells",
              [](BlockHead& b) { b.components = 3; });
        block(20, "links", "more links than corners", [](BlockHead& b) { b.links = 9; });
        block(20, "unused", "2^32 - 8 unused points",
              [](BlockHead& b) { b.unused_points = 0xFFFFFFF8; });
        const auto grid = [&](const char* name, const char* says, auto change) {
            add(21, name, says, block_changed("two-tets", kTet, change));
        };
        grid("side", "grid_side is 0", [](BlockHead& b) { b.grid_side = 0; });
        grid("none", "a grid_count is 0", [](BlockHead& b) { b.grid_count[1] = 0; });
        grid("many", "84 is the most cubes of 5 vertices", [](BlockHead& b) {
            b.grid_count = {5, 17, 1};
        });
        block(22, "cells", "a million cells", [](BlockHead& b) { b.cells = 1000000; });
        add(23, "connectivity", "connectivity is empty",
            raw_changed("two-quads", SectionId::connectivity, [](Bytes& raw) { raw.clear(); }));
        add(23, "positions", "positions end behind their head",
            raw_changed("two-quads", SectionId::positions, [](Bytes& raw) { raw.resize(2); }));
        add(24, "more", "a byte 00 behind connectivity",
            raw_changed("two-quads", SectionId::connectivity,
                        [](Bytes& raw) { raw.push_back(byte(0)); }));
        add(24, "padding", "the last bit of positions is 1",
            raw_changed("two-quads", SectionId::positions,
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

    void walks() {
        using Flag = std::optional<bool>;
        using Number = std::optional<std::uint64_t>;
        add(29, "later", "a copy of itself",
            with_twisted_walk(valid("moebius"), {{}, [](const Question& q) -> Number {
                                                     if (q.block != "kCopyOf") return {};
                                                     return 2 * std::uint64_t{
                                                                    q.walked.vertex_count - 1};
                                                 }}));
        const Twist rest{
            [](const Question& q) -> Flag { return q.block == "kDegree" ? Flag(false) : Flag(); },
            [](const Question& q) -> Number {
                return q.block == "kDegreeRest" ? Number(1000) : Number();
            }};
        add(30, "rest", "kDegreeRest is 1000", with_twisted_walk(valid("degrees"), rest));
        const auto second_cell = [](const Question& q) { return q.walked.cell_count() > 0; };
        const Twist one{[&](const Question& q) -> Flag {
                            return q.block == "kDegree" && second_cell(q) ? Flag(false) : Flag();
                        },
                        [](const Question& q) -> Number {
                            return q.block == "kDegreeRest" ? Number(1) : Number();
                        }};
        add(31, "one", "one corner behind a gate", with_twisted_walk(valid("mixed"), one));
        // From the first old corner on; a middle corner that is not new is old.
        const auto old_corner = [](bool near, auto number) {
            return Twist{[=](const Question& q) -> Flag {
                             if (q.block == "kNew" && q.walked.cell_count() > 3) return false;
                             if (q.block == "kOldNear") return near;
                             return {};
                         },
                         [=](const Question& q) -> Number {
                             if (q.block == "kOldSteps" || q.block == "kOldFar") return number(q);
                             return {};
                         }};
        };
        add(32, "steps", "64 steps",
            with_twisted_walk(valid("torus"),
                              old_corner(true, [](const Question&) { return std::uint64_t{64}; })));
        const auto base = [](const Question& q) {
            return std::uint64_t{q.walked.begin(q.walked.cell_count() - 1)};
        };
        add(33, "age", "a facet older than the first",
            with_twisted_walk(valid("torus"), old_corner(false, base)));
        add(34, "gone", "the entry facet of cell 1",
            with_twisted_walk(valid("torus"), old_corner(false, [=](const Question& q) {
                                  return base(q) - 1 - q.walked.begin(1);
                              })));
        const auto apex = [](bool near, auto number) {
            return Twist{[=](const Question& q) -> Flag {
                             if (q.walked.cell_count() < 2) return {};
                             if (q.block == "kNear") return near;
                             if (q.block == "kLowest" || q.block == "kNew" || q.block == "kNext")
                                 return false;
                             return {};
                         },
                         [=](const Question& q) -> Number {
                             if (q.block == "kOldFar" || q.block == "kNearRank") return number(q);
                             return {};
                         }};
        };
        add(35, "gate", "the apex is corner 0",
            with_twisted_walk(valid("box"), apex(false, [](const Question& q) {
                                  const Id corner =
                                      q.walked.vertex[q.walked.begin(q.walked.cell_count() - 1)];
                                  return std::uint64_t{q.walked.vertex_count - 1 - corner};
                              })));
        add(36, "rank", "rank 64", with_twisted_walk(valid("box"), apex(true, [](const Question&) {
                                                         return std::uint64_t{64};
                                                     })));
        add(37, "age", "an apex older than vertex 0",
            with_twisted_walk(valid("box"), apex(false, [](const Question& q) {
                                  return std::uint64_t{q.walked.vertex_count};
                              })));
    }

    void positions() {
        const auto head = [&](int row, const char* name, const char* says, const char* file,
                              std::size_t at, unsigned value) {
            add(row, name, says, raw_changed(file, SectionId::positions, [&](Bytes& raw) {
                    raw[at] = byte(value);
                }));
        };
        head(38, "bit-0", "bit 0 of flags", "two-quads", 0, 1);
        head(38, "base", "a decimal base without lossless", "two-quads", 0, 16);
        head(38, "base-3", "base is 3", "decimals", 0, 48);
        head(39, "places", "23 decimal places", "decimals", 2, 46);
        head(39, "digits", "18 digits", "digits", 3, 18);
        // flags, fitted, places, digits; then echo_count, look, mirrored, offsets.
        const auto echoes = [](unsigned count, unsigned look, unsigned mirrored,
                               std::int64_t offset) {
            return [=](Bytes& raw) {
                ByteWriter out;
                out.u8(16 | 64);
                out.u8(0);
                out.varint(0);
                out.u8(0);
                out.u8(static_cast<std::uint8_t>(count));
                out.u8(static_cast<std::uint8_t>(look));
                for (unsigned e = 0; e < count; ++e) {
                    out.u8(static_cast<std::uint8_t>(mirrored));
                    out.varint(zigzag(offset));
                    out.varint(0);
                    out.varint(0);
                }
                raw = out.take();
            };
        };
        constexpr std::int64_t kMost = std::int64_t{1} << 53;
        const auto echo = [&](const char* name, const char* says, auto change) {
            add(40, name, says, raw_changed("quad", SectionId::positions, change));
        };
        echo("none", "no echoes", echoes(0, 3, 0, 0));
        echo("nine", "nine echoes", echoes(9, 3, 0, 0));
        echo("cubes", "cube_bits is 53", echoes(1, 53, 0, 0));
        echo("mirrored", "mirrored is 8", echoes(1, 3, 8, 0));
        echo("offset", "an offset of 2^53 + 1", echoes(1, 3, 1, kMost + 1));
        add(41, "weight", "a weight of 32768",
            raw_changed("two-quads", SectionId::positions, [](Bytes& raw) {
                ByteWriter out;
                out.u8(0);
                out.u8(1);  // of seed
                out.varint(zigzag(32768));
                out.varint(0);
                out.raw(std::span(raw).subspan(2));
                raw = out.take();
            }));
        const auto numbers = [](std::int64_t x, std::int64_t y, std::int64_t z) {
            Position p;
            p[0].whole = x, p[1].whole = y, p[2].whole = z;
            return p;
        };
        add(42, "grid", "2^40 on a grid",
            with_positions(quads(), {{numbers(std::int64_t{1} << 40, 0, 0)}, {}, {}}));
        add(42, "whole", "-2^53",
            with_positions(valid("decimals"), {{numbers(-kMost, 0, 0)}, {}, {}}));
        // Vertex 2 is guessed where vertex 1 is; the echo of vertex 0 lies beyond.
        add(43, "echo", "an echo at 2^53 + 1",
            with_positions(valid("quad"), {{numbers(-1, 0, 0), numbers(kMost - 1, 0, 0), {}},
                                           {{"echo", true}, {"same", true}},
                                           echoes(1, 4, 1, kMost)}));
        const auto form = [](int places, int digits) {
            return [=](Bytes& raw) {
                ByteWriter out;
                out.u8(16);
                out.u8(0);
                out.varint(zigzag(places));
                out.u8(static_cast<std::uint8_t>(digits));
                raw = out.take();
            };
        };
        Position small{};
        small[0].rest = 5;
        small[0].zeros = 3;
        add(44, "zero", "a rest of 0 behind whole_zero",
            with_positions(valid("digits"), {{Position{}}, {{"whole_zero", false}}, form(0, 3)}));
        small[0].rest = 1023;
        add(44, "ten", "a rest of 1023 with three digits",
            with_positions(valid("digits"), {{small}, {}, form(0, 3)}));
        small[0].rest = 123;
        add(45, "places", "17 places, 3 zeros and 3 digits",
            with_positions(valid("digits"), {{small}, {}, form(17, 3)}));
        add(46, "origin", "positions end in place_origin",
            raw_changed("tet", SectionId::positions, [](Bytes& raw) { raw.resize(12); }),
            Code::truncated);
    }

    void riders() {
        add(47, "count", "one companion block more than there are",
            block_changed("companions", CellKind::tet, [](BlockHead& b) { ++b.companions; }));
        add(49, "tuples", "one tuple more than points",
            head_changed("attributes", [](Head& h) { ++h.attributes[0].tuples; }));
        const auto names = [&](const char* name, const char* says, auto change) {
            add(51, name, says, raw_changed("attributes", SectionId::names, change));
        };
        names("count", "name_count is 100", [](Bytes& raw) { raw[0] = byte(100); });
        names("dimension", "dimension is 4", [](Bytes& raw) { raw[8] = byte(8); });
        add(52, "kind", "an order of no known kind",
            raw_changed("order", SectionId::order, [](Bytes& raw) { raw[0] = byte(255); }));
    }

    std::map<std::string, Bytes> valid_;
    std::vector<InvalidFile> made_;
};

}  // namespace

std::vector<InvalidFile> invalid_files() {
    Maker maker;
    maker.make();
    return maker.take();
}

}  // namespace ravel::test
