#include "encode/payload.h"

#include "predict/array_planes.h"

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

Index first_corner(const Mesh& mesh, Index cell) {
    return mesh.kind == CellKind::tet ? 4 * cell : mesh.corner_begin[cell];
}

// new element -> old element, for the places that move; empty for the others.
std::vector<Index> old_elements(const Mesh& mesh, const Reorder& order, Place place) {
    if (place == Place::point) return order.old_point;
    if (place == Place::cell) return order.old_cell;
    std::vector<Index> old;
    if (place != Place::corner) return old;
    old.reserve(mesh.corners.size());
    for (std::size_t c = 0; c < order.old_cell.size(); ++c) {
        const Index cell = order.old_cell[c];
        const auto degree = static_cast<std::uint32_t>(mesh.cell(cell).size());
        for (std::uint32_t i = 0; i < degree; ++i)
            old.push_back(first_corner(mesh, cell) +
                          old_corner(mesh.kind, order.turn[c], degree, i));
    }
    return old;
}

}  // namespace

bool is_pool(const Mesh& mesh, const Attribute& attribute) {
    return !attribute.index.empty() ||
           (attribute.place != Place::mesh && element_count(mesh, attribute.place) == 0);
}

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

Bytes write_attributes(const Mesh& mesh, const Reorder& order, const std::vector<Index>& new_point,
                       const std::vector<Index>& new_cell) {
    ByteWriter out;
    Attribute renumbered;
    for (const Attribute& given : mesh.attributes) {
        if (!given.references.empty()) {
            renumbered = given;
            renumber(renumbered, new_point, new_cell);
        }
        const Attribute& attribute = given.references.empty() ? given : renumbered;
        const std::vector<Index> old = old_elements(mesh, order, attribute.place);
        const bool moves = attribute.place == Place::point || attribute.place == Place::cell ||
                           attribute.place == Place::corner;
        if (!is_pool(mesh, attribute)) {
            out.raw(planes_of(moves ? gather(attribute.values, old) : attribute.values));
        } else {
            DeltaWriter index(out);
            for (std::size_t i = 0; i < attribute.index.size(); ++i)
                index.put(attribute.index[moves ? old[i] : i]);
            out.raw(planes_of(attribute.values));
        }
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
