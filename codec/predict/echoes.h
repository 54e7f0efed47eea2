// Vertices that stand where an earlier one stood, once mirrored or moved: artists' meshes are
// symmetric, and parts are repeated. The earlier vertex is looked for near the place from which the
// guess would have come.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/context.h"
#include "mesh/point3.h"

namespace ravel {

// Axis k of the echo is offset[k] + axis k of the earlier vertex, or offset[k] - it.
struct Echo {
    std::array<bool, 3> mirrored{};
    std::array<std::int64_t, 3> offset{};

    bool operator==(const Echo&) const = default;

    bool moves_only() const { return !mirrored[0] && !mirrored[1] && !mirrored[2]; }
    Point3 back(const Point3& p) const {
        Point3 out;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto o = static_cast<double>(offset[k]);
            out[k] = mirrored[k] ? o - p[k] : p[k] - o;
        }
        return out;
    }
};
inline constexpr std::size_t kMostEchoes = 8;
inline constexpr int kMostCubeBits = 52;

// Vertices by cubes of side 2^cube_bits, hashed. A look takes 8 or 27 cubes, at most 12 vertices
// each; vertices of other cubes with the same hash are among them, so the hash is part of the
// format.
class VertexIndex {
  public:
    VertexIndex(int cube_bits, double reach, std::size_t vertices)
        : reach_(reach),
          scale_(std::ldexp(1.0, -cube_bits)),
          side_(std::ldexp(1.0, cube_bits)),
          heads_(std::bit_ceil(std::clamp(vertices, std::size_t{16}, std::size_t{1} << 24)),
                 ~Id{0}) {}

    double side() const { return side_; }
    void reserve(std::size_t vertices) { next_.reserve(vertices); }

    void insert(const Point3& p) {
        std::uint64_t hash = 0;
        for (std::size_t k = 0; k < 3; ++k)
            hash ^= static_cast<std::uint64_t>(cube(p[k] * scale_)) * kFactor[k];
        Id& head = heads_[slot(hash)];
        next_.push_back(head);
        head = static_cast<Id>(next_.size() - 1);
    }

    // The nearest vertex by the sum over the axes, and that sum, below `reach` sides of a cube.
    struct Near {
        std::uint32_t vertex = ~std::uint32_t{0};
        double distance = 0;
    };
    Near nearest(const Point3& p, const std::vector<Point3>& values) const {
        Near best;
        best.distance = side_ * reach_;
        std::array<std::array<std::uint64_t, 3>, 3> parts;  // of the hash, per axis and step
        std::array<std::size_t, 3> steps;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t low = cube(p[k] * scale_ - reach_);
            // Where doubles are wider apart than cubes, four or five would lie between.
            const std::int64_t high = std::min(cube(p[k] * scale_ + reach_), low + 2);
            steps[k] = static_cast<std::size_t>(high - low) + 1;
            for (std::size_t i = 0; i < steps[k]; ++i)
                parts[k][i] = (static_cast<std::uint64_t>(low) + i) * kFactor[k];
        }
        // The first of each cube that has any: none of them waits for what is found in another.
        std::array<Id, 27> first;
        std::size_t count = 0;
        for (std::size_t z = 0; z < steps[2]; ++z)
            for (std::size_t y = 0; y < steps[1]; ++y)
                for (std::size_t x = 0; x < steps[0]; ++x) {
                    first[count] = heads_[slot(parts[0][x] ^ parts[1][y] ^ parts[2][z])];
                    count += first[count] != ~Id{0};
                }
        for (std::size_t i = 0; i < count; ++i) {
            Id v = first[i];
            for (int looks = 0; v != ~Id{0} && looks < 12; ++looks, v = next_[v]) {
                const Point3& q = values[v];
                const double d =
                    std::abs(q[0] - p[0]) + std::abs(q[1] - p[1]) + std::abs(q[2] - p[2]);
                if (d < best.distance) best = {v, d};
            }
        }
        return best;
    }

  private:
    using Id = std::uint32_t;
    static constexpr std::array<std::uint64_t, 3> kFactor{0x9E3779B97F4A7C15u, 0xC2B2AE3D27D4EB4Fu,
                                                          0x165667B19E3779F9u};

    static std::int64_t cube(double x) { return whole_below(std::clamp(x, -0x1p60, 0x1p60)); }
    std::size_t slot(std::uint64_t hash) const {
        return static_cast<std::size_t>(hash >> 32) & (heads_.size() - 1);
    }

    double reach_, scale_, side_;
    std::vector<Id> heads_, next_;
};

}  // namespace ravel
