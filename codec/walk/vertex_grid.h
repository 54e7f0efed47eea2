// The vertices of the front by place: a uniform grid of cubes, each with a list, most recent first.
// Blocks of 4 x 4 x 4 cubes know by one word which of theirs are empty, so a ball is looked up
// without a look at these.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "mesh/complex.h"
#include "mesh/point3.h"

namespace ravel {

class VertexGrid {
  public:
    // Cubes have `side` and start at the origin; what lies outside belongs to the nearest cube.
    VertexGrid(double side, const std::array<std::uint32_t, 3>& count) : scale_(1 / side) {
        for (std::size_t axis = 0; axis < 3; ++axis) last_[axis] = count[axis] - 1;
        row_ = last_[0] / 4 + std::size_t{1};
        layer_ = row_ * (last_[1] / 4 + std::size_t{1});
        blocks_.resize(layer_ * (last_[2] / 4 + std::size_t{1}));
    }

    void reserve(std::size_t vertices) { entries_.reserve(vertices); }
    void insert(Id v, const Point3& p) {
        if (v >= entries_.size()) entries_.resize(v + std::size_t{1});
        const Cube cube = cube_of(p);
        Block& block = blocks_[cube.block];
        const bool empty = (block.filled >> cube.bit & 1) == 0;
        const Id head = empty ? kNone : block.head[cube.bit];
        entries_[v] = {p, head, kNone};
        if (!empty) entries_[head].prev = v;
        block.head[cube.bit] = v;
        block.filled |= std::uint64_t{1} << cube.bit;
    }
    void erase(Id v) {
        const Entry& entry = entries_[v];
        if (entry.next != kNone) entries_[entry.next].prev = entry.prev;
        if (entry.prev != kNone) {
            entries_[entry.prev].next = entry.next;
            return;
        }
        const Cube cube = cube_of(entry.place);
        Block& block = blocks_[cube.block];
        block.head[cube.bit] = entry.next;
        if (entry.next == kNone) block.filled &= ~(std::uint64_t{1} << cube.bit);
    }

    // Calls visit(vertex, place) for the vertices in the cubes that the box about a ball meets,
    // until it returns false: blocks in the order z, y, x, in these the cubes likewise. None where
    // it meets too many blocks.
    template <class Visit>
    void around(const Point3& centre, double radius, const Visit& visit) const {
        Steps low, high;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = step(centre[axis] - radius, axis);
            high[axis] = step(centre[axis] + radius, axis);
        }
        const auto blocks = [&](std::size_t axis) {
            return (high[axis] >> 2) - (low[axis] >> 2) + std::uint64_t{1};
        };
        if (blocks(0) * blocks(1) * blocks(2) > kMostBlocks) return;
        for (std::size_t z = low[2] >> 2; z <= high[2] >> 2; ++z) {
            const std::uint64_t in_z =
                kCubes << 16 * first(low[2], z) & kCubes >> 16 * rest(high[2], z);
            for (std::size_t y = low[1] >> 2; y <= high[1] >> 2; ++y) {
                const std::uint64_t rows =
                    kRows << 4 * first(low[1], y) & kRows >> 4 * rest(high[1], y) & kRows;
                const std::uint64_t in_y = in_z & rows * 0x0001000100010001u;
                const Block* row = blocks_.data() + z * layer_ + y * row_;
                for (std::size_t x = low[0] >> 2; x <= high[0] >> 2; ++x) {
                    const std::uint64_t steps =
                        kSteps << first(low[0], x) & kSteps >> rest(high[0], x);
                    std::uint64_t cubes = row[x].filled & in_y & steps * 0x1111111111111111u;
                    for (; cubes != 0; cubes &= cubes - 1) {
                        Id v = row[x].head[static_cast<std::size_t>(std::countr_zero(cubes))];
                        do {
                            const Entry& entry = entries_[v];
                            if (!visit(v, entry.place)) return;
                            v = entry.next;
                        } while (v != kNone);
                    }
                }
            }
        }
    }

  private:
    static constexpr std::uint64_t kMostBlocks = 512;
    // All cubes of a block, those of a layer, and of a row.
    static constexpr std::uint64_t kCubes = ~std::uint64_t{0}, kRows = 0xFFFF, kSteps = 0xF;
    struct Entry {
        Point3 place{};
        Id next = kNone, prev = kNone;
    };
    struct Block {
        std::uint64_t filled = 0;  // bit x + 4 y + 16 z: cube (x, y, z) of the block has vertices
        std::array<Id, 64> head{};
    };
    using Steps = std::array<std::uint32_t, 3>;
    struct Cube {
        std::size_t block;
        std::uint32_t bit;
    };

    // The first step of a range within block b, and how many after the last.
    static unsigned first(std::uint32_t low, std::size_t b) { return low >> 2 == b ? low & 3 : 0; }
    static unsigned rest(std::uint32_t high, std::size_t b) {
        return high >> 2 == b ? 3 - (high & 3) : 0;
    }

    std::uint32_t step(double x, std::size_t axis) const {
        const double i = x * scale_;
        if (!(i > 0)) return 0;
        return i < last_[axis] ? static_cast<std::uint32_t>(i) : last_[axis];
    }
    Cube cube_of(const Point3& p) const {
        const Steps s{step(p[0], 0), step(p[1], 1), step(p[2], 2)};
        return {(s[2] >> 2) * layer_ + (s[1] >> 2) * row_ + (s[0] >> 2),
                (s[0] & 3) | (s[1] & 3) << 2 | (s[2] & 3) << 4};
    }

    double scale_;
    Steps last_{};
    std::size_t row_ = 1, layer_ = 1;  // blocks in a row, and in a layer
    std::vector<Block> blocks_;
    std::vector<Entry> entries_;  // per vertex
};

}  // namespace ravel
