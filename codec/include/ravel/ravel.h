// Ravel: packs polygon and tetrahedral meshes by winding all cells onto one strip.
//
//     ravel::Mesh mesh = ...;
//     auto packed = ravel::encode(mesh);                        // bit-exact by default
//     if (!packed) return complain(packed.error());
//     auto again = ravel::decode(packed->bytes);                // safe on any bytes
//
// What a file keeps: every point, cell, companion, attribute and name; positions exactly or within
// a stated bound. What it does not keep unless asked (`keep_order`): the order of points and cells,
// the corner a polygon starts with, and which even permutation a tet is written in.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ravel/mesh.h"
#include "ravel/result.h"

namespace ravel {

// An attribute of floats that may lose precision. Exactly one of these is given; what can't be
// brought within the bound (NaN, infinities) is kept bit for bit.
struct AttributeOptions {
    std::string name;                          // all attributes of this name
    std::optional<int> bits;                   // 1..30 along the widest range of a component
    std::optional<double> max_error;           // > 0, largest absolute error of any component
    std::optional<double> max_error_relative;  // > 0, the same in widest ranges
    std::optional<int> octahedral;             // 3..24, unit vectors of 3 components by two numbers
};

struct EncodeOptions {
    // Positions: exact unless one of these is given. They exclude each other. Points that lie on a
    // coarser grid of few digits already stay on it (but with `lattice`).
    std::optional<int> position_bits;  // 1..30 bits along the longest side of the bounding box
    std::optional<double> max_error;   // > 0, largest absolute error of any coordinate
    std::optional<double> max_error_relative;  // > 0, the same in diagonals of the bounding box
    // A power of two: every coordinate becomes the nearest multiple. Meshes packed one by one on
    // the same lattice agree bit for bit on the points they share.
    std::optional<double> lattice;
    bool float32 = false;     // round float64 positions to float32 first
    bool keep_order = false;  // restore point and cell order, start corners, tet permutations
    // Percent of cells that the strip may add when it is read as the walk runs; 2.5 for polygons,
    // 12 for tets if not given. Where it adds more the file says that the strip is to be mended
    // when it is made, which takes time but splits next to no cell. Costs no bytes either way.
    std::optional<double> strip_budget;
    std::vector<AttributeOptions> attributes;  // all others come back bit for bit
    int level = 19;                            // zstd's level, 1..22
    // Files that are mostly made and decoded at twice the speed or more, but are larger, most where
    // a mesh repeats or mirrors itself or lies in planes: none of this is looked for but lattices of
    // tets; of other tets places of vertices do not tell which ones they have.
    bool fast = false;
    // How many threads may work at a time, the caller's among them; 0: as many as the machine can
    // run. The bytes are the same.
    int threads = 1;
};

// Where the elements of the mesh given to `encode` are in the mesh that `decode` returns.
struct OrderMaps {             // kTetTurns: the 24 permutations of 0 1 2 3 in lexicographic order
    std::vector<Index> point;  // old point -> new point
    std::vector<Index> cell;   // old cell -> new cell
    std::vector<std::uint32_t>
        turn;  // old cell -> which of its corners the new cell starts with (polygons),
               // or the number of the permutation in kTetTurns (tets)
    std::vector<Index> companion;  // old companion -> new companion, over all blocks; it stays in
                                   // its block
    std::vector<std::uint32_t>
        companion_turn;  // old companion -> which of its nodes the new one starts with
};

// The strip of a file, as the walk runs: one per facet-connected component.
struct WalkStrip {
    Index components = 0;
    Index links = 0;
    Index open_strips = 0;  // of those, the ones that do not close
    Index added_cells = 0;  // once every link splits its two cells
};

struct Encoded {
    std::vector<std::byte> bytes;
    OrderMaps order;
    WalkStrip strip;
    double position_bound = 0;             // 0 for exact positions
    double position_error = 0;             // largest error, measured with the decoder's arithmetic
    std::vector<double> attribute_bounds;  // per attribute; 0 for exact values
    // What an ideal entropy coder would make of the codes of connectivity, under the same models.
    double connectivity_ideal_bytes = 0;
};

// Packs a mesh. Fails on broken options or a Mesh that breaks its invariants, never on dirty
// geometry or topology. Linear in the mesh but for sorting; the same bytes on every machine with
// one libzstd.
Result<Encoded> encode(const Mesh& mesh, const EncodeOptions& options = {});

struct DecodeOptions {
    std::uint64_t memory_limit = std::uint64_t{16} << 30;  // bytes the decoder may allocate in all
    bool steps = false;                                    // also tell how the strip runs
};

// How the walk runs over the decoded mesh, in the order of its visits (which is the order of the
// cells, unless the file keeps another), and which of its steps are links of the strip. Facet f of
// a polygon is its side from corner f to f+1; facet f of a tet lies opposite corner f.
struct StripStep {
    Index cell = 0;           // of the decoded mesh
    Index from = kNoIndex;    // the cell the walk came from; kNoIndex at the start of a component
    std::uint32_t exit = 0;   // facet of `from`
    std::uint32_t entry = 0;  // facet of this cell
    bool link = false;        // the step splits both cells once the strip is materialised
};

struct Decoded {
    Mesh mesh;
    std::vector<StripStep> steps;  // one per cell; empty unless asked for
    bool wants_mending = false;    // see EncodeOptions::strip_budget
};

// Unpacks. Any bytes are safe: they give a mesh or an Error. Linear in input plus output.
Result<Decoded> decode(std::span<const std::byte> bytes, const DecodeOptions& options = {});

struct SectionInfo {
    std::string name;             // e.g. "connectivity", "positions"
    std::uint64_t bytes = 0;      // as stored
    std::uint64_t raw_bytes = 0;  // unpacked
};

struct FileInfo {
    int version = 0;
    CellKind kind = CellKind::polygon;
    Index points = 0, cells = 0, corners = 0, companions = 0, components = 0;
    Index links = 0;  // of the strip as the walk runs
    bool wants_mending = false;
    Scalar position_scalar = Scalar::f32;
    bool lossless_positions = true;
    bool keeps_order = false;
    int position_bits = 0;  // asked for along the grid's longest side; 0 for lossless
    double grid_step = 0;
    double position_bound = 0;
    double position_error = 0;  // as measured by the encoder
    std::uint64_t file_bytes = 0;
    std::uint64_t header_bytes = 0;
    std::vector<SectionInfo> sections;
    struct AttributeInfo {
        std::string name;
        Place place = Place::point;
        Scalar scalar = Scalar::f32;
        std::uint32_t arity = 1;
        double bound = 0;  // of every component; 0 for exact values
        double error = 0;  // as measured by the encoder
    };
    std::vector<AttributeInfo> attributes;
};

// Reads headers only, once the checksum says that the bytes are whole; packed data is not unpacked.
Result<FileInfo> inspect(std::span<const std::byte> bytes);

// Is `decoded` what `original` became? Connectivity, order maps, attributes and names exactly;
// finite positions within `bound` (0: bit for bit), others bit for bit; attributes that have one of
// `attribute_bounds` likewise. Linear.
struct Comparison {
    bool equal = false;
    bool connectivity_equal = false;
    bool attributes_equal = false;
    bool positions_equal = false;
    bool order_kept = false;  // points, cells, companions and pools come in the original order
    double max_error = 0;
    std::vector<double> attribute_errors;  // per attribute, where there are bounds
    std::string difference;                // the first difference in words, empty when equal
};
Comparison compare_meshes(const Mesh& original, const Mesh& decoded, const OrderMaps& order,
                          double bound, std::span<const double> attribute_bounds = {});

}  // namespace ravel
