// Walks the mesh by the walker's own rule (mesh/exit_rule.h): into the first unvisited neighbour in exit
// order. At a dead end the walk resumes at the last visited cell that still has an unvisited neighbour, with a
// new path. A neighbour that would be cut off by passing it goes first, as in Warnsdorff's rule [Pohl1967]: most dead
// ends are such pockets of one cell.
// Cost: linear in facets.
#include "strip/steered.h"

#include <algorithm>
#include <utility>

#include "mesh/exit_rule.h"

namespace ravel {
namespace {

class Walk {
  public:
    Walk(const Complex& complex, const Dual& dual, const SteerOptions& options)
        : complex_(complex), dual_(dual), options_(options), set_(dual.graph.edge_count(), 0),
          entry_(complex.cell_count(), kNone), ways_(complex.cell_count(), 0) {
        for (Id f = 0; f < complex.twin.size(); ++f)
            if (complex.twin[f] != kNone) ++ways_[complex.cell_of[f]];
    }

    EdgeSet run() {
        visited_.assign(complex_.cell_count(), 0);
        for (Id seed = 0; seed < complex_.cell_count(); ++seed) {
            if (visited_[seed] != 0) continue;
            visit(seed, kNone);
            while (!trail_.empty()) {
                const Id exit = choose(trail_.back());
                if (exit == kNone) {
                    trail_.pop_back();
                    fresh_ = false;
                    continue;
                }
                // Resuming starts a path; going on from the head of one makes it longer.
                if (fresh_) set_[dual_.edge_of[exit]] = 1;
                const Id entry = complex_.twin[exit];
                visit(complex_.cell_of[entry], entry);
            }
        }
        return std::move(set_);
    }

  private:
    void visit(Id cell, Id entry) {
        visited_[cell] = 1;
        entry_[cell] = entry;
        trail_.push_back(cell);
        fresh_ = true;
        for (Id f = complex_.first[cell]; f < complex_.first[cell + 1]; ++f)
            if (complex_.twin[f] != kNone) --ways_[complex_.cell_of[complex_.twin[f]]];
    }

    // The facet to leave by, or kNone at a dead end.
    Id choose(Id cell) {
        if (entry_[cell] != kNone) {
            exit_order(complex_, entry_[cell], order_);
        } else {
            order_.clear();
            for (Id f = complex_.first[cell]; f < complex_.first[cell + 1]; ++f) order_.push_back(f);
        }
        Id best = kNone;
        int fewest = 0;
        for (const Id f : order_) {
            const Id g = complex_.twin[f];
            if (g == kNone || visited_[complex_.cell_of[g]] != 0) continue;
            const int ways = std::min(ways_[complex_.cell_of[g]], options_.look_ahead);
            if (best != kNone && ways >= fewest) continue;
            best = f;
            fewest = ways;
        }
        return best;
    }

    const Complex& complex_;
    const Dual& dual_;
    const SteerOptions& options_;
    EdgeSet set_;
    std::vector<Id> entry_;
    std::vector<int> ways_;  // cell -> facets glued to unvisited cells
    std::vector<std::uint8_t> visited_;
    std::vector<Id> trail_;  // visited cells that may have unvisited neighbours
    std::vector<Id> order_;
    bool fresh_ = false;  // the cell on top of the trail is the head of a path
};

}  // namespace

EdgeSet steer(const Complex& complex, const Dual& dual, const SteerOptions& options) {
    return Walk(complex, dual, options).run();
}

}  // namespace ravel
