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
        const Range x = range(centre, radius, 0), y = range(centre, radius, 1),
                    z = range(centre, radius, 2);
        if (x.blocks() * y.blocks() * z.blocks() > kMostBlocks) return;
        for (std::size_t k = z.first; k <= z.last; ++k) {
            const std::uint64_t in_z = z.of(k);
            for (std::size_t j = y.first; j <= y.last; ++j) {
                const std::uint64_t in_y = in_z & y.of(j);
                const Block* row = blocks_.data() + k * layer_ + j * row_;
                for (std::size_t i = x.first; i <= x.last; ++i) {
                    const Block& block = row[i];
                    for (std::uint64_t cubes = block.filled & in_y & x.of(i); cubes != 0;
                         cubes &= cubes - 1) {
                        Id v = block.head[static_cast<std::size_t>(std::countr_zero(cubes))];
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
    // The cubes of a block from its step i on (the last four), or up to it (the first four), along
    // each axis.
    using Masks = std::array<std::uint64_t, 8>;
    static constexpr std::array<Masks, 3> kMasks = [] {
        std::array<Masks, 3> masks{};
        for (unsigned bit = 0; bit < 64; ++bit)
            for (unsigned axis = 0; axis < 3; ++axis)
                for (unsigned i = 0; i < 4; ++i) {
                    const unsigned step = bit >> 2 * axis & 3;
                    const std::uint64_t cube = std::uint64_t{1} << bit;
                    if (step <= i) masks[axis][i] |= cube;
                    if (step >= i) masks[axis][4 + i] |= cube;
                }
        return masks;
    }();
    // Blocks along an axis, and which of their cubes are within.
    struct Range {
        std::uint32_t first, last;
        std::uint64_t from, up_to;
        std::uint64_t blocks() const { return last - first + std::uint64_t{1}; }
        std::uint64_t of(std::size_t block) const {
            return (block == first ? from : ~std::uint64_t{0}) &
                   (block == last ? up_to : ~std::uint64_t{0});
        }
    };
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

    Range range(const Point3& centre, double radius, std::size_t axis) const {
        const std::uint32_t low = step(centre[axis] - radius, axis),
                            high = step(centre[axis] + radius, axis);
        return {low >> 2, high >> 2, kMasks[axis][4 + (low & 3)], kMasks[axis][high & 3]};
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
