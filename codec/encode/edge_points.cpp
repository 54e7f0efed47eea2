#include "encode/edge_points.h"

namespace ravel {
namespace {

bool has_every_host_once(const CompanionBlock& block, Index cells) {
    if (block.vtk_type != 24 || block.nodes_per_cell != 6 || block.hosts.size() != cells)
        return false;
    std::vector<bool> seen(cells, false);
    for (const Index host : block.hosts) {
        if (seen[host]) return false;
        seen[host] = true;
    }
    return true;
}

// The corners of all cells in the order of the strip.
std::vector<Index> corners_of(const Mesh& mesh, const Reorder& order,
                              const std::vector<Index>& new_point) {
    std::vector<Index> corners;
    corners.reserve(mesh.corners.size());
    for (std::size_t c = 0; c < order.old_cell.size(); ++c)
        for (const std::uint8_t i : tet_turn(order.turn[c]))
            corners.push_back(new_point[mesh.corners[4 * order.old_cell[c] + i]]);
    return corners;
}

// The node that each edge has; empty unless each has one, and one of its own that no cell has.
std::vector<Index> nodes_of_edges(CompanionBlock block, const EdgePoints& edges,
                                  const Reorder& order, const std::vector<Index>& new_point,
                                  const std::vector<Index>& new_cell, Index used) {
    turn_edge_nodes(block, false, [&](Index host) { return order.turn[new_cell[host]]; });
    std::vector<Index> node_of(edges.end.size(), kNoIndex);
    std::vector<bool> taken(new_point.size(), false);
    for (std::size_t i = 0; i < block.nodes.size(); ++i) {
        const Index node = block.nodes[i];
        Index& of_edge = node_of[edges.of[6 * new_cell[block.hosts[i / 6]] + i % 6]];
        if (of_edge == node) continue;
        if (of_edge != kNoIndex || taken[node] || new_point[node] < used) return {};
        of_edge = node;
        taken[node] = true;
    }
    return node_of;
}

}  // namespace

EdgePoints order_edge_points(const Mesh& mesh, const WalkRecord& record, Reorder& order) {
    if (mesh.kind != CellKind::tet || mesh.cell_count() == 0) return {};
    std::vector<Id> vertex;  // per point that a cell has
    for (Id v = 0; v < record.copy_of.size(); ++v)
        if (record.copy_of[v] == kNone) vertex.push_back(v);
    for (const CompanionBlock& block : mesh.companions) {
        if (!has_every_host_once(block, mesh.cell_count())) continue;
        const std::vector<Index> new_point = inverse_of(order.old_point, mesh.point_count()),
                                 new_cell = inverse_of(order.old_cell, mesh.cell_count());
        EdgePoints edges = edge_points_of(corners_of(mesh, order, new_point), vertex);
        std::vector<Index> unused =
            nodes_of_edges(block, edges, order, new_point, new_cell, vertex.size());
        if (unused.empty()) continue;
        std::vector<bool> on_edge(mesh.point_count(), false);
        for (const Index p : unused) on_edge[p] = true;
        for (std::size_t i = vertex.size(); i < order.old_point.size(); ++i)
            if (!on_edge[order.old_point[i]]) unused.push_back(order.old_point[i]);
        std::copy(unused.begin(), unused.end(),
                  order.old_point.begin() + static_cast<std::ptrdiff_t>(vertex.size()));
        return edges;
    }
    return {};
}

bool follows_from(const EdgePoints& edges, const CompanionBlock& block) {
    if (edges.of.empty() || !has_every_host_once(block, edges.of.size() / 6)) return false;
    for (std::size_t i = 0; i < block.nodes.size(); ++i)
        if (block.nodes[i] != edges.first + edges.of[6 * block.hosts[i / 6] + i % 6]) return false;
    return true;
}

}  // namespace ravel
