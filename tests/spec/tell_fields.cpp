#include "spec/tell_fields.h"

#include <algorithm>
#include <cstdio>

namespace ravel::test {

std::string hex(std::span<const std::byte> bytes) {
    std::string text;
    char two[8];
    for (const std::byte b : bytes) {
        std::snprintf(two, sizeof two, text.empty() ? "%02X" : " %02X", static_cast<unsigned>(b));
        text += two;
    }
    return text;
}
// The same, but of many bytes only how many.
std::string data_hex(std::span<const std::byte> bytes) {
    return bytes.size() <= 400 ? hex(bytes) : "(" + std::to_string(bytes.size()) + " bytes)";
}
std::string number_text(double x, bool narrow) {
    char text[40];
    std::snprintf(text, sizeof text, narrow ? "%.9g" : "%.17g", x);
    return text;
}

void tell_head(Fields f) {
    const unsigned flags = f.u8("flags");
    if ((flags & 4) == 0) {
        const unsigned bits = f.u8("position_bits");
        const bool narrow = (flags & 16) != 0;
        f.real("step", narrow);
        for (int axis = 0; axis < 3; ++axis)
            if ((flags & 32) != 0)
                f.signed_varint((bits & 128) != 0 ? "origin / coarse step" : "origin / step");
            else
                f.real("origin", narrow);
        if ((flags & 64) == 0) f.real("bound", narrow);
        f.u8("error");
    }
    const std::uint64_t count = (flags & 128) != 0 ? f.varint("attribute_count") : 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        f.text("name");
        f.u8("kind");
        const std::uint64_t width = f.varint("width");
        f.varint("tuples");
        const std::uint64_t references = width & 1 ? f.varint("reference_count") : 0;
        for (std::uint64_t r = 0; r < references; ++r) {
            f.varint("component * 2 + to_cells");
            f.signed_varint("base");
        }
    }
}

void tell_block(Fields f, bool tets) {
    const unsigned flags = f.u8("flags");
    f.varint("cells");
    if (!tets && f.varint("uniform_degree") == 0) f.varint("corners");
    f.varint("vertices");
    if (flags & 4) f.varint("points");
    const unsigned told = f.u8("told");
    unsigned i = 0;
    for (const char* name : {"unused_points", "companions", "components", "links", "shape_step"})
        if ((told >> i++ & 1) != 0) f.varint(name);
    if (!tets) return;
    f.varint("grid_side");
    for (int axis = 0; axis < 3; ++axis) f.varint("grid_count");
}

namespace {

void tell_round_faces(Fields& f, PositionFormat& format) {
    format.rounds.count = f.u8("round_count");
    format.rounds.slack = static_cast<int>(f.u8("round_slack"));
    format.rounds.count = std::min(format.rounds.count, kMostRoundFaces);
    for (std::size_t i = 0; i < format.rounds.count; ++i) {
        RoundFace& face = format.rounds.face[i];
        face.kind = static_cast<RoundKind>(f.u8("kind"));
        for (std::int64_t& x : face.centre) x = f.signed_varint("centre");
        if (face.kind != RoundKind::sphere)
            for (std::int64_t& x : face.axis) x = f.signed_varint("axis");
        face.radius = static_cast<std::int64_t>(f.varint("radius"));
        if (face.kind == RoundKind::torus) face.ring = static_cast<std::int64_t>(f.varint("ring"));
    }
}

}  // namespace

PositionFormat tell_position_head(Fields& f, const Head& head, const BlockHead& block) {
    PositionFormat format;
    format.narrow = head.position_scalar == Scalar::f32;
    format.mirrored = block.mirrored;
    format.leaders_move = block.leaders_move;
    const unsigned flags = f.u8("flags");
    const std::uint64_t fitted = f.varint("fitted");
    format.has_escapes = (flags & 4) != 0;
    format.numbers.has_minus_zero = (flags & 8) != 0;
    format.numbers.base = static_cast<NumberBase>(flags >> 4 & 3);
    format.has_levels = (flags & 128) != 0;
    format.has_follows = (flags & 1) != 0;
    format.has_along = (flags & 2) != 0;
    if (head.lossless) {
        format.numbers.places = static_cast<int>(f.signed_varint("places"));
        format.numbers.digits = static_cast<int>(f.u8("digits"));
    }
    if (flags & 64) {
        const unsigned count = f.u8("echo_count");
        format.cube_bits = static_cast<int>(f.u8("cube_bits"));
        for (unsigned e = 0; e < count; ++e) {
            Echo echo;
            const unsigned mirrored = f.u8("mirrored");
            for (std::size_t k = 0; k < 3; ++k) {
                echo.mirrored[k] = (mirrored >> k & 1) != 0;
                echo.offset[k] = f.signed_varint("offset");
            }
            format.echoes.push_back(echo);
        }
    }
    if (format.has_levels) {
        const unsigned levels = f.u8("levels");
        format.level_bits = static_cast<int>(levels & 127);
        format.has_pairs = (levels & 128) != 0;
    }
    if ((fitted & kNoTriangleDefaults) != 0) format.weights = without_triangles(format.weights);
    for (std::size_t c = 0; c < kWeightSets; ++c) {
        if ((fitted >> c & 1) == 0) continue;
        const unsigned grain = f.u8("grain");
        for (std::size_t i = 0; i < kFeatureCount[c]; ++i)
            format.weights[c][i] =
                static_cast<std::int16_t>(f.signed_varint("weight") * (std::int64_t{1} << grain));
    }
    format.has_rice = (fitted & kHasRice) != 0;
    if ((fitted & kHasRounds) != 0) tell_round_faces(f, format);
    format.has_stand_ins = head.lossless && head.kind == CellKind::tet;
    if (format.has_stand_ins) {
        for (double& x : format.place_origin) x = f.real("place_origin", false);
        format.place_scale = f.real("place_scale", false);
    }
    if (head.kind == CellKind::tet)
        format.usual_start = usual_start_of(format, static_cast<double>(block.grid_side));
    return format;
}

PositionFormat position_format_of(const Bytes& positions, const Head& head, const BlockHead& block,
                                  std::size_t& bits_at) {
    std::string untold;
    Fields fields(positions, untold);
    PositionFormat format = tell_position_head(fields, head, block);
    bits_at = positions.size() - fields.rest().size();
    return format;
}

}  // namespace ravel::test
