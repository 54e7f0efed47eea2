#include "encode/order_section.h"

#include "encode/bits_writer.h"
#include "predict/cell_graph.h"
#include "predict/order_codes.h"
#include "predict/points_around.h"

namespace ravel {
namespace {

class Writer {
  public:
    Writer(const Ground<Walked>& ground, const std::vector<Index>& turned, Reorder& order)
        : ground_(ground), turned_(turned), order_(order), points_(ground), cells_(ground) {}

    Bytes run() {
        OrderCoding coding = choose();
        choose_edges(coding);
        std::vector<ToldBy> by;
        for (std::size_t b = 0; b < blocks().size(); ++b) by.push_back(choose_block(b));
        ByteWriter out;
        out.u8(static_cast<std::uint8_t>(
            (coding.cells_first ? 1 : 0) | (coding.turns_by_points ? 2 : 0) |
            (coding.guesses_points ? 4 : 0) | (coding.guesses_cells ? 8 : 0) |
            static_cast<int>(coding.cells) << 4 | static_cast<int>(coding.edges) << 6));
        for (const ToldBy t : by) out.u8(static_cast<std::uint8_t>(t));
        FlagEncoder bits;
        BitsWriter coder{bits};
        Codes codes(coder, ground_, coding, points_, cells_, order_);
        codes.run();
        Index before = 0;
        for (std::size_t b = 0; b < by.size(); ++b) {
            codes.companions(blocks()[b], turned_[b], before, by[b]);
            before += blocks()[b].cell_count;
        }
        for (std::vector<Index>& old : order_.old_tuple) codes.tuples(old);
        out.raw(bits.finish());
        return out.take();
    }

  private:
    using Codes = OrderCodes<BitsWriter, Walked>;
    static constexpr std::array<ToldBy, 5> kAll{ToldBy::walk, ToldBy::lowest, ToldBy::highest,
                                                ToldBy::first, ToldBy::hosts};

    const std::vector<CompanionBlock>& blocks() const { return ground_.mesh.companions; }

    // What a part of the section takes alone, in bytes.
    template <class Part>
    std::size_t cost(const OrderCoding& coding, const Part& part) {
        FlagEncoder bits;
        BitsWriter coder{bits};
        Codes codes(coder, ground_, coding, points_, cells_, order_);
        part(codes);
        return bits.finish().size();
    }

    OrderCoding choose() {
        const auto points = [](Codes& codes) { codes.points(); };
        const auto turns = [](Codes& codes) { codes.turns(); };
        const auto cells = [](Codes& codes) { codes.cells(); };
        OrderCoding plain, guessed, used;
        guessed.guesses_points = guessed.guesses_cells = guessed.turns_by_points = true;
        used.cells_first = true;
        // Points, turns and cells, told each for itself; then by what came first.
        const std::size_t points_plain = cost(plain, points),
                          points_guessed = cost(guessed, points),
                          turns_by_gate = cost(plain, turns),
                          turns_by_points = cost(guessed, turns), cells_plain = cost(plain, cells),
                          cells_guessed = cost(guessed, cells);
        OrderCoding best;
        std::size_t least_cells = std::min(cells_plain, cells_guessed);
        const std::size_t least_walk = least_cells;
        best.guesses_cells = cells_guessed < cells_plain;
        const bool walk_guesses = best.guesses_cells;
        best.guesses_points = points_guessed < points_plain;
        best.turns_by_points = turns_by_points < turns_by_gate;
        for (const ToldBy by : kAll) {
            if (by == ToldBy::walk || by == ToldBy::hosts) continue;
            OrderCoding sorted;
            sorted.cells = by;
            const std::size_t bytes = cost(sorted, cells);
            if (bytes >= least_cells) continue;
            least_cells = bytes;
            best.cells = by;
            best.guesses_cells = false;
        }
        const std::size_t points_first = std::min(points_plain, points_guessed) +
                                         std::min(turns_by_gate, turns_by_points) + least_cells;
        if (turns_by_gate + least_walk + cost(used, points) < points_first) {
            best = used;
            best.guesses_cells = walk_guesses;
        }
        return best;
    }

    void choose_edges(OrderCoding& coding) {
        std::size_t least = 0;
        OrderCoding offered = coding;
        for (const EdgesBy by :
             {EdgesBy::walk, EdgesBy::ends, EdgesBy::cells, EdgesBy::gmsh_cells}) {
            offered.edges = by;
            bool has_edges = false;
            const std::size_t bytes = cost(offered, [&](Codes& codes) {
                has_edges = codes.has_edges();
                if (has_edges) codes.points() && codes.edge_points();
            });
            if (!has_edges) return;
            if (by == EdgesBy::walk || bytes < least) least = bytes, coding.edges = by;
        }
    }

    ToldBy choose_block(std::size_t b) {
        Index before = 0;
        for (std::size_t i = 0; i < b; ++i) before += blocks()[i].cell_count;
        ToldBy best = ToldBy::walk;
        std::size_t least = 0;
        for (const ToldBy by : kAll) {
            if (by == ToldBy::hosts && blocks()[b].hosts.empty()) continue;
            const std::size_t bytes = cost(
                {}, [&](Codes& codes) { codes.companions(blocks()[b], turned_[b], before, by); });
            if (by == ToldBy::walk || bytes < least) least = bytes, best = by;
        }
        return best;
    }

    const Ground<Walked>& ground_;
    const std::vector<Index>& turned_;
    Reorder& order_;
    const PointsAround<Walked> points_;
    const CellsAround<Walked> cells_;
};

}  // namespace

Bytes write_order(const Ground<Walked>& ground, const std::vector<Index>& turned, Reorder order) {
    return Writer(ground, turned, order).run();
}

}  // namespace ravel
