#include "encode/order.h"

namespace ravel {

Reorder reorder_of(const Mesh& mesh, const Complex& complex, const WalkRecord& record) {
    Reorder order;
    order.old_point.reserve(mesh.point_count());
    std::vector<bool> used(mesh.point_count(), false);
    for (std::size_t v = 0; v < record.vertex_of.size(); ++v)
        if (record.copy_of[v] == kNone) {
            const Id p = complex.point[record.vertex_of[v]];
            order.old_point.push_back(p);
            used[p] = true;
        }
    for (Index p = 0; p < mesh.point_count(); ++p)
        if (!used[p]) order.old_point.push_back(p);

    std::size_t corner = 0;  // of the walk
    for (const Id cell : record.cell_of) {
        const Id degree = complex.degree(cell), first = complex.first[cell];
        const bool flipped = complex.flipped[cell] != 0;
        std::uint32_t turn = 0;
        if (complex.kind == CellKind::tet) {
            std::array<std::uint8_t, 4> p{};
            for (std::size_t i = 0; i < 4; ++i) {
                auto local = static_cast<std::uint8_t>(record.facet_of[corner + i] - first);
                if (flipped && local >= 2) local = static_cast<std::uint8_t>(5 - local);
                p[i] = local;
            }
            if (flipped) std::swap(p[2], p[3]);
            turn = number_of_tet_turn(p);
        } else if (degree > 0) {
            const Id local = record.facet_of[corner] - first;
            turn = flipped && local > 0 ? degree - local : local;
        }
        corner += degree;
        order.old_cell.push_back(cell);
        order.turn.push_back(turn);
    }
    return order;
}

OrderMaps maps_of(const Reorder& order, const Mesh& mesh, bool order_is_kept) {
    OrderMaps maps;
    const std::size_t points = order.old_point.size(), cells = order.old_cell.size();
    if (order_is_kept) {
        maps.point.resize(points);
        maps.cell.resize(cells);
        for (std::size_t i = 0; i < points; ++i) maps.point[i] = i;
        for (std::size_t i = 0; i < cells; ++i) maps.cell[i] = i;
        maps.turn.assign(cells, 0);
        return maps;
    }
    maps.point = inverse_of(order.old_point, mesh.point_count());
    maps.cell = inverse_of(order.old_cell, mesh.cell_count());
    maps.turn.resize(cells);
    for (std::size_t i = 0; i < cells; ++i) maps.turn[order.old_cell[i]] = order.turn[i];
    return maps;
}

}  // namespace ravel
