#include "ravel/mesh.h"

#include <string>

namespace ravel {

std::size_t size_of(Scalar scalar) {
    switch (scalar) {
        case Scalar::u8:
        case Scalar::i8:
            return 1;
        case Scalar::u16:
        case Scalar::i16:
            return 2;
        case Scalar::u32:
        case Scalar::i32:
        case Scalar::f32:
            return 4;
        case Scalar::u64:
        case Scalar::i64:
        case Scalar::f64:
            return 8;
    }
    return 0;
}

const char* name_of(Scalar scalar) {
    switch (scalar) {
        case Scalar::u8:
            return "uint8";
        case Scalar::i8:
            return "int8";
        case Scalar::u16:
            return "uint16";
        case Scalar::i16:
            return "int16";
        case Scalar::u32:
            return "uint32";
        case Scalar::i32:
            return "int32";
        case Scalar::u64:
            return "uint64";
        case Scalar::i64:
            return "int64";
        case Scalar::f32:
            return "float32";
        case Scalar::f64:
            return "float64";
    }
    return "unknown";
}

const char* name_of(Place place) {
    switch (place) {
        case Place::point:
            return "point";
        case Place::corner:
            return "corner";
        case Place::cell:
            return "cell";
        case Place::companion:
            return "companion";
        case Place::mesh:
            return "mesh";
    }
    return "unknown";
}

const char* name_of(CellKind kind) {
    return kind == CellKind::tet ? "tet" : "polygon";
}

Array make_array(Scalar scalar, std::uint32_t arity, std::size_t count) {
    Array array{scalar, arity, {}};
    array.bytes.resize(array.stride() * count);
    return array;
}

namespace {

Status bad(std::uint64_t at, std::string detail) {
    return Error{Code::bad_mesh, at, std::move(detail)};
}

Status check_cells(const Mesh& mesh) {
    if (mesh.kind == CellKind::tet) {
        if (!mesh.corner_begin.empty()) return bad(0, "a tet mesh has no corner_begin");
        if (mesh.corners.size() % 4 != 0)
            return bad(mesh.corners.size() / 4, "tets have four corners each");
    } else {
        if (mesh.corner_begin.empty() && !mesh.corners.empty())
            return bad(0, "a polygon mesh with corners needs corner_begin");
        if (!mesh.corner_begin.empty() &&
            (mesh.corner_begin.front() != 0 || mesh.corner_begin.back() != mesh.corners.size()))
            return bad(0, "corner_begin runs from 0 to the number of corners");
        for (std::size_t c = 1; c < mesh.corner_begin.size(); ++c)
            if (mesh.corner_begin[c] < mesh.corner_begin[c - 1])
                return bad(c - 1, std::string("corner_begin must not descend (cell ") +
                                      std::to_string(c - 1) + ")");
    }
    const Index points = mesh.point_count();
    for (std::size_t i = 0; i < mesh.corners.size(); ++i)
        if (mesh.corners[i] >= points)
            return bad(i, std::string("corner ") + std::to_string(i) + " names point " +
                              std::to_string(mesh.corners[i]) + " of " + std::to_string(points));
    return Done{};
}

// What is wrong with a part of a mesh, to be read after its name; null if nothing is.
const char* fault_of(const Mesh& mesh, const CompanionBlock& block) {
    if (block.nodes_per_cell == 0
            ? !block.nodes.empty()
            : block.nodes.size() % block.nodes_per_cell != 0 ||
                  block.nodes.size() / block.nodes_per_cell != block.cell_count)
        return "has not cell_count * nodes_per_cell nodes";
    if (!block.hosts.empty() && block.hosts.size() != block.cell_count)
        return "has not one host per cell";
    const Index points = mesh.point_count(), cells = mesh.cell_count();
    for (Index node : block.nodes)
        if (node >= points) return "names a point that does not exist";
    for (Index host : block.hosts)
        if (host >= cells) return "names a cell that does not exist";
    return nullptr;
}

const char* fault_of(const Mesh& mesh, const Reference& r, const Array& values) {
    const Scalar scalar = values.scalar;
    if (is_float(scalar) || size_of(scalar) < 4)
        return "refers by something else than 32-bit integers";
    if (r.component >= values.arity || (r.place != Place::point && r.place != Place::cell))
        return "refers by a component it has not, or to what has no order";
    const Index count = element_count(mesh, r.place);
    const std::int64_t most = scalar == Scalar::i32   ? std::int64_t{0x7FFFFFFF}
                              : scalar == Scalar::u32 ? std::int64_t{0xFFFFFFFF}
                                                      : std::int64_t{1} << 62;
    const bool has_sign = scalar == Scalar::i32 || scalar == Scalar::i64;
    const std::int64_t least = !has_sign               ? 0
                               : scalar == Scalar::i32 ? -(std::int64_t{1} << 31)
                                                       : -(std::int64_t{1} << 40);
    if (r.base < least || r.base > std::int64_t{1} << 40 ||
        r.base + static_cast<std::int64_t>(count) > most)
        return "is too narrow for the numbers it would need";
    return nullptr;
}

const char* fault_of(const Mesh& mesh, const Attribute& attribute) {
    const Array& values = attribute.values;
    if (values.arity == 0 || values.arity > 65535 || values.bytes.size() % values.stride() != 0)
        return "has no whole number of tuples";
    for (std::size_t i = 0; i < attribute.references.size(); ++i) {
        const Reference& r = attribute.references[i];
        if (i > 0 && r.component <= attribute.references[i - 1].component)
            return "lists its references in another order than by component";
        if (const char* fault = fault_of(mesh, r, values)) return fault;
    }
    if (attribute.place == Place::mesh)
        return attribute.index.empty() ? nullptr : "is of the mesh and has no index";
    const Index elements = element_count(mesh, attribute.place);
    if (elements == 0) return nullptr;  // a pool that nothing refers to
    const Index count = values.count();
    if ((attribute.index.empty() ? count : attribute.index.size()) != elements)
        return "has not one value per element of its place";
    for (Index i : attribute.index)
        if (i != kNoIndex && i >= count) return "refers to a tuple that does not exist";
    return nullptr;
}

}  // namespace

Index element_count(const Mesh& mesh, Place place) {
    switch (place) {
        case Place::point:
            return mesh.point_count();
        case Place::corner:
            return mesh.corners.size();
        case Place::cell:
            return mesh.cell_count();
        case Place::companion:
            return mesh.companion_count();
        case Place::mesh:
            return 0;
    }
    return 0;
}

Status check_mesh(const Mesh& mesh) {
    const Array& positions = mesh.positions;
    if (positions.arity != 3 || !is_float(positions.scalar))
        return bad(0, "positions are three float32 or float64 per point");
    if (positions.bytes.size() % positions.stride() != 0)
        return bad(0, "positions have no whole number of points");
    if (Status status = check_cells(mesh); !status) return status;
    for (std::size_t b = 0; b < mesh.companions.size(); ++b)
        if (const char* fault = fault_of(mesh, mesh.companions[b]))
            return bad(b, std::string("companion block ") + std::to_string(b) + ' ' + fault);
    for (std::size_t n = 0; n < mesh.tag_names.size(); ++n)
        if (mesh.tag_names[n].dimension < -1 || mesh.tag_names[n].dimension > 3)
            return bad(n, std::string("the name \"") + mesh.tag_names[n].name +
                              "\" has dimension " + std::to_string(mesh.tag_names[n].dimension) +
                              "; there are 0 to 3, and -1 for none");
    for (std::size_t a = 0; a < mesh.attributes.size(); ++a)
        if (const char* fault = fault_of(mesh, mesh.attributes[a]))
            return bad(a, std::string("attribute \"") + mesh.attributes[a].name + "\" " + fault);
    return Done{};
}

}  // namespace ravel
