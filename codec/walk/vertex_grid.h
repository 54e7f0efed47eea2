// The vertices of the front by place: a uniform grid of lists, most recent first.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/complex.h"
#include "walk/sphere_family.h"

namespace ravel {

class VertexGrid {
  public:
    // Cubes of side `side` from the origin on; what lies outside belongs to the nearest cube.
    VertexGrid(double side, const std::array<std::uint32_t, 3>& count)
        : side_(side), count_(count), heads_(std::size_t{count[0]} * count[1] * count[2], kNone) {}

    void insert(Id v, const Point3& p) {
        if (v >= lists_.size()) lists_.resize(v + std::size_t{1});
        Entry& entry = lists_[v];
        entry.cube = cube_at(cube_of(p[0], 0), cube_of(p[1], 1), cube_of(p[2], 2));
        entry.next = heads_[entry.cube];
        entry.prev = kNone;
        if (entry.next != kNone) lists_[entry.next].prev = v;
        heads_[entry.cube] = v;
    }
    void erase(Id v) {
        const Entry& entry = lists_[v];
        if (entry.next != kNone) lists_[entry.next].prev = entry.prev;
        if (entry.prev != kNone)
            lists_[entry.prev].next = entry.next;
        else
            heads_[entry.cube] = entry.next;
    }

    std::uint32_t cube_of(double x, std::size_t axis) const {
        const double i = x / side_, last = count_[axis] - 1;
        if (!(i > 0)) return 0;
        return static_cast<std::uint32_t>(i < last ? i : last);
    }
    Id first_in(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
        return heads_[cube_at(x, y, z)];
    }
    Id next(Id v) const { return lists_[v].next; }

  private:
    struct Entry {
        std::size_t cube = 0;
        Id next = kNone, prev = kNone;
    };
    std::size_t cube_at(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
        return (std::size_t{z} * count_[1] + y) * count_[0] + x;
    }

    const double side_;
    const std::array<std::uint32_t, 3> count_;
    std::vector<Id> heads_;
    std::vector<Entry> lists_;  // per vertex
};

}  // namespace ravel
