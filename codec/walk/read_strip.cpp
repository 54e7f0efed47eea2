// Dynamic programme over the walk's tree, children before parents. For a cell c with children d:
//     below(c) = sum of links(d): every child linked
//     links(c) = 1 + least of below(c), and over facets from c to a descendant z that no step uses:
//                below over the tree path c .. z, less links of its cells after c  (c .. z closes
//                to a cycle)
//     open(c)  = least of below(c), and below(c) - links(d) + open(d): the root's path may end
//     anywhere
// Sums along tree paths come from a forest with weights [Tarjan1979]: a cell hangs below its parent
// once its own numbers are known. The walk leaves a cell for good before it visits any that is not
// below it, so descendants are a range of numbers. Cost: near-linear.
#include "walk/read_strip.h"

#include <algorithm>

namespace ravel {
namespace {

class Reader {
  public:
    explicit Reader(const Walked& walked) : walked_(walked), cells_(walked.cell_count()) {}

    StripReading run() {
        for (Id c = walked_.cell_count(); c-- > 0;) {
            measure(c);
            if (const Id up = parent(c); up != kNone) {
                cells_[up].size += cells_[c].size;
                cells_[up].below += cells_[c].links;
            }
        }
        reading_.link.assign(cells_.size(), 0);
        for (Id c = 0; c < walked_.cell_count(); ++c) assign(c);
        return std::move(reading_);
    }

  private:
    struct Cell {
        Id size = 1;              // of its subtree
        std::int64_t below = 0;   // links, if every child is linked
        std::int64_t links = 0;   // strips in its subtree when it is entered by a link
        std::int64_t open = 0;    // links in its subtree when its path may stay open
        Id closing = kNone;       // where its cycle ends, kNone for a single cell
        Id open_child = kNone;    // where its open path goes on
        Id above = kNone;         // forest
        std::int64_t weight = 0;  // sum over this cell and those above it, but for the top one
        bool taken = false;       // part of a strip already
    };

    Id parent(Id c) const {
        return walked_.gate[c] == kNone ? kNone : walked_.cell_of(walked_.gate[c]);
    }

    // Calls visit(cell, child) over the facets of c that are glued to later cells.
    template <class Visit>
    void each_later(Id c, const Visit& visit) const {
        for (Id f = walked_.begin(c); f < walked_.end(c); ++f) {
            const Id g = walked_.twin[f];
            if (g == kNone) continue;
            const Id z = walked_.cell_of(g);
            if (z > c) visit(z, walked_.gate[z] == f);
        }
    }

    // The top of z's tree, which is the cell being measured or none; `sum` over the cells from z up
    // to below it.
    Id find(Id z, std::int64_t& sum) {
        path_.clear();
        Id top = z;
        for (; cells_[top].above != kNone; top = cells_[top].above) path_.push_back(top);
        for (std::size_t k = path_.size(); k-- > 0;) {
            Cell& cell = cells_[path_[k]];
            if (cell.above == top) continue;
            cell.weight += cells_[cell.above].weight;
            cell.above = top;
        }
        sum = z == top ? 0 : cells_[z].weight;
        return top;
    }

    void measure(Id c) {
        Cell& cell = cells_[c];
        each_later(c, [&](Id d, bool child) {
            if (!child) return;
            cells_[d].above = c;
            cells_[d].weight = cells_[d].below - cells_[d].links;
        });
        std::int64_t best = cell.below;
        cell.open = cell.below;
        each_later(c, [&](Id z, bool child) {
            if (child) {
                const std::int64_t on = cell.below - cells_[z].links + cells_[z].open;
                if (on >= cell.open) return;
                cell.open = on;
                cell.open_child = z;
                return;
            }
            if (z - c >= cell.size) return;
            std::int64_t sum = 0;
            if (find(z, sum) != c || cell.below + sum >= best) return;
            best = cell.below + sum;
            cell.closing = z;
        });
        cell.links = best + 1;
    }

    // Cells come parents first; a cell that no strip has taken yet starts one.
    void assign(Id c) {
        Cell& cell = cells_[c];
        if (cell.taken) return;
        cell.taken = true;
        if (parent(c) == kNone) {
            if (cell.links - 1 >= cell.open) {
                reading_.open_strips += cell.open_child != kNone;
                for (Id at = cell.open_child; at != kNone; at = cells_[at].open_child)
                    cells_[at].taken = true;
                return;
            }
        } else {
            reading_.link[c] = 1;
            ++reading_.links;
            reading_.added_cells += pieces(c) + pieces(parent(c));
        }
        if (cell.closing == kNone) return;
        for (Id z = cell.closing; z != c; z = parent(z)) cells_[z].taken = true;
    }

    // What a link adds on one side: a tet becomes three, an n-gon n.
    Index pieces(Id c) const {
        if (walked_.kind == CellKind::tet) return 2;
        return std::max<Id>(walked_.degree(c), 1) - 1;
    }

    const Walked& walked_;
    std::vector<Cell> cells_;
    std::vector<Id> path_;
    StripReading reading_;
};

}  // namespace

StripReading read_strip(const Walked& walked) {
    return Reader(walked).run();
}

}  // namespace ravel
