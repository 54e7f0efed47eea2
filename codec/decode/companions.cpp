#include "decode/companions.h"

#include "decode/walk_driver.h"
#include "predict/attribute_contexts.h"
#include "predict/marks.h"

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

class Reader {
  public:
    Reader(ByteReader& in, const Head& head, const BlockHead& block, const EdgePoints& edges,
           const Ground<Walked>& ground, std::uint64_t& budget, Mesh& mesh)
        : in_(in),
          head_(head),
          block_(block),
          edges_(edges),
          ground_(ground),
          budget_(budget),
          mesh_(mesh) {}

    Status run(std::vector<Id>& marked) {
        const std::uint64_t count = in_.varint();
        // A block takes four bytes at least.
        if (count != block_.companions || count > in_.left() / 4)
            return corrupt("the companions are not as many as announced");
        mesh_.companions.resize(count);
        marks_.resize(count);
        kind_.resize(count);
        for (std::size_t b = 0; b < count; ++b)
            if (Status status = read_head_of(b); !status) return status;
        for (std::size_t b = 0; b < count; ++b)
            if (Status status = read_rest_of(b); !status) return status;
        if (Status status = read_marks(marked); !status) return status;
        if (!in_.ok() || in_.left() != 0)
            return corrupt("the companions end too early or too late");
        return Done{};
    }

    const std::vector<MarkBlock>& marks() const { return marks_; }

  private:
    Status corrupt(const char* why) const { return Error{Code::corrupt, in_.at(), why}; }

    Status read_head_of(std::size_t b) {
        CompanionBlock& block = mesh_.companions[b];
        const std::uint64_t type = in_.varint(), nodes = in_.varint();
        block.cell_count = in_.varint();
        const std::uint8_t kind = kind_[b] = in_.u8();
        if (!in_.ok() || type > 0xFFFF || nodes > 0xFFFFFFFFu || kind > kOnEdges)
            return corrupt("a companion block of a kind this version does not know");
        block.vtk_type = static_cast<std::uint16_t>(type);
        block.nodes_per_cell = static_cast<std::uint32_t>(nodes);
        if (kind == kMarks) {
            marks_[b] = {block.nodes_per_cell, in_.varint()};
            if (!in_.ok() || nodes == 0 || nodes > 3 || marks_[b].marks > block.cell_count)
                return corrupt("a companion block with marks it can't have");
        }
        if (kind == kOnEdges && (!block_.has_edge_points || type != 24 || nodes != 6 ||
                                 block.cell_count != block_.cells))
            return corrupt("a companion block on the edges of tets that have no points for it");
        // The sum over all blocks: numbers of companions are then sums that don't wrap.
        if (block.cell_count > kNoIndex / 4 - companions_)
            return corrupt("more companions than can be counted");
        companions_ += block.cell_count;
        return Done{};
    }

    // The nodes and hosts of those that are no marks; places for the others are left in front.
    Status read_rest_of(std::size_t b) {
        CompanionBlock& block = mesh_.companions[b];
        if (kind_[b] == kOnEdges) return fill_from_edges(block);
        const Index points = mesh_.point_count(), cells = mesh_.cell_count();
        const Index marks = marks_[b].marks, rest = block.cell_count - marks;
        const std::uint64_t nodes = block.nodes_per_cell;
        // Every node and host takes a byte at least.
        if ((nodes > 0 && rest > in_.left() / nodes) || (kind_[b] == kHosted && rest > in_.left()))
            return corrupt("a companion block with more cells than there are bytes");
        // A mark is its nodes twice or thrice, and what tells of it.
        const std::uint64_t each = sizeof(Mark) * 2 + 8 * nodes * (head_.keeps_order ? 3 : 2);
        if (marks > budget_ / each)
            return Error{Code::limit_exceeded, in_.at(),
                         "the companions need more memory than allowed"};
        budget_ -= marks * each;
        // No more than the mesh has facets, edges of facets and points.
        if (marks > 3 * ground_.walk.vertex.size() + points)
            return corrupt("a companion block with more marks than the mesh has parts");
        block.nodes.resize(block.cell_count * nodes);
        for (std::size_t k = 0; k < nodes && rest > 0; ++k) {
            DeltaReader column(in_);
            for (std::size_t i = marks * nodes + k; i < block.nodes.size(); i += nodes) {
                block.nodes[i] = column.next();
                if (block.nodes[i] >= points)
                    return corrupt("a companion names a point that does not exist");
            }
        }
        if (kind_[b] != kHosted) return Done{};
        block.hosts.resize(block.cell_count);
        DeltaReader column(in_);
        for (Index& host : block.hosts)
            if ((host = column.next()) >= cells)
                return corrupt("a companion names a cell that does not exist");
        return Done{};
    }

    // The edges are numbered in the order of the mesh's corners, as the nodes are.
    Status fill_from_edges(CompanionBlock& block) {
        const std::uint64_t each = 8 * 7 * (head_.keeps_order ? 3 : 2);
        if (block.cell_count > budget_ / each)
            return Error{Code::limit_exceeded, in_.at(),
                         "the companions need more memory than allowed"};
        budget_ -= block.cell_count * each;
        block.nodes.resize(edges_.of.size());
        for (std::size_t i = 0; i < edges_.of.size(); ++i)
            block.nodes[i] = edges_.first + edges_.of[i];
        block.hosts.resize(block.cell_count);
        for (Index i = 0; i < block.cell_count; ++i) block.hosts[i] = i;
        return Done{};
    }

    Status read_marks(std::vector<Id>& marked) {
        Index all = 0;
        for (const MarkBlock& block : marks_) all += block.marks;
        if (all == 0) return Done{};
        FlagDecoder bits(in_.raw(in_.left()));
        ReadingCoder coder{
            bits, with_size_kinds(
                      models_of(kResidualPriors, AttributeContexts::count, kResidualPriorSeen))};
        MarkCodes<ReadingCoder, Walked> codes(coder, ground_, marks_, nullptr);
        if (!codes.run() || !bits.finished())
            return corrupt("the marks of the companions make no sense");
        std::vector<Index> next(marks_.size(), 0);
        for (const Mark& mark : codes.marks()) {
            CompanionBlock& block = mesh_.companions[mark.block];
            if (next[mark.block] == marks_[mark.block].marks)
                return corrupt("a companion block with more marks than announced");
            for (std::size_t k = 0; k < block.nodes_per_cell; ++k)
                block.nodes[next[mark.block] * block.nodes_per_cell + k] = mark.nodes[k];
            ++next[mark.block];
            if (mark.facet != kNone) marked.push_back(mark.facet);
        }
        return Done{};
    }

    // What a block is: its nodes; with hosts; first marks; nodes and hosts by the edges of the
    // tets.
    static constexpr std::uint8_t kHosted = 1, kMarks = 2, kOnEdges = 3;

    ByteReader& in_;
    const Head& head_;
    const BlockHead& block_;
    const EdgePoints& edges_;
    const Ground<Walked>& ground_;
    std::uint64_t& budget_;
    Mesh& mesh_;
    std::vector<MarkBlock> marks_;
    std::vector<std::uint8_t> kind_;
    Index companions_ = 0;
};

}  // namespace

Status read_companions(ByteReader& in, const Head& head, const BlockHead& block,
                       const Ground<Walked>& ground, std::uint64_t& budget, Mesh& mesh,
                       const EdgePoints& edges, std::vector<Id>& marked,
                       std::vector<Index>& turned) {
    Reader reader(in, head, block, edges, ground, budget, mesh);
    Status status = reader.run(marked);
    for (const MarkBlock& b : reader.marks()) turned.push_back(b.marks);
    return status;
}

}  // namespace ravel
