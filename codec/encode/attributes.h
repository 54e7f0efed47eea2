// Writes the section of the attributes.
#pragma once

#include "base/bytes.h"
#include "encode/attribute_grid.h"
#include "predict/ground.h"
#include "walk/walk.h"

namespace ravel {

// Are the values a pool that elements refer to by index?
bool is_pool(const Mesh& mesh, const Attribute& attribute);

// Of the mesh of the ground, whose values are rounded to `grids`. `marked`: facets that are
// companions. Sets, per attribute, the tuple of its pool that is each of those in the file.
Bytes write_attributes(const Ground<Walked>& ground, const std::vector<Id>& marked,
                       const std::vector<AttributeGrid>& grids,
                       std::vector<std::vector<Index>>& old_tuple);

}  // namespace ravel
