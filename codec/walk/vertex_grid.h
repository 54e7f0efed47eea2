// The vertices of the front by place: a uniform grid of lists, most recent first.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/complex.h"
#include "mesh/point3.h"

namespace ravel {

class VertexGrid {
  public:
    // What a search reads of a vertex stands together.
    struct Entry {
        Point3 place{};
        Id next = kNone, prev = kNone;
        std::size_t cube = 0;
    };

    // Cubes of side `side` from the origin on; what lies outside belongs to the nearest cube.
    VertexGrid(double side, const std::array<std::uint32_t, 3>& count)
        : side_(side), count_(count), heads_(std::size_t{count[0]} * count[1] * count[2], kNone) {}

    void reserve(std::size_t vertices) { entries_.reserve(vertices); }
    void insert(Id v, const Point3& p) {
        if (v >= entries_.size()) entries_.resize(v + std::size_t{1});
        Entry& entry = entries_[v];
        entry.place = p;
        entry.cube = cube_at(cube_of(p[0], 0), cube_of(p[1], 1), cube_of(p[2], 2));
        entry.next = heads_[entry.cube];
        entry.prev = kNone;
        if (entry.next != kNone) entries_[entry.next].prev = v;
        heads_[entry.cube] = v;
    }
    void erase(Id v) {
        const Entry& entry = entries_[v];
        if (entry.next != kNone) entries_[entry.next].prev = entry.prev;
        if (entry.prev != kNone)
            entries_[entry.prev].next = entry.next;
        else
            heads_[entry.cube] = entry.next;
    }

    // Calls visit(vertex, entry) for the vertices in the cubes that a ball meets, cubes in the
    // order z, y, x, until it returns false. None where the cubes are more than `most_cubes`.
    template <class Visit>
    void around(const Point3& centre, double radius, std::uint64_t most_cubes,
                const Visit& visit) const {
        std::array<std::uint32_t, 3> low{}, high{};
        std::uint64_t cubes = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = cube_of(centre[axis] - radius, axis);
            high[axis] = cube_of(centre[axis] + radius, axis);
            cubes *= high[axis] - low[axis] + std::uint64_t{1};
        }
        if (cubes > most_cubes) return;
        for (std::uint32_t z = low[2]; z <= high[2]; ++z)
            for (std::uint32_t y = low[1]; y <= high[1]; ++y)
                for (std::uint32_t x = low[0]; x <= high[0]; ++x)
                    for (Id v = heads_[cube_at(x, y, z)]; v != kNone; v = entries_[v].next)
                        if (!visit(v, entries_[v])) return;
    }

  private:
    std::uint32_t cube_of(double x, std::size_t axis) const {
        const double i = x / side_, last = count_[axis] - 1;
        if (!(i > 0)) return 0;
        return static_cast<std::uint32_t>(i < last ? i : last);
    }
    std::size_t cube_at(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
        return (std::size_t{z} * count_[1] + y) * count_[0] + x;
    }

    const double side_;
    const std::array<std::uint32_t, 3> count_;
    std::vector<Id> heads_;
    std::vector<Entry> entries_;  // per vertex
};

}  // namespace ravel
