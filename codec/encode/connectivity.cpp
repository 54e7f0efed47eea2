#include "encode/connectivity.h"

#include <algorithm>

#include "encode/course.h"
#include "entropy/pack.h"

namespace ravel {

Connectivity by_precedents(const Answers& answers, const BlockHead& block) {
    std::vector<FlagModel> models = walk_models(CellKind::polygon);
    FlagEncoder out;
    answers.tell(Precedents(block.cells, block.corners), models, out);
    return {out.finish(), out.ideal_bits()};
}

Connectivity choose_connectivity(const WalkCodes& codes, std::future<Connectivity> told,
                                 std::size_t others, int level, BlockHead& block) {
    // Precedents take readers a tenth to a quarter of their time.
    constexpr double kWorth = 0.01;  // of connectivity and positions
    Connectivity plain{codes.out.finish(), codes.out.ideal_bits()};
    const auto size = [&](const Bytes& bytes) {
        return static_cast<double>(std::min(bytes.size(), pack(bytes, level).size()));
    };
    const double before = size(plain.bytes),
                 least = kWorth * (before + static_cast<double>(others));
    if (!told.valid() || before < least) return plain;
    Connectivity other = told.get();
    if (before - size(other.bytes) < least) return plain;
    block.has_precedents = true;
    return other;
}

}  // namespace ravel
