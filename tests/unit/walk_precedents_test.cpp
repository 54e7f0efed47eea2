#include <catch2/catch.hpp>

#include <optional>

#include "entropy/flag_decoder.h"
#include "entropy/flag_encoder.h"
#include "make/random.h"
#include "walk/precedents.h"

using namespace ravel;

namespace {

struct Cell {
    bool seed = false;
    std::vector<std::pair<Context, bool>> answers;
};
using Walk = std::vector<Cell>;

// Cells of up to nine answers under few contexts.
Walk random_walk(make::Random& random, std::size_t cells) {
    Walk walk(cells);
    for (Cell& cell : walk) {
        cell.seed = random.one_in(9);
        cell.answers.resize(random.below(10));
        for (auto& [context, answer] : cell.answers) {
            context = static_cast<Context>(random.below(30));
            answer = random.one_in(2);
        }
    }
    return walk;
}
Walk repeated(const Walk& walk, int times) {
    Walk all;
    for (int i = 0; i < times; ++i) all.insert(all.end(), walk.begin(), walk.end());
    return all;
}

struct Size {
    std::size_t cells, corners;
};

Bytes write(const Walk& walk, Size size) {
    Precedents precedents(size.cells, size.corners);
    std::vector<FlagModel> models(surface::kContexts);
    FlagEncoder out;
    for (const Cell& cell : walk) {
        precedents.begin_cell(cell.seed);
        for (const auto& [context, answer] : cell.answers)
            precedents.flag(models, context, answer, [&](FlagModel& model, bool yes) {
                out.flag(model, yes);
                return yes;
            });
    }
    return out.finish();
}

// The walk is told by a reader that knows which questions are asked, and no answers.
bool comes_back(const Walk& walk, Size size) {
    const Bytes bytes = write(walk, size);
    Precedents precedents(size.cells, size.corners);
    std::vector<FlagModel> models(surface::kContexts);
    FlagDecoder in(bytes);
    for (const Cell& cell : walk) {
        precedents.begin_cell(cell.seed);
        for (const auto& [context, answer] : cell.answers)
            if (precedents.flag(models, context, false,
                                [&](FlagModel& model, bool) { return in.flag(model); }) != answer)
                return false;
    }
    return in.finished();
}

}  // namespace

TEST_CASE("answers by precedents come back, whatever they are") {
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        make::Random random{seed};
        Walk walk = random_walk(random, random.below(60));
        if (random.one_in(2)) walk = repeated(walk, 1 + static_cast<int>(random.below(6)));
        // Other sizes than the walk has are no harm: what is kept ends early, slots are shared.
        const Size size{random.below(2000), random.below(2000)};
        INFO("seed " << seed);
        CHECK(comes_back(walk, size));
    }
}

TEST_CASE("what comes again costs next to nothing") {
    make::Random random{7};
    const Walk part = random_walk(random, 100);
    const Size size{10000, 40000};
    const double once = static_cast<double>(write(part, size).size());
    const double hundred_times = static_cast<double>(write(repeated(part, 100), size).size());
    CHECK(once > 40);
    CHECK(hundred_times < 2.5 * once);
}

TEST_CASE("what comes again with a difference here and there costs little") {
    make::Random random{8};
    const Walk part = random_walk(random, 100);
    Walk all = repeated(part, 50);
    for (Cell& cell : all)
        if (random.one_in(20) && !cell.answers.empty())
            cell.answers.front().second = !cell.answers.front().second;
    const Size size{5000, 20000};
    CHECK(comes_back(all, size));
    CHECK(static_cast<double>(write(all, size).size()) <
          0.25 * static_cast<double>(write(random_walk(random, 5000), size).size()));
}
