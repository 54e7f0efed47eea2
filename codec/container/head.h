// The sections `head` and `block`: fields, in the order in which they are stored.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "container/layout.h"
#include "ravel/mesh.h"

namespace ravel {

struct AttributeHead {
    std::string name;
    Place place = Place::point;
    Scalar scalar = Scalar::f32;
    std::uint32_t arity = 1;
    bool indexed = false;
    Index tuples = 0;
    std::vector<Reference> references;
    double bound = 0;  // 0: exact values
    double error = 0;
};

struct Head {
    CellKind kind = CellKind::polygon;
    Scalar position_scalar = Scalar::f32;
    bool lossless = true;
    bool keeps_order = false;
    std::uint8_t position_bits = 0;
    double step = 0;  // the rest only for grids
    double origin[3] = {0, 0, 0};
    double bound = 0;
    double error = 0;
    std::vector<AttributeHead> attributes;
};

struct BlockHead {
    Index points = 0;
    Index cells = 0;
    Index corners = 0;
    Index vertices = 0;  // of the walk; more than points where some had to be cut
    Index unused_points = 0;
    Index uniform_degree = 0;  // 0: degrees differ
    Index companions = 0;
    Index components = 0;
    Index links = 0;             // of the strip as the walk runs
    bool wants_mending = false;  // they add more cells than the encoder was allowed
    bool has_border = true;
    bool has_flips = false;
    bool has_copies = false;
    bool mirrored = false;         // tets: most have negative volume
    bool has_edge_points = false;  // tets: the first unused points are those of the edges
    Index grid_side = 1;           // tets: the walk's grid of vertices
    std::array<std::uint32_t, 3> grid_count{1, 1, 1};
    Index shape_step = 0;         // tets: lengths that tell shapes of gates apart; 0: no leaders
    bool leaders_move = false;    // tets: what they tell is moved, not mapped
    bool has_precedents = false;  // polygons: answers of the walk are asked for by those before
    bool by_folds = false;        // tets: the walk is FoldWalk's
};

// The vertex grid has its cubes in blocks of 4 x 4 x 4, so many of a block with so many vertices.
inline std::uint64_t most_grid_blocks(Index vertices) {
    return vertices / 4 + 64;
}
inline std::uint64_t grid_blocks_of(std::uint64_t cubes) {
    return (cubes + 3) / 4;
}

// Is x as many steps, none of them broken? The head counts an origin in steps where it is on all
// axes.
bool is_whole_steps(double x, double step);
// Or so many steps at a time, where all axes are such: about a 64th of the longest side.
double origin_unit(int position_bits);
// What the head keeps of an error: the least of the 256 it can keep that is not below it.
double kept_error(double error, double bound);
Bytes write_head(const Head& head);
Result<Head> read_head(ByteReader& in);
Bytes write_block_head(const BlockHead& block, CellKind kind);
Result<BlockHead> read_block_head(ByteReader& in, CellKind kind);

}  // namespace ravel
