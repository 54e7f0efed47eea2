// Gates of one shape. Where tets repeat (cubes that are cut alike, lattices, layers of prisms) the
// apex beyond a gate lies as it lay beyond the last gate of that shape, its leader.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/complex.h"
#include "mesh/point3.h"
#include "walk/tet_front.h"
#include "walk/vertex_grid.h"

namespace ravel {

// A hash goes on over where a point lies, in multiples of 1 / `scale`.
inline std::uint64_t hash_of(const Point3& p, double scale, std::uint64_t hash) {
    for (const double x : p) {
        hash ^= static_cast<std::uint64_t>(whole_below(x * scale + 0.5));
        hash *= 0x9E3779B97F4A7C15u;
        hash ^= hash >> 32;
    }
    return hash;
}

struct GateShape {
    Id corner = kNone;  // the first by its place; the others follow as the gate runs
    std::uint64_t shape = 0;
};
// A gate has the shape of its edges from the first corner, and of the way from there to the apex
// behind it. `place(v)`: where a vertex is, whole numbers below 2^60.
template <class Place>
GateShape shape_of(const std::array<Id, 3>& gate, Id behind, double scale, const Place& place) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (place(gate[i]) < place(gate[first])) first = i;
    GateShape found{gate[first], 0};
    const Point3& foot = place(found.corner);
    for (const Id v : {gate[(first + 1) % 3], gate[(first + 2) % 3], behind})
        found.shape = hash_of(minus(place(v), foot), scale, found.shape);
    return found;
}

// The last gate of a shape: its first corner, and the apex beyond it. Vertices, or kNone.
struct Leader {
    Id corner = kNone, apex = kNone;
    std::uint32_t missed = 0;  // bit k: k gates of this shape ago it led astray
    std::uint64_t shape = 0;
};

// A hash of leaders by shape; a shape that is met again after another took its place has none.
class GateShapes {
  public:
    // Lengths are told apart in multiples of `step`.
    GateShapes(double step, std::size_t vertices)
        : scale_(1 / step),
          leaders_(std::bit_ceil(std::clamp(vertices, std::size_t{64}, std::size_t{1} << 16))) {}

    // Constant time.
    template <class Place>
    void enter(const std::array<Id, 3>& gate, Id behind, const Place& place) {
        const GateShape found = shape_of(gate, behind, scale_, place);
        corner_ = found.corner;
        leader_ = &leaders_[found.shape & (leaders_.size() - 1)];
        if (leader_->shape != found.shape) *leader_ = {kNone, kNone, 0, found.shape};
    }
    // Of the gate that was entered.
    Id corner() const { return corner_; }
    Leader& leader() { return *leader_; }
    void learn(Id apex) { leader_->corner = corner_, leader_->apex = apex; }
    // Where the leader has it that the apex is.
    template <class Place>
    Point3 expected(const Place& place) const {
        const Point3 way = minus(place(leader_->apex), place(leader_->corner));
        const Point3& foot = place(corner_);
        return {foot[0] + way[0], foot[1] + way[1], foot[2] + way[2]};
    }

  private:
    double scale_;
    std::vector<Leader> leaders_;
    Leader* leader_ = nullptr;
    Id corner_ = kNone;
};

// Does p lie nearer to `there` than `reach`?
inline bool lies_near(const Point3& p, const Point3& there, double reach) {
    const Point3 way = minus(p, there);
    return dot(way, way) < reach * reach;
}

// The front vertex that is nearest to a place and nearer than `reach`; of equals the oldest. None
// of the gate's, and of a crowd among the first only.
inline Id nearest_on_front(const VertexGrid& grid, const std::array<Id, 3>& gate,
                           const Point3& there, double reach) {
    constexpr std::size_t kMostLooked = 64;
    std::size_t seen = 0;
    Id best = kNone;
    double least = reach * reach;
    grid.around(there, reach, [&](Id v, const Point3& p) {
        const Point3 way = minus(p, there);
        const double d = dot(way, way);
        if (!is_in(gate, v) && (d < least || (d == least && best != kNone && v < best)))
            least = d, best = v;
        return ++seen < kMostLooked;
    });
    return best;
}

}  // namespace ravel
