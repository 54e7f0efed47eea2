// Sorts elements by numbers below a bound, in linear time; elements with equal numbers stay in
// their order, so that sorting by the last of several numbers first sorts by all of them.
#pragma once

#include <vector>

#include "mesh/complex.h"

namespace ravel {

// `key`: per element, below `bound`.
inline void counting_sort(std::vector<Id>& elements, const std::vector<Id>& key, Id bound) {
    std::vector<Id> next(std::size_t{bound} + 1, 0);
    const std::vector<Id> given = elements;
    for (const Id e : given) ++next[key[e] + 1];
    for (std::size_t k = 1; k < next.size(); ++k) next[k] += next[k - 1];
    for (const Id e : given) elements[next[key[e]]++] = e;
}

}  // namespace ravel
