#include "encode/payload.h"

namespace ravel {
namespace {

// Differences to the number before, as zigzag varints.
class DeltaWriter {
  public:
    explicit DeltaWriter(ByteWriter& out) : out_(out) {}
    void put(Index i) {
        out_.varint(zigzag(static_cast<std::int64_t>(i - last_)));
        last_ = i;
    }

  private:
    ByteWriter& out_;
    Index last_ = 0;
};

}  // namespace

Bytes write_companions(const Mesh& mesh, const Reorder& order, const std::vector<Index>& new_point,
                       const std::vector<Index>& new_cell) {
    ByteWriter out;
    out.varint(mesh.companions.size());
    for (const CompanionBlock& given : mesh.companions) {
        CompanionBlock turned;
        if (mesh.kind == CellKind::tet && !given.hosts.empty()) {
            turned = given;
            turn_edge_nodes(turned, false, [&](Index host) { return order.turn[new_cell[host]]; });
        }
        const CompanionBlock& block = turned.hosts.empty() ? given : turned;
        out.varint(block.vtk_type);
        out.varint(block.nodes_per_cell);
        out.varint(block.cell_count);
        out.u8(block.hosts.empty() ? 0 : 1);
        // Nodes column by column: the columns of one cell type resemble themselves most.
        for (std::size_t k = 0; k < block.nodes_per_cell && block.cell_count > 0; ++k) {
            DeltaWriter column(out);
            for (std::size_t i = k; i < block.nodes.size(); i += block.nodes_per_cell)
                column.put(new_point[block.nodes[i]]);
        }
        DeltaWriter hosts(out);
        for (const Index host : block.hosts) hosts.put(new_cell[host]);
    }
    return out.take();
}

Bytes write_names(const Mesh& mesh) {
    ByteWriter out;
    out.varint(mesh.tag_names.size());
    for (const TagName& name : mesh.tag_names) {
        out.text(name.attribute);
        out.varint(zigzag(name.dimension));
        out.varint(zigzag(name.value));
        out.text(name.name);
    }
    out.varint(mesh.notes.size());
    for (const Note& note : mesh.notes) {
        out.text(note.key);
        out.text(note.text);
    }
    return out.take();
}

Bytes write_order(const Reorder& order) {
    ByteWriter out;
    DeltaWriter points(out);
    for (const Index p : order.old_point) points.put(p);
    DeltaWriter cells(out);
    for (const Index c : order.old_cell) cells.put(c);
    for (const std::uint32_t turn : order.turn) out.varint(turn);
    return out.take();
}

}  // namespace ravel
