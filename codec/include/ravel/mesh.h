// The mesh as users, files and the codec exchange it: points, cells of one kind, everything that
// came with them. Plain data; counts, offsets and indices are 64-bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ravel/result.h"

namespace ravel {

using Index = std::uint64_t;
inline constexpr Index kNoIndex = ~Index{0};

enum class Scalar : std::uint8_t { u8, i8, u16, i16, u32, i32, u64, i64, f32, f64 };

std::size_t size_of(Scalar scalar);
const char* name_of(Scalar scalar);
inline bool is_float(Scalar s) {
    return s == Scalar::f32 || s == Scalar::f64;
}

// `count()` tuples of `arity` scalars, little-endian in memory, bit patterns kept (NaN payloads,
// -0).
struct Array {
    Scalar scalar = Scalar::f64;
    std::uint32_t arity = 1;  // 1..65535
    std::vector<std::byte> bytes;

    std::size_t stride() const { return size_of(scalar) * arity; }
    std::size_t count() const { return stride() == 0 ? 0 : bytes.size() / stride(); }
    template <class T>
    std::span<T> as() {
        return {reinterpret_cast<T*>(bytes.data()), bytes.size() / sizeof(T)};
    }
    template <class T>
    std::span<const T> as() const {
        return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
    }
};

// An array of `count` tuples, all bytes zero.
Array make_array(Scalar scalar, std::uint32_t arity, std::size_t count);

enum class Place : std::uint8_t { point, corner, cell, companion, mesh };
const char* name_of(Place place);

// Component `component` of every tuple is a number of a point or cell, counted from `base`; numbers
// that name none (0 or -1 for "no neighbour") are allowed and kept. The numbers follow their
// elements when a file changes the order.
struct Reference {
    std::uint32_t component = 0;
    Place place = Place::point;  // point or cell
    std::int64_t base = 0;
};

// Named values on points, cell corners, cells, companion cells (all blocks one after the other) or
// the mesh as a whole (any number of tuples).
// With `index` empty there is one tuple per element. Otherwise element i has tuple index[i], or
// none where index[i] == kNoIndex; `values` is then a pool (OBJ's vt and vn are such pools on
// corners).
struct Attribute {
    std::string name;
    Place place = Place::point;
    Array values;
    std::vector<Index> index;
    std::vector<Reference> references;  // by component; values are then 32- or 64-bit integers
};

// Cells that ride along with the main kind: boundary triangles, lines, points, the edge nodes of
// quadratic tets, wedges and whatever else a volume file holds. One block holds cells of one type
// and size, in file order.
struct CompanionBlock {
    std::uint16_t vtk_type = 0;        // VTK's cell type number; nodes are in VTK's order
    std::uint32_t nodes_per_cell = 0;  // may be 0
    Index cell_count = 0;
    std::vector<Index> nodes;  // cell_count * nodes_per_cell points
    // Edge nodes of quadratic tets are a companion of vtk_type 24 with the six edge nodes only (VTK
    // order); then `hosts` names the tet (cell) each belongs to. Empty for all other companions.
    std::vector<Index> hosts;
};

// The name of a value of an integer attribute: Gmsh's physical names, OBJ's groups and materials.
struct TagName {
    std::string attribute;        // the attribute whose values are named
    std::int32_t dimension = -1;  // 0..3 where names are per dimension (Gmsh), -1 otherwise
    std::int64_t value = 0;
    std::string name;
};

// Words about the mesh as a whole, e.g. {"obj:mtllib", "chair.mtl"}. Order is kept.
struct Note {
    std::string key;
    std::string text;
};

enum class CellKind : std::uint8_t { polygon, tet };
const char* name_of(CellKind kind);  // "polygon", "tet"

// Invariants (checked by `check_mesh`): positions have arity 3 and are f32 or f64; corner_begin is
// ascending from 0 to corners.size() for polygons and empty for tets, whose corners come in fours;
// every corner and companion node is a point; attributes have one tuple or index per element; names
// have a dimension from -1 to 3.
// Nothing else is asked: any soup is a mesh.
struct Mesh {
    CellKind kind = CellKind::polygon;
    Array positions{Scalar::f32, 3, {}};
    std::vector<Index>
        corner_begin;  // polygons: cell c has corners [corner_begin[c], corner_begin[c+1])
    std::vector<Index> corners;  // points; polygons counter-clockwise, tets in VTK's order
    std::vector<CompanionBlock> companions;
    std::vector<Attribute> attributes;
    std::vector<TagName> tag_names;
    std::vector<Note> notes;

    Index point_count() const { return positions.count(); }
    Index cell_count() const {
        if (kind == CellKind::tet) return corners.size() / 4;
        return corner_begin.empty() ? 0 : corner_begin.size() - 1;
    }
    Index companion_count() const {
        Index n = 0;
        for (const CompanionBlock& block : companions) n += block.cell_count;
        return n;
    }
    std::span<const Index> cell(Index c) const {
        if (kind == CellKind::tet) return {corners.data() + 4 * c, 4};
        return {corners.data() + corner_begin[c], corners.data() + corner_begin[c + 1]};
    }
};

// How many elements a place has; 0 for the mesh as a whole.
Index element_count(const Mesh& mesh, Place place);

// Are the invariants above true? The error names the first cell, companion or attribute that breaks
// one.
Status check_mesh(const Mesh& mesh);

}  // namespace ravel
