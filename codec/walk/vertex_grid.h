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
    VertexGrid(double side, const std::array<std::uint32_t, 3>& count)
        : side_(side), scale_(1 / side) {
        for (std::size_t axis = 0; axis < 3; ++axis) last_[axis] = count[axis] - 1;
        for (std::size_t l = 0; l < kLevels; ++l) {
            std::array<std::size_t, 3> steps;
            for (std::size_t axis = 0; axis < 3; ++axis)
                steps[axis] = ((count[axis] - 1) >> l) + std::size_t{1};
            levels_[l].row = steps[0];
            levels_[l].layer = steps[0] * steps[1];
            levels_[l].heads.assign(levels_[l].layer * steps[2], kNone);
        }
    }

    void reserve(std::size_t vertices) { entries_.reserve(vertices); }
    void insert(Id v, const Point3& p) {
        if (v >= entries_.size()) entries_.resize(v + std::size_t{1});
        entries_[v].place = p;
        const Steps steps = steps_of(p);
        for (std::size_t l = 0; l < kLevels; ++l) {
            Id& head = levels_[l].head(steps, l);
            entries_[v].links[l] = {head, kNone};
            if (head != kNone) entries_[head].links[l].prev = v;
            head = v;
        }
    }
    void erase(Id v) {
        const Steps steps = steps_of(entries_[v].place);
        for (std::size_t l = 0; l < kLevels; ++l) {
            const Link link = entries_[v].links[l];
            if (link.next != kNone) entries_[link.next].links[l].prev = link.prev;
            if (link.prev != kNone)
                entries_[link.prev].links[l].next = link.next;
            else
                levels_[l].head(steps, l) = link.next;
        }
    }

    // Calls visit(vertex, place) for the vertices in the cubes that a ball meets, cubes in the
    // order z, y, x, until it returns false. None where even of the largest cubes it meets too
    // many.
    template <class Visit>
    void around(const Point3& centre, double radius, const Visit& visit) const {
        std::size_t l = 0;
        double reach = 1.5 * side_;
        while (l + 1 < kLevels && radius > reach) ++l, reach *= 2;
        Steps low, high;
        std::uint64_t cubes = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = step(centre[axis] - radius, axis) >> l;
            high[axis] = step(centre[axis] + radius, axis) >> l;
            cubes *= high[axis] - low[axis] + std::uint64_t{1};
        }
        if (cubes > kMostCubes) return;
        const Level& level = levels_[l];
        for (std::size_t z = low[2]; z <= high[2]; ++z)
            for (std::size_t y = low[1]; y <= high[1]; ++y) {
                const Id* row = level.heads.data() + z * level.layer + y * level.row;
                for (std::size_t x = low[0]; x <= high[0]; ++x)
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
    using Steps = std::array<std::uint32_t, 3>;
    struct Level {
        std::size_t row = 1, layer = 1;  // cubes in a row, and in a layer
        std::vector<Id> heads;

        // `steps` in the smallest cubes.
        Id& head(const Steps& steps, std::size_t level) {
            return heads[(steps[2] >> level) * layer + (steps[1] >> level) * row +
                         (steps[0] >> level)];
        }
    };

    std::uint32_t step(double x, std::size_t axis) const {
        const double i = x * scale_;
        if (!(i > 0)) return 0;
        return i < last_[axis] ? static_cast<std::uint32_t>(i) : last_[axis];
    }
    Steps steps_of(const Point3& p) const { return {step(p[0], 0), step(p[1], 1), step(p[2], 2)}; }

    double side_, scale_;
    Steps last_{};
    std::array<Level, kLevels> levels_;
    std::vector<Entry> entries_;  // per vertex; a cache line each
};

}  // namespace ravel
