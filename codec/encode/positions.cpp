#include "encode/positions.h"

#include <bit>

#include "encode/fit.h"
#include "encode/position_pass.h"
#include "entropy/priors.h"
#include "predict/priors.h"
#include "predict/residual_models.h"

namespace ravel {
namespace {

// Writes flags and bits into a FlagEncoder, for code_residual.
struct WritingCoder {
    static constexpr bool kWrites = true;
    FlagEncoder& out;
    std::vector<FlagModel> models =
        with_size_kinds(models_of(kResidualPriors, ResidualContexts::count, kResidualPriorSeen));
    bool flag(Context context, bool truth) {
        out.flag(models[context], truth);
        return truth;
    }
    double cost(Context context, bool truth) const { return models[context].cost(truth); }
    std::uint64_t plain(std::uint64_t truth, int count) {
        out.plain(truth, count);
        return truth;
    }
    std::uint64_t rice(std::uint64_t truth, int count) {
        out.rice(truth, count);
        return truth;
    }
};

// A bit for each set of weights that is not as in `usual`.
unsigned fitted_of(const Weights& weights, const Weights& usual) {
    unsigned fitted = 0;
    for (std::size_t c = 0; c < kWeightSets; ++c)
        if (weights[c] != usual[c]) fitted |= 1u << c;
    return fitted;
}

}  // namespace

CodedPositions in_order(const PositionPlan& plan, const Complex& complex, const WalkRecord& record,
                        const std::vector<Index>& unused, const EdgePoints& edges) {
    CodedPositions all{plan, complex, record, unused, edges, {}};
    all.values.reserve(all.size());
    for (const Id v : record.vertex_of) all.values.push_back(plan.values[complex.point[v]]);
    for (const Index p : unused) all.values.push_back(plan.values[p]);
    return all;
}

Bytes position_head_of(const PositionFormat& format) {
    ByteWriter out;
    unsigned fitted = fitted_of(format.weights, kDefaultWeights);
    const unsigned beside = fitted_of(format.weights, without_triangles(kDefaultWeights));
    if (std::popcount(beside) < std::popcount(fitted)) fitted = beside | kNoTriangleDefaults;
    out.u8(static_cast<std::uint8_t>(
        (format.has_follows ? 1 : 0) | (format.has_along ? 2 : 0) | (format.has_escapes ? 4 : 0) |
        (format.numbers.has_minus_zero ? 8 : 0) | static_cast<int>(format.numbers.base) << 4 |
        (format.echoes.empty() ? 0 : 64) | (format.has_levels ? 128 : 0)));
    if (!format.rounds.empty()) fitted |= kHasRounds;
    if (format.has_rice) fitted |= kHasRice;
    out.varint(fitted);
    if (!format.grid()) {
        out.varint(zigzag(format.numbers.places));
        out.u8(static_cast<std::uint8_t>(format.numbers.digits));
    }
    if (!format.echoes.empty()) {
        out.u8(static_cast<std::uint8_t>(format.echoes.size()));
        out.u8(static_cast<std::uint8_t>(format.cube_bits));
        for (const Echo& echo : format.echoes) {
            out.u8(static_cast<std::uint8_t>((echo.mirrored[0] ? 1 : 0) |
                                             (echo.mirrored[1] ? 2 : 0) |
                                             (echo.mirrored[2] ? 4 : 0)));
            for (const std::int64_t offset : echo.offset) out.varint(zigzag(offset));
        }
    }
    if (format.has_levels)
        out.u8(static_cast<std::uint8_t>(format.level_bits | (format.has_pairs ? 128 : 0)));
    for (std::size_t c = 0; c < kWeightSets; ++c) {
        if ((fitted >> c & 1) == 0) continue;
        const int grain = grain_of(format.weights[c]);
        out.u8(static_cast<std::uint8_t>(grain));
        for (std::size_t i = 0; i < kFeatureCount[c]; ++i)
            out.varint(zigzag(format.weights[c][i] >> grain));
    }
    if (!format.rounds.empty()) {
        out.u8(static_cast<std::uint8_t>(format.rounds.count));
        out.u8(static_cast<std::uint8_t>(format.rounds.slack));
    }
    for (std::size_t f = 0; f < format.rounds.count; ++f) {
        const RoundFace& face = format.rounds.face[f];
        out.u8(static_cast<std::uint8_t>(face.kind));
        for (const std::int64_t x : face.centre) out.varint(zigzag(x));
        for (std::size_t k = 0; k < 3 && face.kind != RoundKind::sphere; ++k)
            out.varint(zigzag(face.axis[k]));
        out.varint(static_cast<std::uint64_t>(face.radius));
        if (face.kind == RoundKind::torus) out.varint(static_cast<std::uint64_t>(face.ring));
    }
    if (format.has_stand_ins) {
        for (const double x : format.place_origin) out.f64(x);
        out.f64(format.place_scale);
    }
    return out.take();
}

Bytes write_positions(const CodedPositions& all, const ChosenFormat& chosen) {
    ByteWriter out;
    out.raw(position_head_of(chosen.format));
    FlagEncoder bits;
    WritingCoder coder{bits};
    code_positions(coder, all, chosen.format, chosen.leads, all.size(),
                   [](std::size_t) { return true; });
    out.raw(bits.finish());
    return out.take();
}

}  // namespace ravel
