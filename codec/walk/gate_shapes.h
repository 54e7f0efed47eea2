// Gates of one shape: where tets repeat (cubes that are cut alike, lattices, layers of prisms) the
// last gate of a shape may lead the next (see Leaders).
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
    std::size_t first = 0;  // the first corner by its place; the others follow as the gate runs
    std::uint64_t shape = 0;
};
// A gate has the shape of its edges from the first corner, and of the way from there to the apex
// behind it. `place(v)`: where a vertex is, whole numbers below 2^60.
template <class Place>
GateShape shape_of(const std::array<Id, 3>& gate, Id behind, double scale, const Place& place) {
    GateShape found;
    for (std::size_t i = 1; i < 3; ++i)
        if (place(gate[i]) < place(gate[found.first])) found.first = i;
    const Point3& foot = place(gate[found.first]);
    for (const Id v : {gate[(found.first + 1) % 3], gate[(found.first + 2) % 3], behind})
        found.shape = hash_of(minus(place(v), foot), scale, found.shape);
    return found;
}

// A gate that another is likened to: its facet, the corner of the cell before it that is opposite;
// and the other corners of that cell in the order of those of the gate that it leads.
struct Leader {
    Id facet = kNone;
    std::array<Id, 3> corner{};
};

// The last gate of each shape. A hash: a shape that is met again after another took its place has
// none.
class GateShapes {
  public:
    // Lengths are told apart in multiples of `step`.
    GateShapes(double step, std::size_t vertices)
        : scale_(1 / step),
          last_(std::bit_ceil(std::clamp(vertices, std::size_t{64}, std::size_t{1} << 16))) {}

    struct Last {
        Leader leader;
        std::uint32_t missed = 0;  // bit k: k gates of this shape ago it led astray
        std::uint64_t shape = 0;
    };
    // The entry of a shape, from now on this gate's; `leader` becomes the gate that had it.
    // `own` is the gate as it will lead others. Constant time.
    template <class Place>
    Last& enter(const std::array<Id, 3>& gate, Id behind, const Leader& own, Leader& leader,
                const Place& place) {
        const GateShape found = shape_of(gate, behind, scale_, place);
        Last& last = last_[found.shape & (last_.size() - 1)];
        if (last.shape != found.shape) last = {{}, 0, found.shape};
        leader.facet = last.leader.facet;
        last.leader.facet = own.facet;
        for (std::size_t i = 0; i < 3; ++i) {
            leader.corner[(found.first + i) % 3] = last.leader.corner[i];
            last.leader.corner[i] = own.corner[(found.first + i) % 3];
        }
        return last;
    }

  private:
    double scale_;
    std::vector<Last> last_;
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
