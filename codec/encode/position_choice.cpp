// Which means a mesh's positions are to be coded by: what looks promising is tried out.
#include <algorithm>
#include <cmath>
#include <utility>

#include "encode/echoes.h"
#include "encode/fit.h"
#include "encode/follow_plan.h"
#include "encode/position_proposals.h"
#include "encode/position_trials.h"
#include "encode/round_search.h"
#include "encode/threads.h"
#include "predict/round_faces.h"

namespace ravel {
namespace {

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
    return std::clamp(bits, 1, kMostCubeBits - 2);  // two more may be tried
}

// Calls look(stencil, vertex) for some thousand vertices, evenly along the walk.
template <class Look>
void look_at_some(const WalkRecord& record, const Look& look) {
    constexpr std::size_t kLooks = 4096;
    const std::size_t stride = record.stencils.size() / kLooks + 1;
    for (std::size_t v = 0; v < record.stencils.size(); v += stride) look(record.stencils[v], v);
}

// Do vertices often share a coordinate that their first neighbours share?
bool has_level_faces(const WalkRecord& record, const std::vector<Point3>& places) {
    std::size_t shared = 0, kept = 0;
    look_at_some(record, [&](const Stencil& s, std::size_t v) {
        if (s.at[0] == kNone || s.at[1] == kNone) return;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double level = places[s.at[0]][axis];
            if (places[s.at[1]][axis] != level) continue;
            ++shared;
            kept += places[v][axis] == level;
        }
    });
    return 32 * kept > shared;
}

// Do enough of the vertices of tets that could go on with a border lie near its plane to pay for
// asking?
bool goes_along(const WalkRecord& record, const std::vector<Point3>& places) {
    const RoundFaces planes;  // no round ones
    std::size_t asked = 0, near = 0;
    look_at_some(record, [&](const Stencil& s, std::size_t v) {
        if (s.borders == 0) return;
        ++asked;
        near += stencil_along(s, places, places[v], planes).configuration == Configuration::border;
    });
    return 4 * near > asked;
}

// Were most vertices told by leaders? Then tets repeat, and so do the levels of their vertices.
bool is_lattice(const WalkRecord& record) {
    const auto led = std::count_if(
        record.stencils.begin(), record.stencils.end(),
        [](const Stencil& stencil) { return stencil.configuration == Configuration::led; });
    return 2 * static_cast<std::size_t>(led) > record.stencils.size();
}

bool has_triangles(const WalkRecord& record) {
    return std::any_of(record.stencils.begin(), record.stencils.end(),
                       [](const Stencil& s) { return s.configuration == Configuration::triangle; });
}

}  // namespace

ChosenFormat choose_format(const CodedPositions& all, bool fast, int threads) {
    const WalkRecord& record = all.record;
    const std::size_t vertices = all.vertices();
    std::vector<Point3> places(vertices), firm;  // firm: no copies, none escaped
    std::vector<bool> skip(vertices, false);
    firm.reserve(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
        const Position& value = all.values[v];
        skip[v] =
            record.copy_of[v] != kNone || value[0].escaped || value[1].escaped || value[2].escaped;
        places[v] = units_of(all.plan.format.numbers, value);
        if (!skip[v]) firm.push_back(places[v]);
    }
    PositionFormat first = all.plan.format;
    const RoundFaces planes;  // no round ones
    const auto weights = [&](const RoundFaces* along) {
        return fit_weights(record.stencils, places, skip, first.mirrored, along);
    };
    auto finding_echoes =
        start(threads > 1 && !fast, [&] { return find_echoes(firm, first.numbers.digits == 0); });
    first.cube_bits = cube_bits_of(record, places, skip);
    first.weights = weights(nullptr);
    if (fast) {
        first.has_rice = true;
        first.has_levels = is_lattice(record);
        first.level_bits = first.cube_bits;
        return {first, {}};
    }

    const bool may_follow =
        std::count_if(record.stencils.begin(), record.stencils.end(),
                      [](const Stencil& s) { return s.configuration == Configuration::seed; }) > 4;
    auto planning_follows = start(threads > 1 && may_follow, [&] {
        return may_follow ? plan_follows(record, places, first) : std::vector<std::uint8_t>{};
    });
    Prospects prospects;
    prospects.vertices = vertices;
    prospects.surface = all.complex.kind == CellKind::polygon;
    prospects.echoes = finding_echoes.get();
    prospects.may_share = vertices < kSmallPositions || has_level_faces(record, places);
    prospects.may_follow = may_follow;
    prospects.has_triangles = has_triangles(record);
    if (goes_along(record, places)) prospects.along_weights = weights(&planes);
    std::vector<std::uint8_t> leads = planning_follows.get();
    if (!prospects.surface) prospects.rounds = find_round_faces(record, places, skip);
    if (!prospects.rounds.empty()) {
        RoundFaces faces(prospects.rounds);
        for (const Point3& place : places) faces.insert(place);
        prospects.round_weights = weights(&faces);
    }
    Proposals proposals(std::move(prospects));
    PositionFormat format = try_in_turn(all, leads, std::move(first), proposals.list(), threads);
    return {std::move(format), std::move(leads)};
}

}  // namespace ravel
