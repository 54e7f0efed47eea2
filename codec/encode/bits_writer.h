// Writes the flags and plain bits of what rides along.
#pragma once

#include "entropy/flag_encoder.h"
#include "entropy/priors.h"
#include "predict/attribute_contexts.h"
#include "predict/priors.h"
#include "predict/residual_models.h"

namespace ravel {

struct BitsWriter {
    static constexpr bool kWrites = true;
    FlagEncoder& out;
    std::vector<FlagModel> models =
        with_size_kinds(models_of(kResidualPriors, AttributeContexts::count, kResidualPriorSeen));
    bool flag(Context context, bool truth) {
        out.flag(models[context], truth);
        return truth;
    }
    std::uint64_t plain(std::uint64_t truth, int count) {
        out.plain(truth, count);
        return truth;
    }
};

}  // namespace ravel
