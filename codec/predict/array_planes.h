// Attribute values as bytes that zstd packs well: differences along the strip, in the integer image
// of floats, wrapped to the scalar's width and zigzagged, then one plane per byte of the scalar.
#pragma once

#include "base/bytes.h"
#include "ravel/mesh.h"

namespace ravel {

// `array` and the result have the same size.
Bytes planes_of(const Array& array);
Array array_of_planes(Scalar scalar, std::uint32_t arity, std::span<const std::byte> planes);

}  // namespace ravel
