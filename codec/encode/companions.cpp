#include "encode/companions.h"

#include <algorithm>
#include <map>

#include "encode/bits_writer.h"
#include "encode/edge_points.h"
#include "predict/marks.h"

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

bool may_be_marks(const CompanionBlock& block, CellKind kind) {
    const std::uint32_t most = kind == CellKind::tet ? 3 : 2;
    return block.hosts.empty() && block.nodes_per_cell >= 1 && block.nodes_per_cell <= most &&
           block.vtk_type == kMarkTypes[block.nodes_per_cell];
}

// The companions that may be marks, found by their nodes; the first of equals is taken first.
class Takers final : public MarkTruth {
  public:
    explicit Takers(const Mesh& mesh) : mesh_(mesh) {
        for (Id b = 0; b < mesh.companions.size(); ++b) {
            const CompanionBlock& block = mesh.companions[b];
            if (!may_be_marks(block, mesh.kind)) continue;
            for (Index i = 0; i < block.cell_count; ++i)
                left_.push_back({key_of(nodes_of(block, i), block.nodes_per_cell), b, i});
        }
        std::stable_sort(left_.begin(), left_.end(),
                         [](const Entry& x, const Entry& y) { return x.key < y.key; });
        taken_.assign(left_.size(), 0);
    }

    bool take(const std::array<Id, 3>& nodes, std::uint32_t count, Mark& mark) override {
        const Key key = key_of(nodes, count);
        const auto first = std::lower_bound(left_.begin(), left_.end(), key,
                                            [](const Entry& e, const Key& k) { return e.key < k; });
        if (first == left_.end()) return false;
        Index& taken = taken_[static_cast<std::size_t>(first - left_.begin())];
        const auto at = first + static_cast<std::ptrdiff_t>(taken);
        if (at == left_.end() || at->key != key) return false;
        const auto given = nodes_of(mesh_.companions[at->block], at->cell);
        for (const bool reversed : {false, true})
            for (std::uint32_t turn = 0; turn < (count == 3 ? 3 : 1); ++turn) {
                auto turned = nodes;
                if (reversed) std::swap(turned[0], turned[1]);
                bool same = true;
                for (std::uint32_t k = 0; k < count; ++k)
                    same = same && given[(turn + k) % count] == turned[k];
                if (!same) continue;
                ++taken;
                mark.block = at->block;
                mark.reversed = reversed;
                found_.push_back({at->block, at->cell, turn});
                return true;
            }
        return false;
    }

    void start_again() {
        taken_.assign(taken_.size(), 0);
        found_.clear();
    }

    struct Found {
        Id block;
        Index cell;
        std::uint32_t turn;
    };
    const std::vector<Found>& found() const { return found_; }

  private:
    using Key = std::array<Id, 4>;
    struct Entry {
        Key key;
        Id block;
        Index cell;
    };

    static std::array<Id, 3> nodes_of(const CompanionBlock& block, Index cell) {
        std::array<Id, 3> nodes{};
        for (std::size_t k = 0; k < block.nodes_per_cell; ++k)
            nodes[k] = static_cast<Id>(block.nodes[cell * block.nodes_per_cell + k]);
        return nodes;
    }
    static Key key_of(std::array<Id, 3> nodes, std::uint32_t count) {
        for (std::size_t k = count; k < 3; ++k) nodes[k] = kNone;
        std::sort(nodes.begin(), nodes.end());
        return {count, nodes[0], nodes[1], nodes[2]};
    }

    const Mesh& mesh_;
    std::vector<Entry> left_;
    std::vector<Index> taken_;  // of the entries that are equal, at the first
    std::vector<Found> found_;
};

// Brings the companions, and the values they have, into the order in which they come back.
void reorder(Mesh& mesh, const std::vector<Takers::Found>& found, const std::vector<bool>& on_edges,
             Reorder& order) {
    std::vector<std::vector<Index>> first(mesh.companions.size());
    std::vector<std::vector<std::uint32_t>> turns(mesh.companions.size());
    for (const Takers::Found& f : found) {
        first[f.block].push_back(f.cell);
        turns[f.block].push_back(f.turn);
    }
    order.old_companion.clear();
    order.companion_turn.clear();
    Index before = 0;
    for (std::size_t b = 0; b < mesh.companions.size(); ++b) {
        CompanionBlock& block = mesh.companions[b];
        std::vector<bool> is_placed(block.cell_count, false);
        if (on_edges[b]) first[b] = inverse_of(block.hosts, block.cell_count);
        for (const Index i : first[b]) is_placed[i] = true;
        for (Index i = 0; i < block.cell_count; ++i)
            if (!is_placed[i]) first[b].push_back(i);
        turns[b].resize(block.cell_count, 0);
        CompanionBlock given = block;
        for (Index i = 0; i < block.cell_count; ++i) {
            const std::uint64_t n = block.nodes_per_cell;
            for (std::uint64_t k = 0; k < n; ++k)
                block.nodes[i * n + k] = given.nodes[first[b][i] * n + (turns[b][i] + k) % n];
            if (!block.hosts.empty()) block.hosts[i] = given.hosts[first[b][i]];
            order.old_companion.push_back(before + first[b][i]);
            order.companion_turn.push_back(turns[b][i]);
        }
        before += block.cell_count;
    }
    for (Attribute& attribute : mesh.attributes) {
        if (attribute.place != Place::companion || order.old_companion.empty()) continue;
        const std::vector<Index> index = attribute.index;
        if (index.empty())
            attribute.values = gather(attribute.values, order.old_companion);
        else
            for (std::size_t i = 0; i < index.size(); ++i)
                attribute.index[i] = index[order.old_companion[i]];
    }
}

}  // namespace

CompanionCodes write_companions(StripMesh& strip, const Walked& walked, const EdgePoints& edges,
                                Reorder& order) {
    Mesh& mesh = strip.mesh;
    CompanionCodes out;
    Takers takers(mesh);
    std::vector<MarkBlock> marks(mesh.companions.size());
    const auto code = [&](FlagEncoder& bits, MarkTruth& truth) {
        BitsWriter coder{bits};
        const Ground<Walked> ground = strip.ground(walked);
        MarkCodes<BitsWriter, Walked> codes(coder, ground, marks, &truth);
        codes.run();
        out.marked.clear();
        for (const Mark& mark : codes.marks())
            if (mark.facet != kNone) out.marked.push_back(mark.facet);
    };
    // How many there are is known once all candidates were asked for; mostly it is all.
    FlagEncoder bits;
    Index wanted = 0;
    for (std::size_t b = 0; b < marks.size(); ++b) {
        const CompanionBlock& block = mesh.companions[b];
        if (!may_be_marks(block, mesh.kind)) continue;
        marks[b] = {block.nodes_per_cell, block.cell_count};
        wanted += block.cell_count;
    }
    code(bits, takers);
    if (takers.found().size() < wanted) {
        for (MarkBlock& block : marks) block.marks = 0;
        for (const Takers::Found& f : takers.found()) ++marks[f.block].marks;
        bits = {};
        takers.start_again();
        code(bits, takers);
    }
    std::vector<bool> on_edges;
    for (const CompanionBlock& block : mesh.companions)
        on_edges.push_back(follows_from(edges, block));
    reorder(mesh, takers.found(), on_edges, order);
    for (const MarkBlock& block : marks) out.turned.push_back(block.marks);

    ByteWriter section;
    section.varint(mesh.companions.size());
    for (std::size_t b = 0; b < marks.size(); ++b) {
        const CompanionBlock& block = mesh.companions[b];
        section.varint(block.vtk_type);
        section.varint(block.nodes_per_cell);
        section.varint(block.cell_count);
        section.u8(on_edges[b] ? 3 : !block.hosts.empty() ? 1 : marks[b].marks > 0 ? 2 : 0);
        if (marks[b].marks > 0) section.varint(marks[b].marks);
    }
    for (std::size_t b = 0; b < marks.size(); ++b) {
        const CompanionBlock& block = mesh.companions[b];
        if (on_edges[b]) continue;
        // Nodes column by column: the columns of one cell type resemble themselves most.
        for (std::size_t k = 0; k < block.nodes_per_cell; ++k) {
            DeltaWriter column(section);
            for (std::size_t i = marks[b].marks * block.nodes_per_cell + k; i < block.nodes.size();
                 i += block.nodes_per_cell)
                column.put(block.nodes[i]);
        }
        DeltaWriter hosts(section);
        for (const Index host : block.hosts) hosts.put(host);
    }
    section.raw(bits.finish());
    out.section = section.take();
    return out;
}

void map_companions(const Reorder& order, bool order_is_kept, OrderMaps& maps) {
    const std::size_t count = order.old_companion.size();
    maps.companion.resize(count);
    maps.companion_turn.assign(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const Index old = order_is_kept ? i : order.old_companion[i];
        maps.companion[old] = i;
        if (!order_is_kept) maps.companion_turn[old] = order.companion_turn[i];
    }
}

}  // namespace ravel
