// Rows 29 to 46 of chapter 14.
#include "spec/invalid_maker.h"
#include "spec/twist.h"

namespace ravel::test {

void InvalidMaker::walks() {
    using Flag = std::optional<bool>;
    using Number = std::optional<std::uint64_t>;
    const Twist itself{
        [](const Question& q) -> Flag { return q.block == "kCopyNear" ? Flag(false) : Flag(); },
        [](const Question& q) -> Number {
            return q.block == "kCopyOf" ? Number(2 * std::uint64_t{q.walked.vertex_count - 1})
                                        : Number();
        }};
    add(29, "later", "a copy of itself", with_twisted_walk(valid("moebius"), itself));
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
    // Neither across an edge nor new nor near.
    const auto fold = [](std::uint64_t rank, auto age) {
        return Twist{[=](const Question& q) -> Flag {
                         if (q.walked.cell_count() < 2) return {};
                         if (q.block == "kFold" || q.block == "kFoldNew" || q.block == "kFoldNear")
                             return false;
                         return {};
                     },
                     [=](const Question& q) -> Number {
                         if (q.block == "kFoldRank") return rank;
                         if (q.block == "kFoldAge") return age(q);
                         return {};
                     }};
    };
    const auto oldest = [](const Question& q) { return std::uint64_t{q.walked.vertex_count}; };
    add(35, "fold-gate", "by folds, the apex is corner 0",
        with_twisted_walk(valid("folds"), fold(247, [](const Question& q) {
                              const Id corner =
                                  q.walked.vertex[q.walked.begin(q.walked.cell_count() - 1)];
                              return std::uint64_t{q.walked.vertex_count - 1 - corner};
                          })));
    add(36, "fold-rank", "by folds, more vertices than the search meets",
        with_twisted_walk(valid("folds"), fold(246, oldest)));
    add(37, "fold-age", "by folds, an apex older than vertex 0",
        with_twisted_walk(valid("folds"), fold(247, oldest)));
}

void InvalidMaker::positions() {
    const auto head = [&](int row, const char* name, const char* says, const char* file,
                          std::size_t at, unsigned value) {
        add(row, name, says,
            raw_changed(file, SectionId::positions, [&](Bytes& raw) { raw[at] = byte(value); }));
    };
    head(38, "along", "polygons that go on with a border", "two-quads", 0, 2);
    head(38, "base", "a decimal base without lossless", "two-quads", 0, 16);
    head(38, "base-3", "base is 3", "decimals", 0, 48);
    head(39, "places", "23 decimal places", "decimals", 2, 46);
    head(39, "digits", "18 digits", "digits", 3, 18);
    // flags, fitted, places, digits; then echo_count, look, mirrored, offsets.
    const auto echoes = [](unsigned count, unsigned look, unsigned mirrored, std::int64_t offset) {
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
    echo("cubes", "cube_bits is 55", echoes(1, 55, 0, 0));
    echo("mirrored", "mirrored is 8", echoes(1, 3, 8, 0));
    echo("offset", "an offset of 2^53 + 1", echoes(1, 3, 1, kMost + 1));
    // With flags, no weights, and what the first flag asks for.
    const auto headed = [&](int row, const char* name, const char* says, std::uint8_t flags,
                            std::uint8_t value) {
        add(row, name, says, raw_changed("two-quads", SectionId::positions, [=](Bytes& raw) {
                ByteWriter out;
                out.u8(flags);
                out.u8(0);
                out.u8(value);
                out.raw(std::span(raw).subspan(3));
                raw = out.take();
            }));
    };
    headed(40, "levels", "level_bits is 55", 128, 55);
    headed(40, "pairs", "has_pairs where level_bits is 0", 128, 128);
    const auto weight = [&](const char* name, const char* says, unsigned grain,
                            std::int64_t steps) {
        add(41, name, says, raw_changed("two-quads", SectionId::positions, [=](Bytes& raw) {
                ByteWriter out;
                out.u8(0);
                out.u8(1);  // of seed
                out.u8(static_cast<std::uint8_t>(grain));
                out.varint(zigzag(steps));
                out.varint(0);
                out.raw(std::span(raw).subspan(2));
                raw = out.take();
            }));
    };
    weight("weight", "a weight of 32768", 0, 32768);
    weight("grain-weight", "a weight of 512 times 64", 6, 512);
    weight("grain", "grain is 16", 16, 0);
    add(41, "fitted", "fitted is 2^20",
        raw_changed("two-quads", SectionId::positions, [](Bytes& raw) {
            ByteWriter out;
            out.u8(0);
            out.varint(2 * kHasRice);
            out.raw(std::span(raw).subspan(2));
            raw = out.take();
        }));
    // Faces so far off that no vertex lies on them, put in before the bits: nothing but the head
    // is wrong. `bits_at`: in the section as it is, which has no weights.
    constexpr std::int64_t kFar = kMostRoundLength;
    const RoundFace far{RoundKind::torus, {kFar, -kFar, kFar}, {0, 0, 1}, 32, 64};
    const auto with_rounds = [&](const char* file, std::size_t bits_at, unsigned count,
                                 unsigned slack, const RoundFace& face) {
        return raw_changed(file, SectionId::positions, [=](Bytes& raw) {
            ByteWriter out;
            out.u8(static_cast<std::uint8_t>(raw[0]));
            out.varint(kHasRounds);
            out.raw(std::span(raw).first(bits_at).subspan(2));
            out.u8(static_cast<std::uint8_t>(count));
            out.u8(static_cast<std::uint8_t>(slack));
            for (unsigned f = 0; f < count; ++f) {
                out.u8(static_cast<std::uint8_t>(face.kind));
                for (const std::int64_t x : face.centre) out.varint(zigzag(x));
                for (const std::int64_t x : face.axis) out.varint(zigzag(x));
                out.varint(static_cast<std::uint64_t>(face.radius));
                if (face.kind == RoundKind::torus)
                    out.varint(static_cast<std::uint64_t>(face.ring));
            }
            out.raw(std::span(raw).subspan(bits_at));
            raw = out.take();
        });
    };
    for (const unsigned count : {1u, 16u})
        if (!decode(with_rounds("shell", 2, count, 53, far)))
            throw std::runtime_error("faces that are far off are refused");
    const auto round = [&](const char* name, const char* says, const RoundFace& face,
                           unsigned count = 1, unsigned slack = 0) {
        add(8, name, says, with_rounds("shell", 2, count, slack, face));
    };
    const auto changed = [&](auto change) {
        RoundFace face = far;
        change(face);
        return face;
    };
    add(8, "alone", "round faces, but nothing goes on with borders",
        with_rounds("box", 3, 1, 0, far));
    round("none", "no round faces", far, 0);
    round("seventeen", "seventeen round faces", far, 17);
    round("slack", "round_slack is 54", far, 1, 54);
    round("kind", "a face of kind 3", changed([](RoundFace& f) { f.kind = RoundKind::count; }));
    round("centre", "a centre at 2^58 + 1", changed([](RoundFace& f) { ++f.centre[0]; }));
    round("axis", "an axis of -2^51 - 1",
          changed([](RoundFace& f) { f.axis[2] = -kMostRoundAxis - 1; }));
    round("radius", "a radius of 2^58 + 1", changed([](RoundFace& f) { f.radius = kFar + 1; }));
    round("ring", "a ring of 2^58 + 1", changed([](RoundFace& f) { f.ring = kFar + 1; }));
    const auto numbers = [](std::int64_t x, std::int64_t y, std::int64_t z) {
        Position p;
        p[0].whole = x, p[1].whole = y, p[2].whole = z;
        return p;
    };
    add(42, "grid", "2^40 on a grid",
        with_positions(quads(), {{numbers(std::int64_t{1} << 40, 0, 0)}, {}, {}}));
    add(42, "whole", "-2^53", with_positions(valid("decimals"), {{numbers(-kMost, 0, 0)}, {}, {}}));
    // Vertex 2 is guessed where vertex 1 is; the echo of vertex 0 lies beyond.
    add(43, "echo", "an echo at 2^53 + 1",
        with_positions(valid("quad"), {{numbers(-1, 0, 0), numbers(kMost - 1, 0, 0), {}},
                                       {{"echo", true}, {"same", true}},
                                       echoes(1, 4, 1, kMost)}));
    // Both parts before may lead the third.
    add(43, "lead", "a leader at place 16 of two",
        with_positions(
            valid("nine-apart"),
            {std::vector<Position>(12), {{"lead", false}, {"lead_place", true}}, [](Bytes& raw) {
                 raw = {std::byte{1}, std::byte{0}};
             }}));
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

}  // namespace ravel::test
