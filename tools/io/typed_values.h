// Arrays of a known scalar type in the data sections of VTK and Gmsh files: as decimals, or as
// bytes of either byte order.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/text_reader.h"
#include "ravel/mesh.h"
#include "ravel/result.h"

namespace ravel::io {

// Reverses the bytes of each of the scalars.
void swap_bytes(std::span<std::byte> bytes, std::size_t scalar_size);

// `count` numbers from text, or the error that names the line and `what`. Integers must fit the
// type; f32 becomes f64 where a decimal was not printed from a float32 (by any number of digits).
Result<std::vector<double>> read_reals(TextReader& text, Index count, const std::string& what);
Result<Array> read_values(TextReader& text, Scalar scalar, std::uint32_t arity, Index tuples,
                          const std::string& what);

// `tuples` times `arity` scalars from the bytes at the reader's place. The error names the byte.
Result<Array> take_values(TextReader& bytes, Scalar scalar, std::uint32_t arity, Index tuples,
                          bool swapped, const std::string& what);

// Numbers of any integer type as indices; the error is at the first that is negative or a float.
Result<std::vector<Index>> as_indices(const Array& array);

// The numbers as decimals, `per_line` tuples a line.
void append_values(std::string& out, const Array& array, std::size_t per_line);

// The values of an attribute, one tuple per element; zeros where an element has none.
Array expand(const Array& values, std::span<const Index> index);

}  // namespace ravel::io
