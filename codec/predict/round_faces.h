// The round faces of a mesh, and which of its vertices lie on them.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/stencil.h"
#include "predict/border_plane.h"
#include "predict/round_face.h"

namespace ravel {

class RoundFaces {
  public:
    RoundFaces() = default;
    explicit RoundFaces(const RoundFaceList& faces)
        : count_(faces.count), near_(std::ldexp(1.0, faces.slack)) {
        for (std::size_t f = 0; f < count_; ++f) shapes_[f] = shape_of(faces.face[f]);
    }

    const RoundShape& operator[](std::size_t face) const { return shapes_[face]; }

    bool holds(std::size_t face, const Point3& p) const {
        return std::abs(outside_of(shapes_[face], p).distance) < near_;
    }
    void reserve(std::size_t vertices) {
        if (count_ > 0) on_.reserve(vertices);
    }
    // Once per vertex, in order.
    void insert(const Point3& p) {
        if (count_ == 0) return;
        std::uint32_t on = 0;
        for (std::size_t f = 0; f < count_; ++f) on |= std::uint32_t{holds(f, p)} << f;
        on_.push_back(on);
    }
    // The first face on which all of a `border` stencil's triangle lies, or kNone.
    Id of(const Stencil& border) const {
        if (count_ == 0) return kNone;
        const std::uint32_t on = on_[border.at[0]] & on_[border.at[1]] & on_[border.at[2]];
        return on == 0 ? kNone : static_cast<Id>(std::countr_zero(on));
    }
    // Does a new vertex lie along a `border` stencil's triangle? See ravel::lies_along.
    bool lies_along(const Stencil& border, Id face, const std::vector<Point3>& values,
                    const Point3& value) const {
        return face != kNone ? holds(face, value) : ravel::lies_along(border, values, value);
    }

  private:
    std::size_t count_ = 0;
    double near_ = 1;
    std::array<RoundShape, kMostRoundFaces> shapes_{};
    std::vector<std::uint32_t> on_;  // per vertex, a bit per face
};

// What a new vertex is likely to be guessed by: the first border along which it lies, or none.
inline Stencil stencil_along(const Stencil& met, const std::vector<Point3>& values,
                             const Point3& value, const RoundFaces& faces) {
    for (std::size_t e = 0; e < 3; ++e) {
        if ((met.borders >> e & 1) == 0) continue;
        const Stencil border = along_border(met, e);
        if (off_plane(border, values, value).normal_square > 0 &&
            faces.lies_along(border, faces.of(border), values, value))
            return border;
    }
    return met;
}

}  // namespace ravel
