// Codes the position of each new vertex where the walk meets it, on either side: `Coder` writes or
// reads flags and plain bits (see code_residual). Grid coordinates are integers; lossless ones are
// float images, guessed in IEEE double from the exact values.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "mesh/point3.h"
#include "predict/float_image.h"
#include "predict/grid.h"
#include "predict/predictor.h"
#include "predict/residual_context.h"

namespace ravel {

struct PositionFormat {
    bool grid = false;
    bool narrow = true;         // float32
    bool has_outliers = false;  // grid: some vertices are stored bit for bit instead
    int coarseness = 0;         // of residual contexts
    Weights weights = kDefaultWeights;
    // Lossless tets: the integers that stand for the floats where the walk asks for places.
    Point3 place_origin{};
    double place_scale = 1;
};

// Grid: int64 values. Lossless and outliers: the bits of the floats.
using Position = std::array<std::uint64_t, 3>;

inline double double_of(std::uint64_t bits, bool narrow) {
    return narrow ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                  : std::bit_cast<double>(bits);
}

// Where a vertex is, in integers: the grid's, or the nearest of 2^20 + 1 steps along each axis.
inline Point3 place_of(const PositionFormat& format, const Position& position) {
    Point3 place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (format.grid) {
            place[axis] = static_cast<double>(static_cast<std::int64_t>(position[axis]));
            continue;
        }
        const double x = double_of(position[axis], format.narrow);
        const double scaled = (x - format.place_origin[axis]) * format.place_scale;
        place[axis] = scaled > 0 ? std::floor(std::min(scaled, 0x1p20) + 0.5) : 0;
    }
    return place;
}

template <class Coder>
class PositionCodes {
  public:
    PositionCodes(Coder& coder, const PositionFormat& format)
        : coder_(coder), format_(format), sizes_(format.coarseness) {}

    void reserve(std::size_t vertices) {
        values_.reserve(vertices);
        sizes_.reserve(vertices);
    }

    // False: a value no encoder writes.
    bool next(const Stencil& stencil, const Position& truth, bool outlier) {
        if (format_.has_outliers) {
            outlier = coder_.flag(ResidualContexts::outlier.at(0), outlier);
            outliers_.push_back(outlier);
            if (outlier) {
                Position bits{};
                for (std::size_t axis = 0; axis < 3; ++axis)
                    bits[axis] = coder_.plain(truth[axis], format_.narrow ? 32 : 64);
                raw_.push_back(bits);
                Position stand_in{};
                if (stencil.at[0] != kNone) stand_in = values_[stencil.at[0]];
                values_.push_back(stand_in);
                sizes_.push(sizes_.expected(stencil) / 2);
                return true;
            }
        }
        std::uint32_t expected = sizes_.expected(stencil), sum = 0;
        Position value{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::uint32_t context = sizes_.context(expected);
            std::uint32_t size = 0;
            if (format_.grid) {
                const std::int64_t g = guess_grid(stencil, axis);
                const std::int64_t r = code_residual(
                    coder_, context, static_cast<std::int64_t>(truth[axis]) - g, size);
                // A file may hold any residual: the sum wraps.
                const auto q = static_cast<std::int64_t>(static_cast<std::uint64_t>(g) +
                                                         static_cast<std::uint64_t>(r));
                if (q >= kMostGrid || q <= -kMostGrid) {
                    values_.push_back({});
                    sizes_.push(0);
                    return false;
                }
                value[axis] = static_cast<std::uint64_t>(q);
            } else {
                const std::uint64_t g = guess_image(stencil, axis);
                const std::int64_t r =
                    code_residual(coder_, context,
                                  wrapped_difference(image(truth[axis]), g, format_.narrow), size);
                value[axis] = bits(g + static_cast<std::uint64_t>(r));
            }
            sum += size;
            expected = (expected + 2 * size + 1) / 2;
        }
        values_.push_back(value);
        sizes_.push((sum + 1) / 3);
        return true;
    }

    // A vertex at the place of an earlier one.
    void copy(Id of) {
        const Position value = values_[of];
        values_.push_back(value);
        sizes_.push(0);
        if (format_.has_outliers) outliers_.push_back(false);
    }

    const PositionFormat& format() const { return format_; }
    const std::vector<Position>& values() const { return values_; }
    // Per vertex, where there are any at all; the bits in the order of the vertices.
    const std::vector<bool>& outliers() const { return outliers_; }
    const std::vector<Position>& outlier_bits() const { return raw_; }

  private:
    std::uint64_t image(std::uint64_t b) const {
        return format_.narrow ? image_of(static_cast<std::uint32_t>(b)) : image_of(b);
    }
    std::uint64_t bits(std::uint64_t i) const {
        return format_.narrow ? bits32_of(i) : bits64_of(i);
    }
    double as_double(std::uint64_t b) const { return double_of(b, format_.narrow); }

    std::int64_t guess_grid(const Stencil& stencil, std::size_t axis) const {
        const auto f = features_of<std::int64_t>(
            stencil.configuration,
            [&](std::size_t i) { return static_cast<std::int64_t>(values_[stencil.at[i]][axis]); },
            [&](std::size_t i) { return stencil.at[i] != kNone; });
        const std::int64_t g = guess(stencil.configuration, f, format_.weights);
        return std::clamp(g, -kMostGrid, kMostGrid);
    }

    std::uint64_t guess_image(const Stencil& stencil, std::size_t axis) const {
        const auto f = features_of<double>(
            stencil.configuration,
            [&](std::size_t i) { return as_double(values_[stencil.at[i]][axis]); },
            [&](std::size_t i) { return stencil.at[i] != kNone; });
        double g = guess(stencil.configuration, f, format_.weights);
        if (!std::isfinite(g)) {
            if (stencil.at[0] != kNone) return image(values_[stencil.at[0]][axis]);
            g = 0;
        }
        if (!format_.narrow) return image(std::bit_cast<std::uint64_t>(g));
        constexpr double kMost = std::numeric_limits<float>::max();
        return image(
            std::bit_cast<std::uint32_t>(static_cast<float>(std::clamp(g, -kMost, kMost))));
    }

    Coder& coder_;
    const PositionFormat format_;
    ResidualSizes sizes_;
    std::vector<Position> values_;
    std::vector<bool> outliers_;
    std::vector<Position> raw_;
};

inline constexpr std::size_t kConfigurations = static_cast<std::size_t>(Configuration::count);

}  // namespace ravel
