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

    // Looks at the border across edge e of the gate, in passes over e from 0 up; 0 begins one.
    // False: nothing can be asked about it.
    bool meet(const Stencil& tet, std::size_t e, const std::vector<Point3>& values) {
        if (e == 0) asked_ = 0;
        if ((tet.borders >> e & 1) == 0) return false;
        stencil_ = along_border(tet, e);
        plane_ = BorderPlane(stencil_, values);
        if (!plane_.exists()) return false;
        face_ = faces_.of(stencil_);
        const ContextBlock& block =
            face_ == kNone ? ResidualContexts::along : ResidualContexts::along_round;
        context_ = block.at(asked_++, plane_.opening());
        return true;
    }
    // The flag that says whether the vertex goes on with the border that was met last.
    Context context() const { return context_; }
    // Does it go on with any? If so, that is the one met last. `truth`: the writer's edge, or any
    // other number for none.
    bool next(const Stencil& tet, const std::vector<Point3>& values, std::size_t truth) {
        for (std::size_t e = 0; e < 3; ++e)
            if (meet(tet, e, values) && coder_.flag(context_, e == truth)) return true;
        return false;
    }

    // Of a vertex that goes on with that border: its stencil,
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
    Context context_ = 0;
    std::uint32_t asked_ = 0;  // flags about the vertex
    std::array<std::size_t, 3> axes_{};
};

}  // namespace ravel
