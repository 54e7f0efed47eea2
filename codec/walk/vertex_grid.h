// The vertices of the front by place: uniform grids of lists, most recent first, the cubes of each
// twice as large as those of the one before. A ball is looked up where it meets some dozen cubes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/complex.h"
#include "mesh/point3.h"

namespace ravel {

class VertexGrid {
  public:
    static constexpr std::size_t kLevels = 5;

    // The smallest cubes have `side` and start at the origin; what lies outside belongs to the
    // nearest cube.
    VertexGrid(double side, const std::array<std::uint32_t, 3>& count) {
        for (std::size_t l = 0; l < kLevels; ++l, side *= 2) {
            Level& level = levels_[l];
            level.side = side;
            for (std::size_t axis = 0; axis < 3; ++axis)
                level.count[axis] = l == 0 ? count[axis] : levels_[l - 1].count[axis] / 2 + 1;
            level.heads.assign(std::size_t{level.count[0]} * level.count[1] * level.count[2],
                               kNone);
        }
    }

    void reserve(std::size_t vertices) { entries_.reserve(vertices); }
    void insert(Id v, const Point3& p) {
        if (v >= entries_.size()) entries_.resize(v + std::size_t{1});
        entries_[v].place = p;
        for (std::size_t l = 0; l < kLevels; ++l) {
            Id& head = levels_[l].heads[levels_[l].cube_of(p)];
            entries_[v].links[l] = {head, kNone};
            if (head != kNone) entries_[head].links[l].prev = v;
            head = v;
        }
    }
    void erase(Id v) {
        for (std::size_t l = 0; l < kLevels; ++l) {
            const Link link = entries_[v].links[l];
            if (link.next != kNone) entries_[link.next].links[l].prev = link.prev;
            if (link.prev != kNone)
                entries_[link.prev].links[l].next = link.next;
            else
                levels_[l].heads[levels_[l].cube_of(entries_[v].place)] = link.next;
        }
    }

    // Calls visit(vertex, place) for the vertices in the cubes that a ball meets, cubes in the
    // order z, y, x, until it returns false. None where even of the largest cubes it meets too
    // many.
    template <class Visit>
    void around(const Point3& centre, double radius, const Visit& visit) const {
        std::size_t l = 0;
        while (l + 1 < kLevels && radius > 1.5 * levels_[l].side) ++l;
        const Level& level = levels_[l];
        std::array<std::uint32_t, 3> low{}, high{};
        std::uint64_t cubes = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = level.step(centre[axis] - radius, axis);
            high[axis] = level.step(centre[axis] + radius, axis);
            cubes *= high[axis] - low[axis] + std::uint64_t{1};
        }
        if (cubes > kMostCubes) return;
        for (std::uint32_t z = low[2]; z <= high[2]; ++z)
            for (std::uint32_t y = low[1]; y <= high[1]; ++y) {
                const Id* row = level.heads.data() + level.cube_at(0, y, z);
                for (std::uint32_t x = low[0]; x <= high[0]; ++x)
                    for (Id v = row[x]; v != kNone; v = entries_[v].links[l].next)
                        if (!visit(v, entries_[v].place)) return;
            }
    }

  private:
    static constexpr std::uint64_t kMostCubes = 512;
    struct Link {
        Id next = kNone, prev = kNone;
    };
    struct Entry {
        Point3 place{};
        std::array<Link, kLevels> links;
    };
    struct Level {
        double side = 1;
        std::array<std::uint32_t, 3> count{1, 1, 1};
        std::vector<Id> heads;

        std::uint32_t step(double x, std::size_t axis) const {
            const double i = x / side, last = count[axis] - 1;
            if (!(i > 0)) return 0;
            return static_cast<std::uint32_t>(i < last ? i : last);
        }
        std::size_t cube_at(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
            return (std::size_t{z} * count[1] + y) * count[0] + x;
        }
        std::size_t cube_of(const Point3& p) const {
            return cube_at(step(p[0], 0), step(p[1], 1), step(p[2], 2));
        }
    };

    std::array<Level, kLevels> levels_;
    std::vector<Entry> entries_;  // per vertex; a cache line each
};

}  // namespace ravel
