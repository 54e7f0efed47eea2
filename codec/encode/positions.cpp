#include "encode/positions.h"

#include <algorithm>
#include <cmath>

#include "encode/echoes.h"
#include "encode/fit.h"
#include "entropy/priors.h"
#include "predict/border_plane.h"
#include "predict/priors.h"

namespace ravel {
namespace {

// Writes flags and bits into a FlagEncoder, for code_residual.
struct WritingCoder {
    static constexpr bool kWrites = true;
    FlagEncoder& out;
    std::vector<FlagModel> models =
        models_of(kResidualPriors, ResidualContexts::count, kResidualPriorSeen);
    bool flag(Context context, bool truth) {
        out.flag(models[context], truth);
        return truth;
    }
    std::uint64_t plain(std::uint64_t truth, int count) {
        out.plain(truth, count);
        return truth;
    }
};

// Only counts what they would cost.
struct CountingCoder {
    static constexpr bool kWrites = true;
    double bits = 0;
    std::vector<FlagModel> models =
        models_of(kResidualPriors, ResidualContexts::count, kResidualPriorSeen);
    bool flag(Context context, bool truth) {
        FlagModel& model = models[context];
        bits += model.cost(truth);
        model.update(truth);
        return truth;
    }
    std::uint64_t plain(std::uint64_t truth, int count) {
        bits += count;
        return truth;
    }
};

// Cubes of about the mean distance of a vertex to its first neighbour.
int cube_bits_of(const WalkRecord& record, const std::vector<Point3>& places,
                 const std::vector<bool>& skip) {
    double length = 0, count = 0;
    for (std::size_t v = 0; v < record.stencils.size(); ++v) {
        const Stencil& s = record.stencils[v];
        if (s.configuration == Configuration::seed || skip[v] || skip[s.at[0]]) continue;
        for (std::size_t axis = 0; axis < 3; ++axis)
            length += std::abs(places[v][axis] - places[s.at[0]][axis]);
        ++count;
    }
    int bits = 0;
    if (count > 0) std::frexp(length / count, &bits);
    return std::clamp(bits, 1, kMostCubeBits - 1);
}

// Do vertices often share a coordinate that their first neighbours share? Looks at some thousand.
bool has_level_faces(const WalkRecord& record, const std::vector<Point3>& places) {
    constexpr std::size_t kLooks = 4096;
    const std::size_t stride = record.stencils.size() / kLooks + 1;
    std::size_t shared = 0, kept = 0;
    for (std::size_t v = 0; v < record.stencils.size(); v += stride) {
        const Stencil& s = record.stencils[v];
        if (s.at[0] == kNone || s.at[1] == kNone) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double level = places[s.at[0]][axis];
            if (places[s.at[1]][axis] != level) continue;
            ++shared;
            kept += places[v][axis] == level;
        }
    }
    return 32 * kept > shared;
}

// Do enough of the vertices of tets that could go on with a border lie near its plane to pay for
// asking? Looks at some thousand.
bool goes_along(const WalkRecord& record, const std::vector<Point3>& places) {
    constexpr std::size_t kLooks = 4096;
    const std::size_t stride = record.stencils.size() / kLooks + 1;
    std::size_t asked = 0, near = 0;
    for (std::size_t v = 0; v < record.stencils.size(); v += stride) {
        const Stencil& s = record.stencils[v];
        if (s.borders == 0) continue;
        ++asked;
        near += stencil_along(s, places, places[v]).configuration == Configuration::border;
    }
    return 4 * near > asked;
}

// Were most vertices told by leaders? Then tets repeat, and so do the levels of their vertices.
bool is_lattice(const WalkRecord& record) {
    const auto led = std::count_if(
        record.stencils.begin(), record.stencils.end(),
        [](const Stencil& stencil) { return stencil.configuration == Configuration::led; });
    return 2 * static_cast<std::size_t>(led) > record.stencils.size();
}

Bytes head_of(const PositionFormat& format) {
    ByteWriter out;
    unsigned fitted = 0;
    for (std::size_t c = 0; c < kConfigurations; ++c)
        if (format.weights[c] != kDefaultWeights[c]) fitted |= 1u << c;
    out.u8(static_cast<std::uint8_t>(
        (format.has_follows ? 1 : 0) | (format.has_along ? 2 : 0) | (format.has_escapes ? 4 : 0) |
        (format.numbers.has_minus_zero ? 8 : 0) | static_cast<int>(format.numbers.base) << 4 |
        (format.echoes.empty() ? 0 : 64) | (format.has_levels ? 128 : 0)));
    out.u8(static_cast<std::uint8_t>(fitted));
    if (!format.grid()) {
        out.varint(zigzag(format.numbers.places));
        out.u8(static_cast<std::uint8_t>(format.numbers.digits));
    }
    if (!format.echoes.empty()) {
        out.u8(static_cast<std::uint8_t>(format.echoes.size()));
        out.u8(static_cast<std::uint8_t>(format.cube_bits | (format.looks_far ? 128 : 0)));
        for (const Echo& echo : format.echoes) {
            out.u8(static_cast<std::uint8_t>((echo.mirrored[0] ? 1 : 0) |
                                             (echo.mirrored[1] ? 2 : 0) |
                                             (echo.mirrored[2] ? 4 : 0)));
            for (const std::int64_t offset : echo.offset) out.varint(zigzag(offset));
        }
    }
    if (format.has_levels)
        out.u8(static_cast<std::uint8_t>(format.level_bits | (format.has_pairs ? 128 : 0)));
    for (std::size_t c = 0; c < kConfigurations; ++c)
        for (std::size_t i = 0; i < kFeatureCount[c] && (fitted >> c & 1); ++i)
            out.varint(zigzag(format.weights[c][i]));
    if (format.has_stand_ins) {
        for (const double x : format.place_origin) out.f64(x);
        out.f64(format.place_scale);
    }
    return out.take();
}

// What is to be coded, in order.
struct CodedVertices {
    const PositionPlan& plan;
    const Complex& complex;
    const WalkRecord& record;
    const std::vector<Index>& unused;
    const EdgePoints& edges;

    std::size_t vertices() const { return record.vertex_of.size(); }
    std::size_t size() const { return vertices() + unused.size(); }
};

// The first `size`. `coded(i)`: is the i-th to be coded, or only to be known to those that are?
template <class Coder, class Coded>
void code_vertices(Coder& coder, const CodedVertices& all, std::size_t size, const Coded& coded) {
    PositionCodes<Coder> codes(coder, all.plan.format, all.size());
    codes.reserve(size);
    for (std::size_t i = 0; i < size; ++i) {
        const bool used = i < all.vertices();
        if (used && all.record.copy_of[i] != kNone) {
            codes.copy(all.record.copy_of[i]);
            continue;
        }
        const std::size_t p =
            used ? all.complex.point[all.record.vertex_of[i]] : all.unused[i - all.vertices()];
        const Stencil stencil =
            used ? all.record.stencils[i]
                 : stencil_of_unused(all.edges, i - all.vertices(), all.vertices());
        if (coded(i))
            codes.next(stencil, all.plan.values[p]);
        else
            codes.skip(stencil, all.plan.values[p]);
    }
}

Bytes write_head_and_bits(const CodedVertices& all) {
    ByteWriter out;
    out.raw(head_of(all.plan.format));
    FlagEncoder bits;
    WritingCoder coder{bits};
    code_vertices(coder, all, all.size(), [](std::size_t) { return true; });
    out.raw(bits.finish());
    return out.take();
}

// About how many bytes that would make. Of large meshes a stretch of vertices in each three is
// looked at, of very large ones only as far as kMost.
double try_out(const CodedVertices& all) {
    constexpr std::size_t kStretch = 256, kAll = 8192, kMost = 131072;
    const std::size_t size = std::min(all.size(), kMost);
    const bool whole = all.size() <= kAll;
    std::size_t count = 0;
    CountingCoder coder;
    code_vertices(coder, all, size, [&](std::size_t i) {
        const bool coded = whole || i / kStretch % 3 == 0;
        count += coded;
        return coded;
    });
    const double share =
        count == 0 ? 1 : static_cast<double>(all.size()) / static_cast<double>(count);
    return static_cast<double>(head_of(all.plan.format).size()) +
           coder.bits / 8 * (whole ? 1 : share);
}

}  // namespace

Bytes write_positions(PositionPlan& plan, const Complex& complex, const WalkRecord& record,
                      const std::vector<Index>& unused, const EdgePoints& edges, bool fast) {
    const std::size_t vertices = record.vertex_of.size();
    std::vector<Point3> places(vertices), firm;  // firm: no copies, none escaped
    std::vector<bool> skip(vertices, false);
    firm.reserve(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
        const std::size_t p = complex.point[record.vertex_of[v]];
        skip[v] = record.copy_of[v] != kNone || plan.values[p][0].escaped ||
                  plan.values[p][1].escaped || plan.values[p][2].escaped;
        places[v] = units_of(plan, p);
        if (!skip[v]) firm.push_back(places[v]);
    }
    const auto fit = [&](bool along) {
        plan.format.weights =
            fit_weights(record.stencils, places, skip, plan.format.mirrored, along);
    };
    plan.format.cube_bits = cube_bits_of(record, places, skip);
    const bool may_go_along = goes_along(record, places);
    plan.format.has_along = fast && may_go_along;
    fit(plan.format.has_along);

    const CodedVertices all{plan, complex, record, unused, edges};
    if (fast) {
        plan.format.has_levels = is_lattice(record);
        plan.format.level_bits = plan.format.cube_bits;
        return write_head_and_bits(all);
    }

    // What helps one mesh costs another a flag per vertex, and costs time: it stays where it makes
    // the bytes fewer, of large meshes by a hundredth at least.
    constexpr std::size_t kSmall = 6000;
    constexpr double kSlow = 0.02;      // of what costs more time
    constexpr double kHopeless = 1.02;  // where levels make more, pairs are no help either
    PositionFormat kept = plan.format;
    double best = -1;  // not known yet
    // Returns how many times as many bytes it makes.
    const auto offer = [&](double worth = 0.01) {
        if (best < 0) {
            std::swap(kept, plan.format);
            best = try_out(all);
            std::swap(kept, plan.format);
        }
        const double bytes = try_out(all);
        const double ratio = bytes / best;
        if (ratio < (vertices < kSmall ? 1 : 1 - worth))
            best = bytes, kept = plan.format;
        else
            plan.format = kept;
        return ratio;
    };
    constexpr std::size_t kLarge = 200000;  // vertices from which fewer things are tried
    const Echoes echoes = find_echoes(firm, plan.format.numbers.digits == 0);
    plan.format.echoes = echoes.likely;
    if (!echoes.likely.empty()) offer();
    if (!echoes.more.empty() && vertices < kLarge) {
        for (const Echo& echo : echoes.more)
            if (plan.format.echoes.size() < kMostEchoes) plan.format.echoes.push_back(echo);
        offer();
    }
    if (!plan.format.echoes.empty() && vertices < kLarge / 4) {
        plan.format.looks_far = true;
        offer();
    }
    if (vertices < kSmall || has_level_faces(record, places)) {
        plan.format.has_levels = true;
        offer();
    }
    plan.format.has_levels = true;
    plan.format.level_bits = plan.format.cube_bits;
    const bool may_have_pairs = offer() < kHopeless;
    if (plan.format.level_bits > 0 && vertices < kLarge / 4) {
        ++plan.format.level_bits;
        offer();
    }
    // Pairs may be known where single levels tell nothing.
    if (may_have_pairs && (kept.level_bits > 0 || vertices < kLarge)) {
        if (kept.level_bits == 0) plan.format.level_bits = plan.format.cube_bits;
        plan.format.has_levels = plan.format.has_pairs = true;
        offer(kSlow);
    }
    // What was taken first may be no help beside it.
    if (kept.level_bits > 0 && !kept.echoes.empty()) {
        plan.format.echoes.clear();
        offer();
    }
    if (may_go_along) {
        plan.format.has_along = true;
        fit(true);
        offer();
    }
    std::size_t seeds = 0;
    for (const Stencil& stencil : record.stencils)
        seeds += stencil.configuration == Configuration::seed;
    if (seeds > 4) {
        plan.format.has_follows = true;
        offer();
    }
    return write_head_and_bits(all);
}

}  // namespace ravel
