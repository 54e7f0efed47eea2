// Writes the section of the attributes.
#pragma once

#include "base/bytes.h"
#include "predict/ground.h"
#include "walk/walk.h"

namespace ravel {

// Are the values a pool that elements refer to by index?
bool is_pool(const Mesh& mesh, const Attribute& attribute);

// Of the mesh of the ground. `marked`: facets that are companions.
Bytes write_attributes(const Ground<Walked>& ground, const std::vector<Id>& marked);

}  // namespace ravel
