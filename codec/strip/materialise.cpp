// Links are split one after the other in an evolving mesh; the facet that carries a later link is
// outer to earlier splits, so it moves to one of the pieces and splits nest. Then the strip is
// followed from each root.
// Cost: linear in the output; a split is constant but for the corners of its polygons.
#include "strip/materialise.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "strip/split.h"

namespace ravel {

Id add_vertex(SplitMesh& mesh, std::span<const Blend> parts) {
    for (const Blend& part : parts) {
        mesh.blend.push_back(part.vertex);
        mesh.weight.push_back(part.weight);
    }
    mesh.blend_first.push_back(static_cast<Id>(mesh.blend.size()));
    return mesh.old_vertices + static_cast<Id>(mesh.blend_first.size()) - 2;
}

Id add_cell(SplitMesh& mesh, std::span<const Id> vertices, Id parent) {
    const Id cell = mesh.size();
    for (const Id v : vertices) {
        mesh.vertex.push_back(v);
        mesh.cell_of.push_back(cell);
        mesh.twin.push_back(kNone);
        mesh.role.push_back(FacetRole::none);
        mesh.origin.push_back(kNone);
    }
    mesh.first.push_back(static_cast<Id>(mesh.vertex.size()));
    mesh.parent.push_back(parent);
    mesh.piece[parent] = cell;
    return cell;
}

void glue(SplitMesh& mesh, Id facet, Id twin) {
    mesh.twin[facet] = twin;
    mesh.twin[twin] = facet;
}

void take_over(SplitMesh& mesh, Id old, Id fresh) {
    if (mesh.twin[old] != kNone) glue(mesh, fresh, mesh.twin[old]);
    mesh.role[fresh] = mesh.role[old];
    mesh.origin[fresh] = mesh.origin[old];
    if (mesh.origin[fresh] != kNone) mesh.now[mesh.origin[fresh]] = fresh;
}

void set_role(SplitMesh& mesh, Id facet, FacetRole role) {
    mesh.role[facet] = role;
    mesh.role[mesh.twin[facet]] = role;
}

namespace {

SplitMesh start_from(const Complex& complex, const Strip& strip) {
    SplitMesh split;
    const Id cells = complex.cell_count();
    split.kind = complex.kind;
    split.first = complex.first;
    if (split.first.empty()) split.first.push_back(0);
    split.cell_of = complex.cell_of;
    split.twin = complex.twin;
    split.vertex = complex.vertex;
    split.role = strip.role;
    split.origin.resize(complex.twin.size());
    split.parent.resize(cells);
    for (Id f = 0; f < complex.twin.size(); ++f) split.origin[f] = f;
    for (Id c = 0; c < cells; ++c) split.parent[c] = c;
    split.now = split.origin;
    split.piece = split.parent;
    split.old_vertices = static_cast<Id>(complex.point.size());
    return split;
}

// One strip in order, and the facet by which each cell is left.
struct Trace {
    std::vector<Id> cells, exits;
    bool closed = false;
};

Trace trace(const SplitMesh& split, Id start) {
    Trace t;
    Id cell = start, entry = kNone;
    for (;;) {
        Id exit = kNone;
        for (Id f = split.first[cell]; f < split.first[cell + 1] && exit == kNone; ++f)
            if (split.role[f] == FacetRole::strip && f != entry) exit = f;
        t.cells.push_back(cell);
        t.exits.push_back(exit);
        if (exit == kNone) return t;
        entry = split.twin[exit];
        cell = split.cell_of[entry];
        if (cell == start) {
            t.closed = true;
            return t;
        }
    }
}

// From the root's piece at the end of the strip where it has ends.
Trace trace_component(const SplitMesh& split, Id root) {
    Trace t = trace(split, split.piece[root]);
    if (t.closed) return t;
    t = trace(split, t.cells.back());
    if (split.parent[t.cells.front()] != root) t = trace(split, t.cells.back());
    return t;
}

template <class T>
void append_blends(Array& values, const SplitMesh& split, const std::vector<Id>& point_of) {
    const std::size_t arity = values.arity, old = values.count();
    const std::size_t fresh = split.blend_first.size() - 1;
    values.bytes.resize(values.stride() * (old + fresh));
    const std::span<T> v = values.as<T>();
    for (std::size_t i = 0; i < fresh; ++i) {
        for (std::size_t k = 0; k < arity; ++k) {
            double sum = 0;
            for (Id j = split.blend_first[i]; j < split.blend_first[i + 1]; ++j)
                sum +=
                    split.weight[j] * static_cast<double>(v[point_of[split.blend[j]] * arity + k]);
            v[(old + i) * arity + k] = static_cast<T>(sum);
        }
    }
}

void append_points(Array& values, const SplitMesh& split, const std::vector<Id>& point_of) {
    if (values.scalar == Scalar::f32) return append_blends<float>(values, split, point_of);
    if (values.scalar == Scalar::f64) return append_blends<double>(values, split, point_of);
    for (std::size_t i = 0; i + 1 < split.blend_first.size(); ++i) {
        const std::size_t from = point_of[split.blend[split.blend_first[i]]] * values.stride();
        for (std::size_t b = 0; b < values.stride(); ++b)
            values.bytes.push_back(values.bytes[from + b]);
    }
}

std::vector<Attribute> carry_attributes(const Mesh& mesh, const SplitMesh& split,
                                        const std::vector<Id>& point_of,
                                        const std::vector<Index>& parent) {
    std::vector<Attribute> carried;
    for (const Attribute& attribute : mesh.attributes) {
        const bool names_cells =
            std::any_of(attribute.references.begin(), attribute.references.end(),
                        [](const Reference& r) { return r.place == Place::cell; });
        if (attribute.place == Place::corner || attribute.place == Place::companion || names_cells)
            continue;
        Attribute& copy = carried.emplace_back(attribute);
        if (attribute.place == Place::point && attribute.index.empty()) {
            append_points(copy.values, split, point_of);
        } else if (attribute.place == Place::point) {
            for (std::size_t i = 0; i + 1 < split.blend_first.size(); ++i)
                copy.index.push_back(copy.index[point_of[split.blend[split.blend_first[i]]]]);
        } else if (attribute.place == Place::cell && attribute.index.empty()) {
            const std::size_t stride = attribute.values.stride();
            copy.values.bytes.resize(stride * parent.size());
            for (std::size_t c = 0; c < parent.size(); ++c)
                std::memcpy(copy.values.bytes.data() + c * stride,
                            attribute.values.bytes.data() + parent[c] * stride, stride);
        } else if (attribute.place == Place::cell) {
            copy.index.clear();
            for (const Index p : parent) copy.index.push_back(attribute.index[p]);
        }
    }
    return carried;
}

}  // namespace

Result<Materialised> materialise(const Mesh& mesh, const Complex& complex, const Strip& strip) {
    SplitMesh split = start_from(complex, strip);
    for (Id f = 0; f < complex.twin.size(); ++f) {
        if (strip.role[f] != FacetRole::link || f > complex.twin[f]) continue;
        const Id link = split.now[f];
        if (!(complex.kind == CellKind::tet ? split_tets(split, link)
                                            : split_polygons(split, link)))
            return Error{
                Code::bad_mesh, complex.cell_of[f],
                "cell " + std::to_string(complex.cell_of[f]) + " is too small to be split"};
    }
    std::vector<Id> point_of = complex.point;
    for (std::size_t i = 0; i + 1 < split.blend_first.size(); ++i)
        point_of.push_back(static_cast<Id>(mesh.point_count() + i));

    Materialised out;
    out.mesh.kind = mesh.kind;
    out.first.push_back(0);
    if (mesh.kind == CellKind::polygon) out.mesh.corner_begin.push_back(0);
    for (const Id root : strip.roots) {
        const Trace t = trace_component(split, root);
        for (std::size_t i = 0; i < t.cells.size(); ++i) {
            const Id cell = t.cells[i];
            for (Id f = split.first[cell]; f < split.first[cell + 1]; ++f)
                out.mesh.corners.push_back(point_of[split.vertex[f]]);
            if (mesh.kind == CellKind::polygon)
                out.mesh.corner_begin.push_back(out.mesh.corners.size());
            out.parent.push_back(split.parent[cell]);
            out.exit.push_back(t.exits[i] == kNone ? kNone : t.exits[i] - split.first[cell]);
        }
        out.first.push_back(out.parent.size());
        out.closed.push_back(t.closed);
    }
    out.mesh.positions = mesh.positions;
    append_points(out.mesh.positions, split, point_of);
    out.mesh.attributes = carry_attributes(mesh, split, point_of, out.parent);
    out.mesh.tag_names = mesh.tag_names;
    out.mesh.notes = mesh.notes;
    if (out.parent.size() < mesh.cell_count())
        return Error{Code::bad_mesh, out.parent.size(), "the strip does not reach every cell"};
    out.added_cells = out.parent.size() - mesh.cell_count();
    out.added_points = out.mesh.point_count() - mesh.point_count();
    return out;
}

Status check_materialised(const Mesh& original, const Materialised& result) {
    const Mesh& mesh = result.mesh;
    const auto wrong = [](Index cell, const char* detail) {
        return Error{Code::corrupt, cell, detail};
    };
    if (Status status = check_mesh(mesh); !status) return status;
    const Index cells = mesh.cell_count();
    if (cells != original.cell_count() + result.added_cells || result.parent.size() != cells ||
        result.exit.size() != cells ||
        mesh.point_count() != original.point_count() + result.added_points)
        return wrong(0, "counts do not add up");
    if (result.first.empty() || result.first.front() != 0 || result.first.back() != cells ||
        result.closed.size() + 1 != result.first.size())
        return wrong(0, "components do not cover the cells");
    std::vector<std::uint8_t> found(original.cell_count(), 0);
    for (const Index p : result.parent) {
        if (p >= found.size()) return wrong(p, "a parent is no cell");
        found[p] = 1;
    }
    if (std::find(found.begin(), found.end(), 0) != found.end()) return wrong(0, "a cell was lost");

    // The points of a facet, ascending.
    const auto facet = [&](Index cell, std::size_t f) {
        const auto corners = mesh.cell(cell);
        std::vector<Index> points;
        if (mesh.kind == CellKind::polygon) {
            points = {corners[f], corners[(f + 1) % corners.size()]};
        } else {
            for (std::size_t i = 0; i < 4; ++i)
                if (i != f) points.push_back(corners[i]);
        }
        std::sort(points.begin(), points.end());
        return points;
    };
    for (std::size_t k = 0; k + 1 < result.first.size(); ++k) {
        for (Index c = result.first[k]; c < result.first[k + 1]; ++c) {
            const bool last = c + 1 == result.first[k + 1];
            if (last && result.closed[k] == 0) continue;
            const Index next = last ? result.first[k] : c + 1;
            if (result.exit[c] >= mesh.cell(c).size()) return wrong(c, "an exit is no facet");
            const std::vector<Index> shared = facet(c, result.exit[c]);
            bool touches = false;
            for (std::size_t f = 0; f < mesh.cell(next).size(); ++f)
                touches |= facet(next, f) == shared;
            if (!touches || next == c)
                return wrong(c, "a cell does not share its exit with the next");
        }
    }
    return Done{};
}

}  // namespace ravel
