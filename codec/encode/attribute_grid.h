// Attributes that may lose precision: their values are rounded before they are coded.
#pragma once

#include <vector>

#include "predict/field_codes.h"
#include "ravel/ravel.h"

namespace ravel {

// Of one attribute; without a bound it is kept bit for bit.
struct AttributeGrid {
    FieldFormat format;  // of the rounded values; what the grid does not hold is as it was
    double bound = 0, error = 0;
};

// Error: a bound for an attribute that is not there or holds no floats, or one that makes no sense.
Status check_attribute_options(const Mesh& mesh, const EncodeOptions& options);

// Per attribute of the mesh, whose values are rounded: what decoding gives. Needs options that were
// checked.
std::vector<AttributeGrid> round_attributes(Mesh& mesh, const EncodeOptions& options);

}  // namespace ravel
