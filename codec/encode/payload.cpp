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

Bytes write_order(const Reorder& order, const std::vector<CompanionBlock>& companions) {
    ByteWriter out;
    DeltaWriter points(out);
    for (const Index p : order.old_point) points.put(p);
    DeltaWriter cells(out);
    for (const Index c : order.old_cell) cells.put(c);
    for (const std::uint32_t turn : order.turn) out.varint(turn);
    std::size_t before = 0;
    for (const CompanionBlock& block : companions) {
        DeltaWriter old(out);
        for (std::size_t i = before; i < before + block.cell_count; ++i)
            old.put(order.old_companion[i] - before);
        for (std::size_t i = before; i < before + block.cell_count; ++i)
            out.varint(order.companion_turn[i]);
        before += block.cell_count;
    }
    return out.take();
}

}  // namespace ravel
