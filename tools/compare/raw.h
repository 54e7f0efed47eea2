// The arrays a mesh is made of, in file order, as general compressors get them.
#pragma once

#include <span>
#include <vector>

#include "compare/contender.h"

namespace ravel::compare {

enum class Layout {
    raw,     // floats as the mesh has them, u32 corners: what tools without a mesh codec store
    plain,   // the same with u16 or u32 grid numbers where a grid is asked for
    planes,  // of `plain`: differences to the number before, zigzag, byte planes apart
};

// Degrees (u32 each) lead where polygons differ in degree.
std::vector<std::byte> arrays_of(const Input& input, Layout layout);
std::size_t arrays_size(const Input& input, Layout layout);
// Counts are taken from `input`, as a file header of a few bytes would hold them.
Result<Mesh> mesh_of_arrays(std::span<const std::byte> arrays, const Input& input, Layout layout);

}  // namespace ravel::compare
