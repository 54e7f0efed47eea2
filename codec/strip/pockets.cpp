// Dynamic programme over the walk's tree, children before parents. For a cell c with children d:
//     below(c) = sum of links(d): every child linked
//     links(c) = 1 + least of below(c), and over facets from c to a descendant z that the tree does
//     not use:
//                below over the tree path c .. z, less links of its cells after c  (c .. z closes
//                to a cycle)
//     open(c)  = least of below(c), and below(c) - links(d) + open(d): the root's path may end
//     anywhere
// Sums along tree paths come from a forest with weights [Tarjan1979]: a cell hangs below its parent
// once its own numbers are known. Cost: near-linear.
#include "strip/pockets.h"

#include <algorithm>

#include "strip/links.h"
#include "strip/merge.h"

namespace ravel {
namespace {

class Pockets {
  public:
    Pockets(const Complex& complex, const Steered& walk)
        : complex_(complex), walk_(walk), cells_(complex.cell_count()) {
        strip_.role.assign(complex.twin.size(), FacetRole::none);
    }

    Strip run() {
        for (Id i = 0; i < cells_.size(); ++i) cells_[walk_.order[i]].place = i;
        for (Id i = static_cast<Id>(cells_.size()); i-- > 0;) {
            const Id cell = walk_.order[i];
            measure(cell);
            if (const Id up = parent(cell); up != kNone) {
                cells_[up].size += cells_[cell].size;
                cells_[up].below += cells_[cell].links;
            }
        }
        for (const Id cell : walk_.order) assign(cell);
        return std::move(strip_);
    }

  private:
    struct Cell {
        Id place = 0;             // in the walk
        Id size = 1;              // of its subtree
        std::int64_t below = 0;   // links, if every child is linked
        std::int64_t links = 0;   // strips in its subtree when it is entered by a link
        std::int64_t open = 0;    // links in its subtree when its path may stay open
        Id closing = kNone;       // facet by which its cycle closes, kNone for a singleton
        Id open_child = kNone;    // where its open path goes on
        Id above = kNone;         // forest
        std::int64_t weight = 0;  // sum over this cell and those above it, but for the top one
        bool taken = false;       // part of a strip already
    };

    Id entry(Id cell) const { return walk_.entry[cells_[cell].place]; }
    Id parent(Id cell) const {
        const Id facet = entry(cell);
        return facet == kNone ? kNone : complex_.cell_of[complex_.twin[facet]];
    }

    template <class Visit>
    void each_child(Id cell, const Visit& visit) const {
        for (Id f = complex_.first[cell]; f < complex_.first[cell + 1]; ++f)
            if (const Id g = complex_.twin[f]; g != kNone && entry(complex_.cell_of[g]) == g)
                visit(complex_.cell_of[g]);
    }

    // The top of z's tree, which is the cell being measured; `sum` over the cells from z up to
    // below it.
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
        each_child(c, [&](Id d) {
            cells_[d].above = c;
            cells_[d].weight = cells_[d].below - cells_[d].links;
        });
        std::int64_t best = cell.below;
        for (Id f = complex_.first[c]; f < complex_.first[c + 1]; ++f) {
            const Id g = complex_.twin[f];
            if (g == kNone || f == entry(c)) continue;
            const Id z = complex_.cell_of[g], place = cells_[z].place;
            if (entry(z) == g || place <= cell.place || place >= cell.place + cell.size) continue;
            std::int64_t sum = 0;
            if (find(z, sum) != c || cell.below + sum >= best) continue;
            best = cell.below + sum;
            cell.closing = f;
        }
        cell.links = best + 1;
        cell.open = cell.below;
        each_child(c, [&](Id d) {
            const std::int64_t on = cell.below - cells_[d].links + cells_[d].open;
            if (on >= cell.open) return;
            cell.open = on;
            cell.open_child = d;
        });
    }

    void set(Id facet, FacetRole role) {
        strip_.role[facet] = strip_.role[complex_.twin[facet]] = role;
    }

    // Cells come parents first; a cell that no strip has taken yet starts one.
    void assign(Id c) {
        Cell& cell = cells_[c];
        if (cell.taken) return;
        cell.taken = true;
        if (parent(c) == kNone) {
            strip_.roots.push_back(c);
            ++strip_.counts.components;
            if (cell.links - 1 >= cell.open) {
                strip_.counts.open_strips += cell.open_child != kNone;
                for (Id at = c; cells_[at].open_child != kNone;) {
                    at = cells_[at].open_child;
                    cells_[at].taken = true;
                    set(entry(at), FacetRole::strip);
                }
                return;
            }
        } else {
            ++strip_.counts.links;
            set(entry(c), FacetRole::link);
        }
        if (cell.closing == kNone) return;
        set(cell.closing, FacetRole::strip);
        for (Id z = complex_.cell_of[complex_.twin[cell.closing]]; z != c; z = parent(z)) {
            cells_[z].taken = true;
            set(entry(z), FacetRole::strip);
        }
    }

    const Complex& complex_;
    const Steered& walk_;
    std::vector<Cell> cells_;
    std::vector<Id> path_;
    Strip strip_;
};

}  // namespace

Strip link_pockets(const Complex& complex, const Steered& walk) {
    Strip strip = Pockets(complex, walk).run();
    strip.counts.strips = strip.counts.components;
    return strip;
}

Strip merge_pockets(const Complex& complex, const Steered& walk) {
    const Strip linked = link_pockets(complex, walk);
    const Dual dual = make_dual(complex, walk.order);
    EdgeSet set(dual.graph.edge_count(), 0);
    for (GraphId e = 0; e < set.size(); ++e)
        set[e] = linked.role[dual.facet_of[e]] == FacetRole::strip;
    StripList strips = list_strips(dual.graph, set);
    Merged merged = merge_fans(complex, dual, std::move(set), std::move(strips));
    Strip strip = link_strips(complex, dual, merged.set);
    strip.counts.fan_merges = merged.fan_merges;
    return strip;
}

Index added_cells(const Complex& complex, const Strip& strip) {
    Index added = 0;
    for (Id f = 0; f < complex.twin.size(); ++f) {
        if (strip.role[f] != FacetRole::link) continue;
        // Each side of a link is counted by its own cell: a tet becomes three, an n-gon n.
        const Id degree = complex.degree(complex.cell_of[f]);
        added += complex.kind == CellKind::tet ? 2 : std::max<Id>(degree, 1) - 1;
    }
    return added;
}

}  // namespace ravel
