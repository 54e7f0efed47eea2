// A codec in the comparison: three functions over a prepared input.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/grid.h"
#include "ravel/ravel.h"

namespace ravel::compare {

// What every contender gets: the same cells and positions, nothing else unless asked.
struct Input {
    Mesh mesh;
    EncodeOptions options;
    std::optional<Grid> grid;  // what the options mean for peers; empty for lossless
};

struct Packed {
    std::vector<std::byte> bytes;
    std::optional<std::uint64_t> connectivity_bytes, geometry_bytes, attribute_bytes;
    std::optional<double> connectivity_ideal_bytes;
    OrderMaps order;  // ravel only, as the bounds
    double bound = 0;
    std::vector<double> attribute_bounds;
};

// How what came back relates to what went in.
struct Verdict {
    std::string connectivity_kept = "lost";  // quads, tets, triangulated or lost
    double max_error = 0;
    std::string note;
};

struct Contender {
    const char* name;
    const char* settings;
    // Empty, or why this codec cannot take part with this mesh.
    std::string (*refuses)(const Input& input);
    Result<Packed> (*encode)(const Input& input);
    Result<Mesh> (*decode)(std::span<const std::byte> bytes, const Input& input);
    Verdict (*check)(const Input& input, const Packed& packed, const Mesh& decoded);
    // For codecs whose files don't tell their parts: the bytes of connectivity, by another way.
    std::optional<std::uint64_t> (*connectivity)(const Input& input) = nullptr;
};

Contender ours();
Contender draco_triangles();
Contender draco_polygons();
Contender raw_zstd();
Contender raw_xz();
Contender grid_xz();
Contender delta_xz();

// "quads" or "tets": everything came back as it was. (The contract says quads for polygons of any
// degree.)
inline const char* kept_word(CellKind kind) {
    return kind == CellKind::tet ? "tets" : "quads";
}

}  // namespace ravel::compare
