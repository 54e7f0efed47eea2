// How models of residuals begin, where there are letters for one kind of sizes alone.
#pragma once

#include <algorithm>
#include <vector>

#include "predict/residual_context.h"

namespace ravel {

// Sizes of all kinds start alike. `models`: of ResidualContexts, and maybe others behind them.
template <class Model>
std::vector<Model> with_size_kinds(std::vector<Model> models) {
    using C = ResidualContexts;
    for (std::uint32_t kind = 1; kind < kSizeKinds; ++kind)
        std::copy_n(models.begin() + C::size.base, kKindScales * kSizeNodes,
                    models.begin() + C::size_by.at(kind - 1));
    return models;
}

}  // namespace ravel
