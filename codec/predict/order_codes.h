// Codes the order that a mesh had: old numbers of points, cells and companions, and how these are
// turned. What is coded second is taken in an order that the first tells: points as old cells use
// them, or cells as their old points follow. Points of edges come last, as the ends of the edges
// or the old cells follow. On either side: `Coder` writes or reads.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "mesh/reorder.h"
#include "predict/counting_sort.h"
#include "predict/ground.h"
#include "predict/linear_guess.h"
#include "predict/numbering_codes.h"

namespace ravel {

// Companions (and their nodes) in a block whose order is kept are fewer.
inline constexpr Index kMostNumbers = Index{1} << 30;

// In which order numbers are told: as the elements come, or by the old points they have, compared
// from the lowest on, from the highest on, or from the first on; or by the old numbers of their
// hosts.
enum class ToldBy : std::uint8_t { walk, lowest, highest, first, hosts };

// The same of the points of edges: as they come, by the old points of the ends from the lowest on,
// or as the old cells use them, with the edges of a cell as VTK or as Gmsh has them.
enum class EdgesBy : std::uint8_t { walk, ends, cells, gmsh_cells };

struct OrderCoding {
    bool cells_first = false;      // then points are told as old cells use them
    bool turns_by_points = false;  // turns are told by the lowest old point, else by the gate
    bool guesses_points = false, guesses_cells = false;  // from those beside, along the walk
    ToldBy cells = ToldBy::walk;
    EdgesBy edges = EdgesBy::walk;
};

// Elements are compared by so many of their points.
inline constexpr int kMostCompared = 4;

// The elements whose nodes are given (element e has nodes begin[e] .. begin[e + 1] - 1, points
// below `points` in the old order) sorted by them: by the lowest, the next above it and so on; by
// the highest, the next below it and so on; by the first ones. Those with fewer come before those
// with more. Ties stay in order. Linear.
inline std::vector<Id> told_order(const std::vector<Id>& begin, const std::vector<Id>& old_node,
                                  ToldBy by, Id points) {
    const std::size_t count = begin.size() - 1;
    std::vector<Id> order(count);
    std::iota(order.begin(), order.end(), 0);
    if (by == ToldBy::walk) return order;
    std::array<std::vector<Id>, kMostCompared> keys;  // point + 1, or 0 for none
    for (std::size_t column = 0; column < keys.size(); ++column) {
        keys[column].assign(count, 0);
        for (std::size_t e = 0; e < count; ++e) {
            Id& key = keys[column][e];
            if (by == ToldBy::first) {
                if (begin[e] + column < begin[e + 1]) key = old_node[begin[e] + column] + 1;
                continue;
            }
            const Id last = column > 0 ? keys[column - 1][e] : by == ToldBy::lowest ? 0 : kNone;
            if (column > 0 && last == 0) continue;
            for (Id i = begin[e]; i < begin[e + 1]; ++i) {
                const Id k = old_node[i] + 1;
                if (by == ToldBy::lowest ? k > last && (key == 0 || k < key) : k < last && k > key)
                    key = k;
            }
        }
    }
    for (std::size_t column = keys.size(); column-- > 0;)
        counting_sort(order, keys[column], points + 1);
    return order;
}

template <class Coder, class Walk>
class OrderCodes {
  public:
    // `points_around`, `cells_around`: for guesses.
    OrderCodes(Coder& coder, const Ground<Walk>& ground, const OrderCoding& coding,
               const Around& points_around, const Around& cells_around, Reorder& order)
        : coder_(coder),
          ground_(ground),
          mesh_(ground.mesh),
          coding_(coding),
          points_around_(points_around),
          cells_around_(cells_around),
          order_(order),
          point_numbers_(coder, static_cast<Id>(mesh_.point_count()),
                         static_cast<Id>(mesh_.point_count())) {
        edges_end_ = edges_begin_ = ground.stencils.size();
        while (edges_begin_ > 0 &&
               ground.stencils[edges_begin_ - 1].configuration == Configuration::edge)
            --edges_begin_;
        order_.old_point.resize(mesh_.point_count());
        order_.old_cell.resize(mesh_.cell_count());
        order_.turn.resize(mesh_.cell_count());
    }

    // False: no encoder writes this.
    bool run() {
        return (coding_.cells_first ? turns() && cells() && points()
                                    : points() && turns() && cells()) &&
               edge_points();
    }
    // All but those of edges and what comes behind them.
    bool points() {
        std::vector<Id> told(mesh_.point_count());
        std::iota(told.begin(), told.end(), 0);
        if (coding_.cells_first) told = as_used();
        if (has_edges()) told.resize(edges_begin_);
        const bool guesses = coding_.guesses_points && !coding_.cells_first;
        return numbers(point_numbers_, told, guesses ? &points_around_ : nullptr, order_.old_point,
                       0);
    }
    bool edge_points() {
        if (!has_edges()) return true;
        std::vector<Id> told = told_edges();
        for (auto p = static_cast<Id>(edges_end_); p < mesh_.point_count(); ++p) told.push_back(p);
        return numbers(point_numbers_, told, nullptr, order_.old_point, 0);
    }
    bool has_edges() const { return edges_begin_ < edges_end_; }
    bool turns() {
        const bool tets = mesh_.kind == CellKind::tet;
        last_turn_ = 0;
        for (Id c = 0; c < order_.turn.size(); ++c) {
            if (tets) {
                if (!code_tet_turn(c)) return false;
            } else if (const Id n = degree(c); n > 1) {
                if (!(coding_.turns_by_points ? code_start(n, lowest_corner(c), order_.turn[c])
                                              : code_small(n, left_by(c), order_.turn[c])))
                    return false;
            } else {
                order_.turn[c] = 0;
            }
        }
        return true;
    }
    bool cells() {
        const auto count = static_cast<Id>(mesh_.cell_count());
        const ToldBy by = coding_.cells;
        std::vector<Id> begin(std::size_t{count} + 1), old_node;
        if (by != ToldBy::walk) {
            old_node.resize(mesh_.corners.size());
            for (Id c = 0; c < count; ++c) {
                const auto cell = mesh_.cell(c);
                const Id n = degree(c);
                begin[c + 1] = begin[c] + n;
                for (Id i = 0; i < n; ++i)
                    old_node[begin[c] + old_corner(mesh_.kind, order_.turn[c], n, i)] =
                        old_point(cell[i]);
            }
        }
        const bool guesses = coding_.guesses_cells && by == ToldBy::walk;
        NumberingCodes<Coder> codes(coder_, count, count);
        return numbers(codes, told_order(begin, old_node, by, static_cast<Id>(mesh_.point_count())),
                       guesses ? &cells_around_ : nullptr, order_.old_cell, 0);
    }

    // The companions of a block, of which the first `turned` may be turned; `before`: those of the
    // blocks before it.
    bool companions(const CompanionBlock& block, Index turned, Index before, ToldBy by) {
        const Id n = block.nodes_per_cell, count = static_cast<Id>(block.cell_count);
        std::vector<Id> begin(std::size_t{count} + 1), old_node(std::size_t{count} * n);
        last_turn_ = 0;
        for (Id e = 0; e < count; ++e) {
            std::uint32_t& turn = order_.companion_turn[before + e];
            const auto nodes = old_node.begin() + static_cast<std::ptrdiff_t>(std::size_t{e} * n);
            const auto take = [&](Id first) {
                for (Id k = 0; k < n; ++k)
                    nodes[k] = old_point(block.nodes[std::size_t{e} * n + (first + k) % n]);
            };
            take(0);
            begin[e + 1] = (e + 1) * n;
            if (e >= turned || n < 3) continue;
            const auto lowest = static_cast<Id>(std::min_element(nodes, nodes + n) - nodes);
            if (!code_start(n, lowest, turn)) return false;
            take((n - turn) % n);
        }
        NumberingCodes<Coder> codes(coder_, count, count);
        auto bound = static_cast<Id>(mesh_.point_count());
        if (by == ToldBy::hosts) {
            // As if the host were the only node.
            by = ToldBy::first;
            bound = static_cast<Id>(mesh_.cell_count());
            std::iota(begin.begin(), begin.end(), Id{0});
            old_node.clear();
            for (const Index host : block.hosts)
                old_node.push_back(static_cast<Id>(order_.old_cell[host]));
        }
        return numbers(codes, told_order(begin, old_node, by, bound), nullptr, order_.old_companion,
                       before);
    }

    // Of a pool; told in the order of the file.
    bool tuples(std::vector<Index>& old) {
        std::vector<Id> told(old.size());
        std::iota(told.begin(), told.end(), 0);
        const auto count = static_cast<Id>(old.size());
        NumberingCodes<Coder> codes(coder_, count, count);
        return numbers(codes, told, nullptr, old, 0);
    }

  private:
    Id old_point(Index p) const { return static_cast<Id>(order_.old_point[p]); }
    Id degree(Id cell) const { return static_cast<Id>(mesh_.cell(cell).size()); }

    // Old numbers of the elements, in the order they are told; counted from `before`.
    bool numbers(NumberingCodes<Coder>& codes, const std::vector<Id>& told, const Around* around,
                 std::vector<Index>& old, Index before) {
        for (const Id e : told) {
            Stencil near;
            near.variant = 2;  // they tell each other
            double guess = 0;
            if (codes.told() > 0) near.at[0] = codes.told() - 1;
            if (around != nullptr) {
                const Beside beside = around->beside(e, nullptr);
                const Shares shares = shares_of(Guess::linear, beside, *around, e);
                for (std::uint32_t k = 0; k < beside.count; ++k) {
                    guess += shares[k] * static_cast<double>(old[before + beside.at[k]]);
                    if (k < 3) near.at[k] = beside.at[k];
                }
            }
            Id number = 0;
            const Id truth = Coder::kWrites ? static_cast<Id>(old[before + e] - before) : 0;
            if (!codes.code(around != nullptr ? &guess : nullptr, near, truth, number))
                return false;
            old[before + e] = before + number;
        }
        return true;
    }
    // The points as the old cells use them, then the others.
    std::vector<Id> as_used() const {
        std::vector<Id> told;
        told.reserve(mesh_.point_count());
        std::vector<std::uint8_t> used(mesh_.point_count(), 0);
        std::vector<Id> old_first;
        for (const Index c : inverse_of(order_.old_cell, mesh_.cell_count())) {
            const auto cell = mesh_.cell(c);
            const auto n = static_cast<std::uint32_t>(cell.size());
            old_first.resize(n);
            for (std::uint32_t i = 0; i < n; ++i)
                old_first[old_corner(mesh_.kind, order_.turn[c], n, i)] = static_cast<Id>(cell[i]);
            for (const Id p : old_first) {
                if (!used[p]) told.push_back(p);
                used[p] = 1;
            }
        }
        for (Id p = 0; p < used.size(); ++p)
            if (!used[p]) told.push_back(p);
        return told;
    }

    // The points of edges, in the order that is told.
    std::vector<Id> told_edges() const {
        const std::size_t count = edges_end_ - edges_begin_;
        std::vector<Id> told;
        if (coding_.edges == EdgesBy::walk || coding_.edges == EdgesBy::ends) {
            std::vector<Id> begin(count + 1), old_node;
            for (std::size_t e = 0; e < count; ++e) {
                begin[e + 1] = static_cast<Id>(2 * e + 2);
                for (std::size_t i = 0; i < 2; ++i)
                    old_node.push_back(
                        old_point(ground_.point[ground_.stencils[edges_begin_ + e].at[i]]));
            }
            const bool by_ends = coding_.edges == EdgesBy::ends;
            told = told_order(begin, old_node, by_ends ? ToldBy::lowest : ToldBy::walk,
                              static_cast<Id>(mesh_.point_count()));
            for (Id& e : told) e += static_cast<Id>(edges_begin_);
            return told;
        }
        // Each when it comes first, then those that no block has.
        std::vector<std::uint8_t> seen(count, 0);
        const auto take = [&](Index p) {
            if (p < edges_begin_ || p >= edges_end_ || seen[p - edges_begin_]) return;
            seen[p - edges_begin_] = 1;
            told.push_back(static_cast<Id>(p));
        };
        const bool gmsh = coding_.edges == EdgesBy::gmsh_cells;
        for (const CompanionBlock& given : mesh_.companions) {
            if (given.vtk_type != 24 || given.nodes_per_cell != 6 ||
                given.hosts.size() != mesh_.cell_count())
                continue;
            CompanionBlock block = given;
            turn_edge_nodes(block, true, [&](Index host) { return order_.turn[host]; });
            for (const Index c : inverse_of(order_.old_cell, mesh_.cell_count()))
                for (std::size_t k = 0; k < 6; ++k)
                    take(block.nodes[6 * c + (gmsh && k > 3 ? 9 - k : k)]);
        }
        for (Index p = edges_begin_; p < edges_end_; ++p) take(p);
        return told;
    }

    // --- turns -----------------------------------------------------------------------------------

    Id lowest_corner(Id c) const {
        const auto cell = mesh_.cell(c);
        Id lowest = 0;
        for (Id i = 1; i < cell.size(); ++i)
            if (old_point(cell[i]) < old_point(cell[lowest])) lowest = i;
        return lowest;
    }
    // The old corner of the cell before that faces (or starts) the facet it is left by; 8 for none.
    std::uint32_t left_by(Id c) const {
        const Walk& walk = ground_.walk;
        const Id gate = walk.gate[c];
        if (gate == kNone) return 8;
        const Id g = walk.cell_of(gate), i = ground_.mesh_corner(gate) - walk.begin(g);
        return std::min(old_corner(mesh_.kind, order_.turn[g], degree(g), i), 7u);
    }
    // The old corner (node) that has the lowest old point, which is new corner `lowest`.
    bool code_start(Id n, Id lowest, std::uint32_t& turn) {
        std::uint32_t place = Coder::kWrites ? (turn + lowest) % n : 0;
        if (!code_small(n, last_turn_, place)) return false;
        last_turn_ = std::min(place, 7u);
        turn = (place + n - lowest) % n;
        return true;
    }
    // One of n, by steps under contexts; what is left as it is.
    bool code_small(Id n, std::uint32_t context, std::uint32_t& value) {
        using C = AttributeContexts;
        for (std::uint32_t k = 0; k + 1 < n && k < 8; ++k)
            if (coder_.flag(C::turn.at(context, 0, k), Coder::kWrites && value == k)) {
                value = k;
                return true;
            }
        if (n <= 9) {
            value = n - 1;
            return true;
        }
        value = static_cast<std::uint32_t>(
            coder_.plain(value, static_cast<int>(std::bit_width(n - 1))));
        return value < n;
    }
    // Where the old corners 0 and 1 are, and whether the others are swapped.
    bool code_tet_turn(Id c) {
        std::array<std::uint32_t, 4> place{0, 1, 2, 3};  // new corner -> what stands for it
        std::uint32_t context = last_turn_;
        if (coding_.turns_by_points) {
            const auto cell = mesh_.cell(c);
            for (std::size_t i = 0; i < 4; ++i) {
                place[i] = 0;
                for (std::size_t j = 0; j < 4; ++j)
                    place[i] +=
                        old_point(cell[j]) < old_point(cell[i]) || (j < i && cell[j] == cell[i]);
            }
        } else {
            context = left_by(c);
        }
        // old corner -> what stands for it
        std::array<std::uint32_t, 4> seen{};
        if constexpr (Coder::kWrites) {
            const auto turn = tet_turn(order_.turn[c]);
            for (std::size_t i = 0; i < 4; ++i) seen[turn[i]] = place[i];
        }
        std::array<std::uint32_t, 4> left{0, 1, 2, 3};
        const auto take = [&](std::size_t old, std::uint32_t block, std::uint32_t under) {
            const std::size_t most = 3 - old;
            std::size_t k = 0;
            while (k < most && !coder_.flag(AttributeContexts::turn.at(
                                                under, block, static_cast<std::uint32_t>(k)),
                                            Coder::kWrites && left[k] == seen[old]))
                ++k;
            seen[old] = left[k];
            for (; k < 3; ++k) std::swap(left[k], left[k + 1]);
        };
        take(0, 1, context);
        take(1, 2 + seen[0], std::min(context, 8u));
        // Most often the turn is even, as it is where the cells keep their orientation.
        const auto parity = [](const std::array<std::uint32_t, 4>& p) {
            bool odd = false;
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < i; ++j) odd = odd != (p[j] > p[i]);
            return odd;
        };
        std::array<std::uint32_t, 4> even = {seen[0], seen[1], left[0], left[1]};
        if (parity(even) != parity(place)) std::swap(even[2], even[3]);
        if (coder_.flag(AttributeContexts::turn.at(0, 6, 0), Coder::kWrites && even[2] != seen[2]))
            std::swap(even[2], even[3]);
        last_turn_ = coding_.turns_by_points ? std::min(even[0] * 2 + (even[1] > even[0]), 8u) : 0;
        std::array<std::uint8_t, 4> turn{};
        for (std::size_t i = 0; i < 4; ++i)
            turn[i] = static_cast<std::uint8_t>(std::find(even.begin(), even.end(), place[i]) -
                                                even.begin());
        order_.turn[c] = number_of_tet_turn(turn);
        return true;
    }

    Coder& coder_;
    const Ground<Walk>& ground_;
    const Mesh& mesh_;
    const OrderCoding& coding_;
    const Around &points_around_, &cells_around_;
    Reorder& order_;
    NumberingCodes<Coder> point_numbers_;
    std::size_t edges_begin_ = 0, edges_end_ = 0;  // points of edges
    std::uint32_t last_turn_ = 0;
};

}  // namespace ravel
