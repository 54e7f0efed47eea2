// Which means a mesh's positions are to be coded by: what they would cost is tried out one by one.
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "encode/echoes.h"
#include "encode/fit.h"
#include "encode/follow_plan.h"
#include "encode/position_pass.h"
#include "encode/round_search.h"
#include "encode/threads.h"
#include "entropy/priors.h"
#include "predict/priors.h"
#include "predict/residual_models.h"
#include "predict/round_faces.h"

namespace ravel {
namespace {

// Only counts what they would cost.
struct CountingCoder {
    static constexpr bool kWrites = true;
    double bits = 0;
    std::vector<FlagModel> models =
        with_size_kinds(models_of(kResidualPriors, ResidualContexts::count, kResidualPriorSeen));
    bool flag(Context context, bool truth) {
        FlagModel& model = models[context];
        bits += model.cost(truth);
        model.update(truth);
        return truth;
    }
    double cost(Context context, bool truth) const { return models[context].cost(truth); }
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

// About how many bytes that would make. Of large meshes one in a few stretches of vertices is
// looked at, of very large ones only as far as kMost.
double try_out(const CodedPositions& all, const PositionFormat& format,
               const std::vector<std::uint8_t>& leads) {
    constexpr std::size_t kStretch = 256, kWhole = 8192, kEnough = 4096, kMost = 131072;
    const std::size_t size = std::min(all.size(), kMost);
    const std::size_t stride =
        all.size() <= kWhole ? 1 : std::clamp<std::size_t>(all.size() / kEnough, 3, 8);
    std::size_t count = 0;
    CountingCoder coder;
    code_positions(coder, all, format, leads, size, [&](std::size_t i) {
        const bool coded = i / kStretch % stride == 0;
        count += coded;
        return coded;
    });
    const double share =
        count == 0 ? 1 : static_cast<double>(all.size()) / static_cast<double>(count);
    return static_cast<double>(position_head_of(format).size()) + coder.bits / 8 * share;
}

// What helps one mesh costs another a flag per vertex, and costs time: it stays where it makes the
// bytes fewer, of large meshes by a hundredth at least. What takes much of the time to decode goes
// again where it is worth less than its price.
constexpr std::size_t kSmall = 6000;    // vertices below which every byte counts
constexpr std::size_t kLarge = 200000;  // and from which fewer things are tried
constexpr double kWorth = 0.01;
constexpr double kSlow = 0.02;      // of what costs more time
constexpr double kHopeless = 1.02;  // where levels make more, pairs are no help either
constexpr double kSurely = 0.9;     // where echoes make less, levels are no help without them
constexpr double kLevelsPrice = 0.04, kEchoesPrice = 0.01;  // of surfaces; half where all is small

// What is to be tried out beside what was kept so far, if anything.
using Candidate = std::optional<PositionFormat>;
struct Proposal {
    std::function<Candidate(const PositionFormat& kept)> format;
    bool usual = false;     // is it taken more often than not? For how it is tried, not for whether
    double worth = kWorth;  // below 0: what may be lost
    double* ratio = nullptr;  // if not null, where it is told how many times as many bytes it makes
};

// Tries one proposal after the other. Where there are more threads, those that come next are tried
// meanwhile, as if this one went as usual; what comes of it is the same.
class Trials {
  public:
    Trials(const CodedPositions& all, const std::vector<std::uint8_t>& leads, PositionFormat start,
           int threads)
        : all_(all),
          leads_(leads),
          kept_(std::move(start)),
          threads_(static_cast<std::size_t>(std::min(threads, kMostThreads))) {}

    PositionFormat run(const std::vector<Proposal>& proposals) {
        for (std::size_t i = 0; i < proposals.size(); ++i) {
            const Candidate candidate = proposals[i].format(kept_);
            if (!candidate) continue;
            if (bytes_of(*candidate) == nullptr) {
                std::vector<PositionFormat> formats{*candidate};
                if (tried_.empty()) formats.push_back(kept_);
                PositionFormat then = proposals[i].usual ? *candidate : kept_;
                for (std::size_t j = i + 1; j < proposals.size() && formats.size() < threads_;
                     ++j) {
                    const Candidate next = proposals[j].format(then);
                    if (!next) continue;
                    if (bytes_of(*next) == nullptr) formats.push_back(*next);
                    if (proposals[j].usual) then = *next;
                }
                try_all(formats);
            }
            const double ratio = *bytes_of(*candidate) / *bytes_of(kept_);
            if (proposals[i].ratio != nullptr) *proposals[i].ratio = ratio;
            const double worth = proposals[i].worth;
            const bool small = all_.vertices() < kSmall;
            if (ratio < 1 - (small ? std::min(worth, 0.0) / 2 : worth)) kept_ = *candidate;
        }
        return kept_;
    }

  private:
    static constexpr int kMostThreads = 4;  // it seldom goes as usual for long

    struct Tried {
        PositionFormat format;
        double bytes;
    };

    const double* bytes_of(const PositionFormat& format) const {
        for (const Tried& tried : tried_)
            if (tried.format == format) return &tried.bytes;
        return nullptr;
    }
    void try_all(const std::vector<PositionFormat>& formats) {
        std::vector<std::future<double>> bytes;
        for (const PositionFormat& format : formats)
            bytes.push_back(start(threads_ > 1 && !bytes.empty(),
                                  [&, this] { return try_out(all_, format, leads_); }));
        for (std::size_t i = 0; i < formats.size(); ++i)
            tried_.push_back({formats[i], bytes[i].get()});
    }

    const CodedPositions& all_;
    const std::vector<std::uint8_t>& leads_;
    PositionFormat kept_;
    const std::size_t threads_;
    std::vector<Tried> tried_;
};

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
    const bool may_go_along = goes_along(record, places);
    const RoundFaces planes;  // no round ones
    const auto weights = [&](const RoundFaces* along) {
        return fit_weights(record.stencils, places, skip, first.mirrored, along);
    };
    auto finding_echoes =
        start(threads > 1 && !fast, [&] { return find_echoes(firm, first.numbers.digits == 0); });
    first.cube_bits = cube_bits_of(record, places, skip);
    first.has_along = fast && may_go_along;
    first.weights = weights(first.has_along ? &planes : nullptr);
    if (fast) {
        first.has_levels = is_lattice(record);
        first.level_bits = first.cube_bits;
        return {first, {}};
    }

    const Echoes echoes = finding_echoes.get();
    const bool may_follow =
        std::count_if(record.stencils.begin(), record.stencils.end(),
                      [](const Stencil& s) { return s.configuration == Configuration::seed; }) > 4;
    auto planning_follows = start(threads > 1 && may_follow, [&] {
        return may_follow ? plan_follows(record, places, first) : std::vector<std::uint8_t>{};
    });
    const bool may_share = vertices < kSmall || has_level_faces(record, places);
    const Weights along_weights = may_go_along ? weights(&planes) : first.weights;
    std::vector<std::uint8_t> leads = planning_follows.get();
    double echo_ratio = 1, level_ratio = 1;

    // `when`: is there anything to try? `change`: what is other than in the format kept so far.
    const auto propose = [](auto when, auto change) {
        return [when, change](const PositionFormat& kept) -> Candidate {
            if (!when(kept)) return std::nullopt;
            PositionFormat format = kept;
            change(format);
            return format;
        };
    };
    const auto weights_along = [&](const RoundFaceList& rounds) {
        RoundFaces faces(rounds);
        for (const Point3& place : places) faces.insert(place);
        return weights(&faces);
    };
    const auto always = [](const PositionFormat&) { return true; };
    std::vector<Proposal> proposals;
    constexpr bool kTaken = true, kRefused = false;  // as usual
    const auto offer = [&](bool usual, auto when, auto change) -> Proposal& {
        return proposals.emplace_back(Proposal{propose(when, change), usual});
    };
    if (!echoes.likely.empty())
        offer(kTaken, always, [&](PositionFormat& f) { f.echoes = echoes.likely; }).ratio =
            &echo_ratio;
    if (!echoes.more.empty() && vertices < kLarge)
        offer(kRefused, always, [&](PositionFormat& f) {
            for (const Echo& echo : echoes.more)
                if (f.echoes.size() < kMostEchoes) f.echoes.push_back(echo);
        });
    offer(
        kRefused, [&](const PositionFormat& f) { return !f.echoes.empty() && vertices < kSmall; },
        [](PositionFormat& f) { ++f.cube_bits; });
    if (may_share) offer(kTaken, always, [](PositionFormat& f) { f.has_levels = true; });
    offer(kTaken, always, [](PositionFormat& f) {
        f.has_levels = true;
        f.level_bits = f.cube_bits;
    }).ratio = &level_ratio;
    offer(
        kRefused,
        [&](const PositionFormat& f) { return f.level_bits > 0 && vertices < kLarge / 4; },
        [](PositionFormat& f) { ++f.level_bits; });
    // Pairs may be known where single levels tell nothing.
    Proposal& pairs = offer(
        kTaken,
        [&](const PositionFormat& f) {
            return level_ratio < kHopeless && (f.level_bits > 0 || vertices < kLarge);
        },
        [](PositionFormat& f) {
            if (f.level_bits == 0) f.level_bits = f.cube_bits;
            f.has_levels = f.has_pairs = true;
        });
    pairs.worth = kSlow;
    // What was taken first may be no help beside it.
    const bool surface = all.complex.kind == CellKind::polygon;
    const auto drop_echoes = [](PositionFormat& f) { f.echoes.clear(); };
    offer(
        kRefused,
        [&](const PositionFormat& f) {
            return f.level_bits > 0 && !f.echoes.empty() &&
                   (vertices < kSmall || echo_ratio > kSurely);
        },
        drop_echoes)
        .worth = surface ? -kEchoesPrice : kWorth;
    // And what was not taken may be better in its place.
    const auto has_echoes_alone = [&](const PositionFormat& f) {
        return f.level_bits == 0 && !f.echoes.empty() && vertices < kLarge;
    };
    const auto take_levels_instead = [](PositionFormat& f) {
        f.echoes.clear();
        f.level_bits = f.cube_bits;
        f.has_levels = f.has_pairs = true;
    };
    offer(kRefused, has_echoes_alone, take_levels_instead);
    if (may_go_along)
        offer(kTaken, always, [&](PositionFormat& f) {
            f.has_along = true;
            f.weights = along_weights;
        });
    const RoundFaceList rounds = all.complex.kind == CellKind::tet
                                     ? find_round_faces(record, places, skip)
                                     : RoundFaceList{};
    const Weights round_weights = rounds.empty() ? first.weights : weights_along(rounds);
    const auto lay_on = [&](PositionFormat& f) {
        f.has_along = true;
        f.rounds = rounds;
    };
    if (!rounds.empty()) {
        offer(kTaken, always, lay_on);
        offer(
            kTaken, [](const PositionFormat& f) { return !f.rounds.empty(); },
            [&](PositionFormat& f) { f.weights = round_weights; });
        offer(
            kRefused,
            [](const PositionFormat& f) { return !f.rounds.empty() && !f.echoes.empty(); },
            [](PositionFormat& f) { f.echoes.clear(); });
    }
    // Who follows asks for neither echoes nor levels, so that costs less time than others.
    if (may_follow) {
        offer(kTaken, always, [](PositionFormat& f) { f.has_follows = true; }).worth = kWorth / 4;
        offer(
            kRefused, [&](const PositionFormat& f) { return f.has_follows && has_echoes_alone(f); },
            take_levels_instead);
        if (surface)
            offer(
                kRefused,
                [](const PositionFormat& f) { return f.has_follows && !f.echoes.empty(); },
                drop_echoes)
                .worth = -kEchoesPrice;
    }
    if (surface)
        offer(
            kRefused, [](const PositionFormat& f) { return f.has_levels || f.level_bits > 0; },
            [](PositionFormat& f) {
                f.has_levels = f.has_pairs = false;
                f.level_bits = 0;
            })
            .worth = -kLevelsPrice;
    // Where parts repeat, a guess from fewer points is carried over with fewer roundings.
    if (has_triangles(record))
        offer(
            kRefused, [](const PositionFormat& f) { return f.has_follows || !f.echoes.empty(); },
            [](PositionFormat& f) { f.weights = without_triangles(f.weights); })
            .worth = 0;
    PositionFormat format = Trials(all, leads, first, threads).run(proposals);
    return {std::move(format), std::move(leads)};
}

}  // namespace ravel
