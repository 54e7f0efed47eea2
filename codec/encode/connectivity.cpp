#include "encode/connectivity.h"

#include <algorithm>

#include "encode/course.h"
#include "entropy/pack.h"

namespace ravel {

Connectivity choose_connectivity(const WalkCodes& codes, const Answers& answers, std::size_t others,
                                 int level, BlockHead& block) {
    // Precedents take readers a tenth to a quarter of their time.
    constexpr double kWorth = 0.01;  // of connectivity and positions
    Connectivity plain{codes.out.finish(), codes.out.ideal_bits()};
    const auto size = [&](const Bytes& bytes) {
        return static_cast<double>(std::min(bytes.size(), pack(bytes, level).size()));
    };
    const double before = size(plain.bytes),
                 least = kWorth * (before + static_cast<double>(others));
    if (answers.empty() || before < least) return plain;
    std::vector<FlagModel> models = walk_models(CellKind::polygon);
    FlagEncoder out;
    answers.tell(Precedents(block.cells, block.corners), models, out);
    Connectivity by_precedents{out.finish(), out.ideal_bits()};
    if (before - size(by_precedents.bytes) < least) return plain;
    block.has_precedents = true;
    return by_precedents;
}

}  // namespace ravel
