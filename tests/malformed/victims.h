// Small files of every kind, to be damaged.
#pragma once

#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "make/make_mesh.h"
#include "support/file_parts.h"
#include "support/quadratic_tets.h"

namespace ravel::test {

struct Victim {
    std::string name;
    CellKind kind = CellKind::polygon;
    Bytes file;
};

// `quadratic`: tets with points of their edges.
inline Victim victim(const std::string& recipe, const EncodeOptions& options = {},
                     bool quadratic = false) {
    Result<Mesh> mesh = make::make_mesh(recipe);
    REQUIRE(mesh.ok());
    if (quadratic) *mesh = with_edge_nodes(*mesh, 3);
    mesh->notes.push_back({"key", "text"});
    Result<Encoded> packed = encode(*mesh, options);
    REQUIRE(packed.ok());
    return {recipe, mesh->kind, std::move(packed->bytes)};
}

inline std::vector<Victim> victims() {
    std::vector<Victim> all;
    EncodeOptions grid, ordered;
    grid.position_bits = 9;
    ordered.keep_order = true;
    ordered.position_bits = 20;
    for (const char* recipe :
         {"tiny:empty", "tiny:quad", "tiny:degrees-0-1-2", "tiny:pinch", "torus:size=6x4",
          "polygons:mixed,size=4x4,attributes", "soup:polygons=12,seed=3,attributes",
          "tiny:tets-on-one-face", "tets:box=2x1x1,attributes,companions", "soup:tets=12,seed=4"})
        for (const EncodeOptions& options : {EncodeOptions{}, grid, ordered})
            all.push_back(victim(recipe, options));
    for (const EncodeOptions& options : {EncodeOptions{}, grid, ordered})
        all.push_back(victim("tets:box=1,companions", options, true));
    EncodeOptions fast = grid;
    fast.fast = true;
    for (const char* recipe : {"torus:size=6x4", "tiny:tets-on-one-face",
                               "tets:box=3x2x2,jitter=0.2", "soup:tets=12,seed=4"})
        all.push_back(victim(recipe, fast));
    return all;
}

inline Code code_of(const Bytes& file, const DecodeOptions& options = {}) {
    DecodeOptions all = options;
    all.steps = true;
    const auto decoded = decode(file, all);
    REQUIRE_FALSE(decoded.ok());
    CHECK_FALSE(decoded.error().detail.empty());
    return decoded.error().code;
}

}  // namespace ravel::test
