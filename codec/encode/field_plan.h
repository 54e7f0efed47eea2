// Chooses how the values of an attribute are coded: by what numbers, guessed how.
#pragma once

#include "predict/attribute_coding.h"
#include "predict/value_codes.h"

namespace ravel {

// The numbers of all tuples in a format; none where the values are of another kind (a grid misses
// none: what it misses are outliers).
FieldTruth truth_of(const Array& values, FieldFormat& format);

struct FieldPlan {
    bool planes = true;
    FieldFormat format;
    std::size_t bytes = 0;  // about what the values take
};

// The smallest by trial, on the first of many tuples.
// `grid`: of values that are rounded, else none.
FieldPlan plan_field(const Array& values, Around& around, const FieldFormat* grid);

}  // namespace ravel
