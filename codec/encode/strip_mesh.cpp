#include "encode/strip_mesh.h"

namespace ravel {
namespace {

Array decoded_positions(const Mesh& mesh, const Reorder& order, const PositionPlan& plan) {
    Array out = gather(mesh.positions, order.old_point);
    if (!plan.format.grid()) return out;
    for (std::size_t p = 0; p < order.old_point.size(); ++p) {
        const Index old = order.old_point[p];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (plan.values[old][axis].escaped) continue;
            const double x =
                coordinate_of(plan.grid, axis, plan.values[old][axis].whole, out.scalar);
            if (out.scalar == Scalar::f32)
                out.as<float>()[3 * p + axis] = static_cast<float>(x);
            else
                out.as<double>()[3 * p + axis] = x;
        }
    }
    return out;
}

Index first_corner(const Mesh& mesh, Index cell) {
    return mesh.kind == CellKind::tet ? 4 * cell : mesh.corner_begin[cell];
}

Mesh reordered(const Mesh& mesh, const Reorder& order, const PositionPlan& plan) {
    Mesh out;
    out.kind = mesh.kind;
    out.positions = decoded_positions(mesh, order, plan);
    const std::vector<Index> new_point = inverse_of(order.old_point, mesh.point_count());
    const std::vector<Index> new_cell = inverse_of(order.old_cell, mesh.cell_count());
    std::vector<Index> old_corner_of;  // new corner -> old corner
    old_corner_of.reserve(mesh.corners.size());
    out.corners.reserve(mesh.corners.size());
    out.corner_begin.reserve(mesh.corner_begin.size());
    if (mesh.kind == CellKind::polygon) out.corner_begin.assign(1, 0);
    for (std::size_t c = 0; c < order.old_cell.size(); ++c) {
        const Index cell = order.old_cell[c];
        const auto degree = static_cast<std::uint32_t>(mesh.cell(cell).size());
        for (std::uint32_t i = 0; i < degree; ++i)
            old_corner_of.push_back(first_corner(mesh, cell) +
                                    old_corner(mesh.kind, order.turn[c], degree, i));
        if (mesh.kind == CellKind::polygon) out.corner_begin.push_back(old_corner_of.size());
    }
    for (const Index corner : old_corner_of) out.corners.push_back(new_point[mesh.corners[corner]]);
    out.companions = mesh.companions;
    for (CompanionBlock& block : out.companions) {
        if (mesh.kind == CellKind::tet)
            turn_edge_nodes(block, false, [&](Index host) { return order.turn[new_cell[host]]; });
        for (Index& node : block.nodes) node = new_point[node];
        for (Index& host : block.hosts) host = new_cell[host];
    }
    for (const Attribute& given : mesh.attributes) {
        Attribute moved = given;
        const std::vector<Index>* from = given.place == Place::point    ? &order.old_point
                                         : given.place == Place::cell   ? &order.old_cell
                                         : given.place == Place::corner ? &old_corner_of
                                                                        : nullptr;
        if (from != nullptr && !from->empty()) {
            if (given.index.empty())
                moved.values = gather(given.values, *from);
            else
                for (std::size_t i = 0; i < moved.index.size(); ++i)
                    moved.index[i] = given.index[(*from)[i]];
        }
        renumber(moved, new_point, new_cell);
        out.attributes.push_back(std::move(moved));
    }
    return out;
}

}  // namespace

StripMesh strip_mesh_of(const Mesh& mesh, const Complex& complex, const WalkRecord& record,
                        const Reorder& order, const EdgePoints& edges, const PositionPlan& plan) {
    StripMesh strip;
    strip.mesh = reordered(mesh, order, plan);
    strip.point.reserve(record.copy_of.size());
    strip.stencils.reserve(record.copy_of.size() + edges.end.size());
    strip.flipped.reserve(record.cell_of.size());
    Id own = 0;
    for (std::size_t v = 0; v < record.copy_of.size(); ++v) {
        const Id of = record.copy_of[v];
        strip.point.push_back(of == kNone ? own++ : strip.point[of]);
        if (of == kNone) strip.stencils.push_back(record.stencils[v]);
    }
    for (Index i = 0; i < edges.end.size(); ++i)
        strip.stencils.push_back(stencil_of_unused(edges, i, record.copy_of.size()));
    for (const Id cell : record.cell_of) strip.flipped.push_back(complex.flipped[cell]);
    return strip;
}

}  // namespace ravel
