// Chooses the unit of lossless coordinates, and says of each coordinate what number it is.
#pragma once

#include <optional>
#include <span>

#include "predict/numbers.h"
#include "ravel/mesh.h"

namespace ravel {

// The format that takes fewest bits for these coordinates, judged by the size of its units; those
// that do not fit it are left to be told bit for bit. Without `behind`, a format that has no digits
// behind its unit, and about one misfit in fifty at most. Does not depend on their order. Linear.
NumberFormat choose_numbers(const Array& positions, bool behind = true);

// The number that decodes to exactly these bits, or none: not finite, or not of this format.
std::optional<Number> number_of(const NumberFormat& format, double x, Scalar scalar);

// A whole number of units near x, or 0 where there is none.
double whole_near(const NumberFormat& format, double x);

}  // namespace ravel
