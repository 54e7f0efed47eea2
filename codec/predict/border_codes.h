// Vertices of tets that go on with a border: whether one does, and on what it then lies, which
// tells one coordinate from the other two. That is a round face where the border's triangle lies on
// one, the triangle's plane otherwise. On either side: `Coder` writes or reads flags.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "predict/border_plane.h"
#include "predict/position_format.h"
#include "predict/residual_context.h"
#include "predict/round_faces.h"

namespace ravel {

template <class Coder>
class BorderCodes {
  public:
    BorderCodes(Coder& coder, const PositionFormat& format)
        : coder_(coder), faces_(format.rounds) {}

    void reserve(std::size_t vertices) { faces_.reserve(vertices); }
    // Once per vertex, in order.
    void insert(const Point3& value) { faces_.insert(value); }

    // Does the vertex go on with one of the borders beside its gate? `truth()`: the writer's value.
    template <class Truth>
    bool next(const Stencil& tet, const std::vector<Point3>& values, const Truth& truth) {
        std::uint32_t asked = 0;
        for (std::size_t e = 0; e < 3; ++e) {
            if ((tet.borders >> e & 1) == 0) continue;
            stencil_ = along_border(tet, e);
            plane_ = BorderPlane(stencil_, values);
            if (!plane_.exists()) continue;
            face_ = faces_.of(stencil_);
            bool along = false;
            if constexpr (Coder::kWrites)
                along = faces_.lies_along(stencil_, face_, values, truth());
            const ContextBlock& block =
                face_ == kNone ? ResidualContexts::along : ResidualContexts::along_round;
            if (coder_.flag(block.at(asked++, plane_.opening()), along)) return true;
        }
        return false;
    }

    // Would a round face, or a plane to a unit, tell a coordinate of it? For the writer.
    bool tells(const Stencil& tet, const std::vector<Point3>& values, const Point3& truth) const {
        for (std::size_t e = 0; e < 3; ++e) {
            if ((tet.borders >> e & 1) == 0) continue;
            const Stencil border = along_border(tet, e);
            const OffPlane off = off_plane(border, values, truth);
            if (!(off.normal_square > 0)) continue;
            const Id face = faces_.of(border);
            if (face != kNone ? faces_.holds(face, truth)
                              : off.distance * off.distance < off.normal_square)
                return true;
        }
        return false;
    }

    // Of a vertex that does: its stencil,
    const Stencil& stencil() const { return stencil_; }
    // its guess, moved onto the round face if there is one; that chooses the axes,
    Point3 laid(const Point3& guess) {
        if (face_ == kNone) {
            axes_ = plane_.axes();
            return guess;
        }
        const Point3 moved = moved_onto(faces_[face_], guess);
        axes_ = axes_across(outside_of(faces_[face_], moved).way);
        return moved;
    }
    // the axes in the order in which they are coded,
    const std::array<std::size_t, 3>& axes() const { return axes_; }
    // and the last coordinate, the others of `value` being known.
    double carried(const Point3& guess, Point3 value) const {
        if (face_ == kNone) return plane_.carried(guess, value);
        value[axes_[2]] = guess[axes_[2]];
        return coordinate_on(faces_[face_], value, axes_[2]);
    }

  private:
    Coder& coder_;
    RoundFaces faces_;
    Stencil stencil_;
    BorderPlane plane_;
    Id face_ = kNone;
    std::array<std::size_t, 3> axes_{};
};

}  // namespace ravel
