// Learns the priors of all contexts from meshes and writes them as headers.
//     ravel_train CODEC_FOLDER MESH...        into CODEC_FOLDER/walk/priors.h and predict/priors.h
// Every mesh has the same say in a context, however large it is. Run it after contexts have
// changed, with meshes of all classes; the files it writes are part of the format.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include "encode/course.h"
#include "encode/position_pass.h"
#include "entropy/priors.h"
#include "io/mesh_io.h"
#include "predict/priors.h"
#include "predict/residual_models.h"
#include "ravel/ravel.h"

namespace ravel::train {
namespace {

// How often each context said no and yes.
struct Tally {
    std::vector<std::array<double, 2>> count;

    explicit Tally(std::size_t contexts = 0) : count(contexts) {}
    void add(Context context, bool yes) { count[context][yes] += 1; }
    // No context of `other` counts as more than fifty flags.
    void take_in(const Tally& other) {
        for (std::size_t i = 0; i < count.size(); ++i) {
            const double all = other.count[i][0] + other.count[i][1];
            const double share = all > 50 ? 50 / all : 1;
            for (std::size_t k = 0; k < 2; ++k) count[i][k] += share * other.count[i][k];
        }
    }
};

struct WalkTape {
    Tally tally;
    Answers answers;
    void begin_cell(bool seed) { answers.begin_cell(seed); }
    void flag(Context context, bool truth) {
        tally.add(context, truth);
        answers.flag(context, truth);
    }
    void plain(std::uint64_t, int) {}
};

// The questions of the walk over a surface by their precedents.
struct PrecedentTape {
    const std::vector<FlagModel>& models;
    Tally& tally;
    void flag(FlagModel& model, bool yes) {
        const auto context = static_cast<Context>(&model - models.data());
        if (context >= surface::kPrecedent.base) tally.add(context, yes);
        model.update(yes);
    }
    void plain(std::uint64_t, int) {}
};

// What is chosen depends on what flags cost, so models learn meanwhile.
struct ResidualTape {
    static constexpr bool kWrites = true;
    Tally tally{ResidualContexts::count};
    std::vector<FlagModel> models =
        with_size_kinds(models_of(kResidualPriors, ResidualContexts::count, kResidualPriorSeen));
    bool flag(Context context, bool truth) {
        tally.add(context, truth);
        models[context].update(truth);
        return truth;
    }
    double cost(Context context, bool truth) const { return models[context].cost(truth); }
    std::uint64_t plain(std::uint64_t truth, int) { return truth; }
    std::uint64_t rice(std::uint64_t truth, int) { return truth; }
};

struct Learnt {
    Tally surface{surface::kContexts}, tet{tet::kContexts}, residual{ResidualContexts::count};
};

void learn_residuals(const Complex& complex, const Course& course, const PositionPlan& plan,
                     Tally& into) {
    const std::vector<Index> unused;
    const EdgePoints edges;
    const CodedPositions all = in_order(plan, complex, course.record, unused, edges);
    const ChosenFormat chosen = choose_format(all, false, 1);
    ResidualTape tape;
    code_positions(tape, all, chosen.format, chosen.leads, all.size(),
                   [](std::size_t) { return true; });
    into.take_in(tape.tally);
}

// Sizes of all kinds start alike.
void join_kinds(Tally& residual) {
    using C = ResidualContexts;
    for (std::uint32_t kind = 1; kind < kSizeKinds; ++kind)
        for (std::uint32_t node = 0; node < kKindScales * kSizeNodes; ++node) {
            auto& count = residual.count[C::size_by.at(kind - 1) + node];
            for (std::size_t k = 0; k < 2; ++k) residual.count[C::size.base + node][k] += count[k];
            count = {};
        }
}

// The contexts of FoldWalk, which has none in common with TetWalk but those of vertices.
void learn_folds(const Mesh& mesh, const Complex& complex, const EncodeOptions& options,
                 Tally& into) {
    auto positions = plan_positions(mesh, options);
    if (!positions) return;
    const CoursePlan plan = plan_course(mesh, complex, *positions, true);
    WalkTape tape{Tally(into.count.size()), {}};
    if (!run_course(complex, plan, tape).is_whole) return;
    for (Context c = 0; c < tet::kFold.base; ++c) tape.tally.count[c] = {};
    into.take_in(tape.tally);
}

bool learn(const Mesh& mesh, const EncodeOptions& options, Learnt& learnt) {
    auto positions = plan_positions(mesh, options);
    auto complex = build_complex(mesh);
    if (!positions || !complex) return false;
    const CoursePlan plan = plan_course(mesh, *complex, *positions, false);
    Tally& tally = mesh.kind == CellKind::tet ? learnt.tet : learnt.surface;
    WalkTape tape{Tally(tally.count.size()), {}};
    const Course course = run_course(*complex, plan, tape);
    if (mesh.kind == CellKind::polygon) {
        std::vector<FlagModel> models = walk_models(mesh.kind);
        PrecedentTape precedents{models, tape.tally};
        tape.answers.tell(Precedents(plan.block.cells, plan.block.corners), models, precedents);
    }
    tally.take_in(tape.tally);
    if (mesh.kind == CellKind::tet) learn_folds(mesh, *complex, options, learnt.tet);
    learn_residuals(*complex, course, *positions, learnt.residual);
    return true;
}

// The letter whose chance is nearest in the logarithm of the rarer answer, of every other letter:
// that costs next to nothing, and decoders for the web carry them all.
char letter_of(const std::array<double, 2>& count) {
    if (count[0] + count[1] < 2) return 'P';
    const double yes = (count[1] + 0.4) / (count[0] + count[1] + 0.8);
    const double rare = std::log(std::min(yes, 1 - yes) + 1e-4);
    int best = 0;
    double least = 1e9;
    for (int i = 1; i < 16; i += 2) {
        const double off =
            std::abs(std::log(kPriorChance[static_cast<std::size_t>(i)] / 65536.0) - rare);
        if (off < least) least = off, best = i;
    }
    const int letter = yes <= 0.5 ? best : 30 - best;
    return static_cast<char>(letter < 26 ? 'A' + letter : 'a' + letter - 26);
}

std::string letters_of(const Tally& tally) {
    std::string letters;
    for (const auto& count : tally.count) letters += letter_of(count);
    while (!letters.empty() && letters.back() == 'P') letters.pop_back();
    std::string text;
    for (std::size_t i = 0; i < letters.size(); i += 88)
        text += "\n    \"" + letters.substr(i, 88) + "\"";
    return text.empty() ? " \"\"" : text;
}

std::string table(const char* name, int seen, const Tally& tally) {
    return std::string("inline constexpr std::uint16_t ") + name +
           "Seen = " + std::to_string(seen) + ";\ninline constexpr std::string_view " + name +
           "s =" + letters_of(tally) + ";\n";
}

void write(const std::string& path, const std::string& what, const std::string& tables) {
    std::ofstream(path) << "// What " << what
                        << " know before the first flag; see entropy/priors.h. Made by "
                           "tools/train.\n#pragma once\n\n#include <cstdint>\n#include "
                           "<string_view>\n\nnamespace ravel {\n\n"
                        << tables << "\n}  // namespace ravel\n";
}

}  // namespace
}  // namespace ravel::train

int main(int count, char** words) {
    using namespace ravel;
    using namespace ravel::train;
    Learnt learnt;
    for (int i = 2; i < count; ++i) {
        const auto mesh = io::read_mesh(words[i]);
        EncodeOptions grid;
        grid.position_bits = 14;
        if (!mesh || !learn(*mesh, grid, learnt) || !learn(*mesh, {}, learnt)) {
            std::fprintf(stderr, "%s: passed over\n", words[i]);
            continue;
        }
        std::fprintf(stderr, "%s\n", words[i]);
    }
    if (count < 3) return 2;
    join_kinds(learnt.residual);
    const std::string codec = words[1];
    write(codec + "/walk/priors.h", "the walk's models",
          "namespace surface {\n" + table("kPrior", 1, learnt.surface) +
              "}  // namespace surface\n\nnamespace tet {\n" + table("kPrior", 2, learnt.tet) +
              "}  // namespace tet\n");
    write(codec + "/predict/priors.h", "the models of residuals",
          table("kResidualPrior", 4, learnt.residual));
}
