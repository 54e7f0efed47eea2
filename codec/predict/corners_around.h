// Corners of cells as elements with values, in the order in which the mesh has them. Most have the
// tuple of a corner at the same vertex, in a neighbour that is known.
#pragma once

#include "predict/around.h"
#include "predict/ground.h"

namespace ravel {

template <class Walk>
class CornersAround final : public Around {
  public:
    explicit CornersAround(const Ground<Walk>& ground) : ground_(ground), walk_(ground.walk) {
        std::vector<Id> last(walk_.vertex_count, kNone);
        before_.resize(walk_.vertex.size());
        for (Id c = 0; c < before_.size(); ++c) {
            before_[c] = last[walk_.vertex[c]];
            last[walk_.vertex[c]] = c;
        }
    }

    // The corners at the same vertex in the neighbours, those first with which the corner beside
    // agrees, too; then all others at the vertex; then the corner before.
    Beside beside(Id element, const Id* tuple) const override {
        const Id corner = ground_.mesh_corner(element), cell = walk_.cell_of(corner);
        Beside b;
        std::array<Id, 3> there_of{};
        std::array<std::uint32_t, 3> how_of{};
        std::size_t count = 0;
        across(corner, cell, [&](Id there, Id beside_here, Id beside_there) {
            how_of[count] = agreement(element, tuple, beside_here, beside_there);
            there_of[count++] = ground_.mesh_corner(there);
        });
        if (count == 2 && kPlace[how_of[0]] > kPlace[how_of[1]]) {
            std::swap(how_of[0], how_of[1]);
            std::swap(there_of[0], there_of[1]);
        }
        for (std::size_t i = 0; i < count; ++i) b.add(there_of[i]);
        b.hint = how_of[0] + 3 * std::min(b.count, 1u);
        Id other = before_[corner];
        // In a flipped cell that has a vertex twice the one before may come later in the mesh.
        for (int looks = 0; looks < 6 && other != kNone; ++looks, other = before_[other])
            if (ground_.mesh_corner(other) < element) b.add(ground_.mesh_corner(other), 1);
        if (element > walk_.begin(cell)) b.add(element - 1, 2);
        return b;
    }

    // The other corners of the cell, and those of the neighbours with which it agrees; as a
    // parallelogram where that can be.
    Beside beside_values(Id element, const Id* tuple) const override {
        const Id corner = ground_.mesh_corner(element), cell = walk_.cell_of(corner);
        const auto known = [&](Id c) {
            const Id e = ground_.mesh_corner(c);
            return tuple == nullptr ? e < element : tuple[e] < tuple[element];
        };
        const auto same = [&](Id c, Id d) {
            return tuple == nullptr ||
                   tuple[ground_.mesh_corner(c)] == tuple[ground_.mesh_corner(d)];
        };
        Beside b;
        const auto add = [&](Id c, std::int8_t share = 0) {
            if (known(c)) b.add(ground_.mesh_corner(c), 0, share);
        };
        const Id n = walk_.degree(cell);
        if (walk_.kind == CellKind::polygon && n >= 3) {
            const Id next = walk_.next_in_cell(corner), prev = walk_.prev_in_cell(corner);
            const Id opposite = walk_.next_in_cell(next);
            if (n == 4 && known(next) && known(prev) && known(opposite)) {
                add(next, 1);
                add(prev, 1);
                add(opposite, -1);
            } else {
                add(prev);
                add(next);
                if (n > 3) add(opposite);
            }
        } else if (walk_.kind == CellKind::tet) {
            for (Id c = walk_.begin(cell); c < walk_.end(cell); ++c)
                if (c != corner) add(c);
        }
        // Neighbours that go on without a seam.
        const Id begin = walk_.begin(cell), end = std::min(walk_.end(cell), begin + 16);
        for (Id f = begin; f < end; ++f) {
            const Id g = walk_.twin[f];
            if (g == kNone) continue;
            const Id there = walk_.cell_of(g);
            bool seam = false;
            if (walk_.kind == CellKind::polygon)
                seam = !same(f, walk_.next_in_cell(g)) || !same(walk_.next_in_cell(f), g);
            if (seam) continue;
            const Id last = std::min(walk_.end(there), walk_.begin(there) + 16);
            for (Id c = walk_.begin(there); c < last; ++c)
                if (walk_.kind == CellKind::tet || (c != g && c != walk_.next_in_cell(g))) add(c);
        }
        for (Id other = before_[corner]; b.count == 0 && other != kNone; other = before_[other])
            add(other);
        return b;
    }
    Point3 place(Id element) const override {
        return ground_.place_of_corner(ground_.mesh_corner(element));
    }
    Point3 normal(Id element, bool by_angle) const override {
        return ground_.normal_at_corner(ground_.mesh_corner(element), by_angle);
    }

  private:
    // `visit(there, beside_here, beside_there)` for the corners at the same vertex across the
    // facets of the cell; beside are the other ends of a side, or none.
    template <class Visit>
    void across(Id corner, Id cell, const Visit& visit) const {
        if (walk_.kind == CellKind::polygon) {
            const Id prev = walk_.prev_in_cell(corner);
            const Id out = walk_.twin[corner], in = walk_.twin[prev];
            if (out != kNone && walk_.cell_of(out) < cell)
                visit(walk_.next_in_cell(out), walk_.next_in_cell(corner), out);
            if (in != kNone && walk_.cell_of(in) < cell) visit(in, prev, walk_.next_in_cell(in));
            return;
        }
        for (Id f = 4 * cell; f < 4 * cell + 4; ++f) {
            const Id g = walk_.twin[f];
            if (f == corner || g == kNone || g / 4 >= cell) continue;
            for (Id c = g & ~Id{3}; c < (g & ~Id{3}) + 4; ++c)
                if (walk_.vertex[c] == walk_.vertex[corner]) visit(c, kNone, kNone);
        }
    }
    // 0: not known, 1: the same tuple at the other end of the side, 2: another.
    std::uint32_t agreement(Id element, const Id* tuple, Id here, Id there) const {
        if (tuple == nullptr || here == kNone || ground_.mesh_corner(here) >= element) return 0;
        return tuple[ground_.mesh_corner(here)] == tuple[ground_.mesh_corner(there)] ? 1 : 2;
    }

    // By agreement; three neighbours there are only of tets, where none is known.
    static constexpr std::array<std::uint8_t, 3> kPlace{1, 0, 2};

    const Ground<Walk>& ground_;
    const Walk& walk_;
    std::vector<Id> before_;  // corner -> the one before at the same vertex
};

}  // namespace ravel
