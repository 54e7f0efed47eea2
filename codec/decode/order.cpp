#include "decode/order.h"

#include "decode/walk_driver.h"
#include "predict/cell_graph.h"
#include "predict/order_codes.h"
#include "predict/points_around.h"

namespace ravel {
namespace {

// Cells of a block at their old places, starting with their old first nodes. `before`: companions
// of the blocks before.
void place_companions(const Reorder& order, Index before, CompanionBlock& block) {
    const std::vector<Index> nodes = block.nodes, hosts = block.hosts;
    const Index n = block.nodes_per_cell;
    for (Index i = 0; i < block.cell_count; ++i) {
        const Index old = order.old_companion[before + i] - before;
        for (Index k = 0; k < n; ++k)
            block.nodes[old * n + (k + order.companion_turn[before + i]) % n] = nodes[i * n + k];
        if (!hosts.empty()) block.hosts[old] = hosts[i];
    }
}

}  // namespace

Result<Reorder> read_order(ByteReader& in, const Ground<Walked>& ground,
                           const std::vector<Index>& turned, std::uint64_t& budget) {
    const auto corrupt = [&](const char* why) { return Error{Code::corrupt, in.at(), why}; };
    const std::vector<CompanionBlock>& blocks = ground.mesh.companions;
    const unsigned kind = in.u8();
    OrderCoding coding;
    coding.cells_first = (kind & 1) != 0;
    coding.turns_by_points = (kind & 2) != 0;
    coding.guesses_points = (kind & 4) != 0;
    coding.guesses_cells = (kind & 8) != 0;
    coding.cells = static_cast<ToldBy>(kind >> 4 & 3);
    coding.edges = static_cast<EdgesBy>(kind >> 6);
    const bool has_edges =
        !ground.stencils.empty() && ground.stencils.back().configuration == Configuration::edge;
    if ((kind >= 64 && !has_edges) ||
        (coding.cells_first && (coding.turns_by_points || coding.guesses_points)) ||
        (coding.cells != ToldBy::walk && (coding.cells_first || coding.guesses_cells)))
        return corrupt("an order that is told in a way this version does not know");
    std::vector<ToldBy> by;
    std::uint64_t need = 0;
    for (const CompanionBlock& block : blocks) {
        const std::uint8_t told = in.u8();
        if (told > static_cast<std::uint8_t>(block.hosts.empty() ? ToldBy::first : ToldBy::hosts))
            return corrupt("an order that is told in a way this version does not know");
        by.push_back(static_cast<ToldBy>(told));
        if (block.cell_count >= kMostNumbers || block.nodes.size() >= kMostNumbers)
            return corrupt("an order of more companions than have one");
        need += 88 * block.cell_count + (has_edges ? 16 : 8) * block.nodes.size();
    }
    // A pool is told if elements have an index into it.
    for (const Attribute& a : ground.mesh.attributes)
        need += a.index.empty() ? 0 : 64 * a.values.count();
    if (!blocks.empty()) need += 8 * ground.mesh.point_count();
    if (has_edges) need += 48 * ground.mesh.point_count();
    if (need > budget)
        return Error{Code::limit_exceeded, in.at(), "the order needs more memory than allowed"};
    budget -= need;
    FlagDecoder bits(in.raw(in.left()));
    ReadingCoder coder{bits, with_size_kinds(models_of(kResidualPriors, AttributeContexts::count,
                                                       kResidualPriorSeen))};
    Reorder order;
    order.old_companion.resize(ground.mesh.companion_count());
    order.companion_turn.resize(order.old_companion.size(), 0);
    const PointsAround<Walked> points(ground);
    const CellsAround<Walked> cells(ground);
    OrderCodes<ReadingCoder, Walked> codes(coder, ground, coding, points, cells, order);
    bool sane = codes.run();
    Index before = 0;
    for (std::size_t b = 0; b < blocks.size() && sane; ++b) {
        sane = codes.companions(blocks[b], turned[b], before, by[b]);
        before += blocks[b].cell_count;
    }
    order.old_tuple.resize(ground.mesh.attributes.size());
    for (std::size_t i = 0; i < order.old_tuple.size() && sane; ++i) {
        const Attribute& a = ground.mesh.attributes[i];
        if (a.index.empty()) continue;
        order.old_tuple[i].resize(a.values.count());
        sane = codes.tuples(order.old_tuple[i]);
    }
    if (!sane || !bits.finished() || !in.ok()) return corrupt("the order makes no sense");
    return order;
}

void restore_order(Mesh& mesh, const Reorder& order) {
    const Index cells = mesh.cell_count();
    const std::vector<Index> new_point = inverse_of(order.old_point, mesh.point_count());
    const std::vector<Index> new_cell = inverse_of(order.old_cell, cells);
    mesh.positions = gather(mesh.positions, new_point);
    std::vector<Index> new_corner(mesh.corners.size());  // old corner -> new corner
    std::vector<Index> corners(mesh.corners.size()), corner_begin;
    if (mesh.kind == CellKind::polygon) corner_begin.assign(1, 0);
    Index begin = 0;
    for (Index c = 0; c < cells; ++c) {
        const auto cell = mesh.cell(new_cell[c]);
        const auto from = static_cast<Index>(cell.data() - mesh.corners.data());
        const auto degree = static_cast<std::uint32_t>(cell.size());
        for (std::uint32_t i = 0; i < degree; ++i) {
            const Index at = begin + old_corner(mesh.kind, order.turn[new_cell[c]], degree, i);
            corners[at] = order.old_point[cell[i]];
            new_corner[at] = from + i;
        }
        begin += degree;
        if (mesh.kind == CellKind::polygon) corner_begin.push_back(begin);
    }
    mesh.corners = std::move(corners);
    mesh.corner_begin = std::move(corner_begin);
    Index before = 0;
    for (CompanionBlock& block : mesh.companions) {
        if (mesh.kind == CellKind::tet)
            turn_edge_nodes(block, true, [&](Index host) { return order.turn[host]; });
        place_companions(order, before, block);
        before += block.cell_count;
        for (Index& node : block.nodes) node = order.old_point[node];
        for (Index& host : block.hosts) host = order.old_cell[host];
    }
    const std::vector<Index> new_companion =
        inverse_of(order.old_companion, order.old_companion.size());
    for (std::size_t a = 0; a < mesh.attributes.size(); ++a) {
        Attribute& attribute = mesh.attributes[a];
        const std::vector<Index>* from = attribute.place == Place::point       ? &new_point
                                         : attribute.place == Place::cell      ? &new_cell
                                         : attribute.place == Place::corner    ? &new_corner
                                         : attribute.place == Place::companion ? &new_companion
                                                                               : nullptr;
        if (from != nullptr && !from->empty()) {
            if (attribute.index.empty()) {
                attribute.values = gather(attribute.values, *from);
            } else {
                const std::vector<Index> index = std::move(attribute.index);
                attribute.index.resize(index.size());
                for (std::size_t i = 0; i < index.size(); ++i)
                    attribute.index[i] = index[(*from)[i]];
            }
        }
        if (!attribute.index.empty()) {
            const std::vector<Index>& old_tuple = order.old_tuple[a];
            attribute.values = gather(attribute.values, inverse_of(old_tuple, old_tuple.size()));
            for (Index& i : attribute.index)
                if (i != kNoIndex) i = old_tuple[i];
        }
        renumber(attribute, order.old_point, order.old_cell);
    }
}

}  // namespace ravel
