// How one attribute is coded, and the words for it at the head of the section.
#pragma once

#include "base/bytes.h"
#include "predict/field_codes.h"

namespace ravel {

// Elements (and tuples) of an attribute that is coded otherwise than as planes are fewer.
inline constexpr Index kMostElements = Index{1} << 30;

struct AttributeCoding {
    // Which tuple has each element: its own; one of a pool, told element after element; the same,
    // told by floods.
    enum class Tuples : std::uint8_t { own, in_order, flooded };

    Tuples tuples = Tuples::own;
    bool planes = true;  // values as bytes (array_planes.h), else as a field
    Id pool = 0;         // tuples of the pool, where the attribute itself has no index
    FieldFormat field;
};

// `indexed`: the head of the file tells how many tuples the pool has. `step`: of a grid, from
// there.
void write_coding(ByteWriter& out, const AttributeCoding& coding, bool indexed);
// False: of no kind that this version knows.
bool read_coding(ByteReader& in, AttributeCoding& coding, bool indexed, Scalar scalar);

}  // namespace ravel
