// Walks the mesh by the walker's own rule (mesh/exit_rule.h): into the first unvisited neighbour in
// exit order. At a dead end the walk resumes at the last visited cell that still has an unvisited
// neighbour, with a new path. A neighbour with fewer ways on than `look_ahead` goes first, as in
// Warnsdorff's rule [Pohl1967]: with no way on it would become a pocket of one cell, with one a
// dead end.
// Cost: linear in facets.
#include "strip/steered.h"

#include <algorithm>
#include <utility>

#include "mesh/exit_rule.h"

namespace ravel {
namespace {

class Walk {
  public:
    Walk(const Complex& complex, const SteerOptions& options)
        : complex_(complex), options_(options), cells_(complex.cell_count()) {
        for (Id f = 0; f < complex.twin.size(); ++f)
            if (complex.twin[f] != kNone) ++cells_[cell_of(f)].ways;
        walk_.order.reserve(cells_.size());
        walk_.came_by.reserve(cells_.size());
    }

    Steered run() {
        for (Id seed = 0; seed < complex_.cell_count(); ++seed) {
            if (cells_[seed].entry != kUnvisited) continue;
            visit(seed, kNone, kNone);
            // The top of the trail is the head of a path until it proves a dead end.
            for (bool head = true; !trail_.empty();) {
                const Id exit = choose(trail_.back());
                if (exit == kNone) {
                    trail_.pop_back();
                    head = false;
                    continue;
                }
                const Id entry = complex_.twin[exit];
                visit(cell_of(entry), entry, head ? exit : kNone);
                head = true;
            }
        }
        return std::move(walk_);
    }

  private:
    static constexpr Id kUnvisited = kNone - 1;
    struct Cell {
        Id entry = kUnvisited;
        Id ways = 0;  // facets glued to unvisited cells
    };

    Id cell_of(Id facet) const {
        return complex_.kind == CellKind::tet ? facet / 4 : complex_.cell_of[facet];
    }

    std::uint32_t weight(Id facet) const {
        return options_.weights.empty() ? 0 : options_.weights[facet];
    }

    void visit(Id cell, Id entry, Id came_by) {
        cells_[cell].entry = entry;
        trail_.push_back(cell);
        walk_.order.push_back(cell);
        walk_.came_by.push_back(came_by);
        walk_.entry.push_back(entry);
        for (Id f = complex_.first[cell]; f < complex_.first[cell + 1]; ++f)
            if (complex_.twin[f] != kNone) --cells_[cell_of(complex_.twin[f])].ways;
    }

    // The facet to leave by, or kNone at a dead end.
    Id choose(Id cell) {
        const Cell& here = cells_[cell];
        if (here.ways == 0) return kNone;
        if (here.entry != kNone) {
            exit_order(complex_, here.entry, order_);
        } else {
            order_.clear();
            for (Id f = complex_.first[cell + 1]; f-- > complex_.first[cell];) order_.push_back(f);
        }
        Id best = kNone, fewest = 0;
        for (const Id f : order_) {
            const Id g = complex_.twin[f];
            if (g == kNone) continue;
            const Cell& there = cells_[cell_of(g)];
            if (there.entry != kUnvisited) continue;
            const Id ways = std::min(there.ways, options_.look_ahead);
            if (best != kNone && (ways > fewest || (ways == fewest && weight(f) >= weight(best))))
                continue;
            best = f;
            fewest = ways;
        }
        return best;
    }

    const Complex& complex_;
    const SteerOptions& options_;
    std::vector<Cell> cells_;
    std::vector<Id> trail_;  // visited cells that may have unvisited neighbours
    std::vector<Id> order_;
    Steered walk_;
};

}  // namespace

Steered steer(const Complex& complex, const SteerOptions& options) {
    return Walk(complex, options).run();
}

EdgeSet paths_of(const Steered& walk, const Dual& dual) {
    EdgeSet set(dual.graph.edge_count(), 0);
    for (const Id facet : walk.came_by)
        if (facet != kNone) set[dual.edge_of[facet]] = 1;
    return set;
}

}  // namespace ravel
