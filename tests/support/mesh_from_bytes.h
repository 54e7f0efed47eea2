// Meshes and options from arbitrary bytes: the same generator serves the fuzzers and the property
// tests. Short strings give small dirty meshes; every kind of dirt is a few bytes away.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "ravel/ravel.h"

namespace ravel::test {

struct MeshCase {
    Mesh mesh;
    EncodeOptions options;
};

MeshCase mesh_from_bytes(std::span<const std::byte> bytes);

// Encodes, decodes and compares; empty, or what went wrong. Options that no grid can meet are no
// trouble.
std::string trouble(const Mesh& mesh, const EncodeOptions& options);

// Are the steps a strip over the decoded mesh? Every cell once; two cells of a step share the
// facets it names, by points. Empty, or what is wrong.
std::string step_trouble(const Decoded& decoded);

}  // namespace ravel::test
