#include "decode/payload.h"

#include <algorithm>
namespace ravel {
namespace {

class DeltaReader {
  public:
    explicit DeltaReader(ByteReader& in) : in_(in) {}
    Index next() { return last_ += static_cast<Index>(unzigzag(in_.varint())); }

  private:
    ByteReader& in_;
    Index last_ = 0;
};

Error corrupt(const ByteReader& in, const char* why) {
    return {Code::corrupt, in.at(), why};
}

Status check_end(const ByteReader& in) {
    if (!in.ok()) return corrupt(in, "a section ends before its data do");
    if (in.left() != 0) return corrupt(in, "a section is longer than its data");
    return Done{};
}

}  // namespace

Status read_names(ByteReader& in, Mesh& mesh) {
    const std::uint64_t names = in.varint();
    if (names > in.left() / 4) return corrupt(in, "more names than there are bytes");
    mesh.tag_names.reserve(names);
    for (std::uint64_t i = 0; i < names && in.ok(); ++i) {
        TagName name;
        name.attribute = in.text();
        const std::int64_t dimension = unzigzag(in.varint());
        if (dimension < -1 || dimension > 3)
            return corrupt(in, "a name of a dimension that does not exist");
        name.dimension = static_cast<std::int32_t>(dimension);
        name.value = unzigzag(in.varint());
        name.name = in.text();
        mesh.tag_names.push_back(std::move(name));
    }
    const std::uint64_t notes = in.varint();
    if (notes > in.left() / 2) return corrupt(in, "more notes than there are bytes");
    mesh.notes.reserve(notes);
    for (std::uint64_t i = 0; i < notes && in.ok(); ++i) {
        Note note;
        note.key = in.text();
        note.text = in.text();
        mesh.notes.push_back(std::move(note));
    }
    return check_end(in);
}

Result<Reorder> read_order(ByteReader& in, const Mesh& mesh) {
    Reorder order;
    const Index points = mesh.point_count(), cells = mesh.cell_count(),
                companions = mesh.companion_count();
    if (points > in.left() || cells > in.left() || companions > in.left())
        return corrupt(in, "the order has fewer bytes than elements");
    bool sane = true;
    const auto read = [&](std::vector<Index>& list, Index count) {
        std::vector<bool> taken(count, false);
        const std::size_t before = list.size();
        list.resize(before + count);
        DeltaReader delta(in);
        for (Index i = 0; i < count && sane; ++i) {
            const Index old = delta.next();
            sane = old < count && !taken[old];
            if (!sane) return;
            taken[old] = true;
            list[before + i] = before + old;
        }
    };
    read(order.old_point, points);
    read(order.old_cell, cells);
    if (!sane) return corrupt(in, "the order is no permutation");
    order.turn.resize(cells);
    for (Index c = 0; c < cells; ++c) {
        const std::uint64_t turn = in.varint();
        const std::uint64_t most =
            mesh.kind == CellKind::tet ? 24 : std::max<std::uint64_t>(1, mesh.cell(c).size());
        if (turn >= most) return corrupt(in, "a cell starts with a corner that it has not");
        order.turn[c] = static_cast<std::uint32_t>(turn);
    }
    for (const CompanionBlock& block : mesh.companions) {
        read(order.old_companion, block.cell_count);
        for (Index i = 0; i < block.cell_count && sane; ++i) {
            const std::uint64_t turn = in.varint();
            sane = turn == 0 || turn < block.nodes_per_cell;
            order.companion_turn.push_back(static_cast<std::uint32_t>(turn));
        }
    }
    if (!sane) return corrupt(in, "the order of the companions makes no sense");
    if (Status status = check_end(in); !status) return status.error();
    return order;
}

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

Mesh restore_order(const Mesh& mesh, const Reorder& order) {
    Mesh out;
    out.kind = mesh.kind;
    const Index cells = mesh.cell_count();
    const std::vector<Index> new_point = inverse_of(order.old_point, mesh.point_count());
    const std::vector<Index> new_cell = inverse_of(order.old_cell, cells);
    out.positions = gather(mesh.positions, new_point);
    std::vector<Index> new_corner(mesh.corners.size());  // old corner -> new corner
    out.corners.resize(mesh.corners.size());
    if (mesh.kind == CellKind::polygon) out.corner_begin.assign(1, 0);
    Index begin = 0;
    for (Index c = 0; c < cells; ++c) {
        const auto cell = mesh.cell(new_cell[c]);
        const auto from = static_cast<Index>(cell.data() - mesh.corners.data());
        const auto degree = static_cast<std::uint32_t>(cell.size());
        for (std::uint32_t i = 0; i < degree; ++i) {
            const Index at = begin + old_corner(mesh.kind, order.turn[new_cell[c]], degree, i);
            out.corners[at] = order.old_point[cell[i]];
            new_corner[at] = from + i;
        }
        begin += degree;
        if (mesh.kind == CellKind::polygon) out.corner_begin.push_back(begin);
    }
    out.companions = mesh.companions;
    Index before = 0;
    for (CompanionBlock& block : out.companions) {
        if (mesh.kind == CellKind::tet)
            turn_edge_nodes(block, true, [&](Index host) { return order.turn[host]; });
        place_companions(order, before, block);
        before += block.cell_count;
        for (Index& node : block.nodes) node = order.old_point[node];
        for (Index& host : block.hosts) host = order.old_cell[host];
    }
    const std::vector<Index> new_companion =
        inverse_of(order.old_companion, order.old_companion.size());
    for (const Attribute& attribute : mesh.attributes) {
        Attribute moved = attribute;
        const std::vector<Index>* from = attribute.place == Place::point       ? &new_point
                                         : attribute.place == Place::cell      ? &new_cell
                                         : attribute.place == Place::corner    ? &new_corner
                                         : attribute.place == Place::companion ? &new_companion
                                                                               : nullptr;
        if (from != nullptr && !from->empty()) {
            if (attribute.index.empty())
                moved.values = gather(attribute.values, *from);
            else
                for (std::size_t i = 0; i < moved.index.size(); ++i)
                    moved.index[i] = attribute.index[(*from)[i]];
        }
        renumber(moved, order.old_point, order.old_cell);
        out.attributes.push_back(std::move(moved));
    }
    out.tag_names = mesh.tag_names;
    out.notes = mesh.notes;
    return out;
}

}  // namespace ravel
