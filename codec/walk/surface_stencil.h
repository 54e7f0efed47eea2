// What the walk over surfaces knows around a new vertex.
#pragma once

#include <algorithm>

#include "mesh/stencil.h"
#include "walk/walk.h"

namespace ravel {

// The vertices beyond both ends of a visited cell's side (front facet), or none.
struct Beyond {
    Id start = kNone, end = kNone;  // of the side as the new cell runs along it
};
inline Beyond beyond(const Walked& walked, Id facet) {
    const Id across = walked.next_in_cell(walked.next_in_cell(facet));
    return {walked.vertex[across], walked.vertex[walked.prev_in_cell(facet)]};
}
// One cell further, where the cell is a quad that was entered or zipped on the far side too.
inline Beyond far_beyond(const Walked& walked, Id facet) {
    if (walked.degree(walked.cell_of(facet)) != 4) return {};
    const Id opposite = walked.next_in_cell(walked.next_in_cell(facet));
    const Id twin = walked.twin[opposite];
    return twin == kNone ? Beyond{} : beyond(walked, twin);
}

// Of the new vertex at corner i of the cell of degree n whose corners start at `base`; its sides up
// to `right_end` and from `left_end` on have zipped.
inline Stencil surface_stencil(const Walked& walked, Id base, Id n, Id i, Id right_end,
                               Id left_end) {
    const auto& vertex = walked.vertex;
    const Id a = vertex[base], b = vertex[base + 1];
    const Id g = walked.twin[base];
    const Beyond u = beyond(walked, g);
    if (n == 4) {
        const Beyond w = far_beyond(walked, g);
        if (right_end == 2) {  // side 1 zipped: corner 3 is new
            const Id t = walked.twin[base + 1];
            const Beyond v = beyond(walked, t), x = far_beyond(walked, t);
            return stencil_of(Configuration::quad_corner,
                              {a, vertex[base + 2], b, u.start, u.end, w.start, w.end, v.end,
                               v.start, x.end, x.start});
        }
        if (left_end == 3) {  // side 3 zipped: corner 2 is new; the mirror image
            const Id t = walked.twin[base + 3];
            const Beyond v = beyond(walked, t), x = far_beyond(walked, t);
            return stencil_of(Configuration::quad_corner,
                              {b, vertex[base + 3], a, u.end, u.start, w.end, w.start, v.start,
                               v.end, x.start, x.end});
        }
        if (i == 2)
            return stencil_of(Configuration::quad_third, {b, a, u.end, u.start, w.end, w.start});
        return stencil_of(Configuration::quad_fourth,
                          {a, vertex[base + 2], b, u.start, u.end, w.start, w.end});
    }
    const Id z = i + 1 < n ? vertex[base + i + 1] : a;
    return stencil_of(Configuration::polygon, {vertex[base + i - 1], vertex[base + i - 2],
                                               i >= 3 ? vertex[base + i - 3] : u.start, z});
}

// Of the new vertex of a triangle, between the front facets `before` and `after` the gate's. The
// more cells there are around an end of the gate (`around_a`, `around_b`), the more the next
// vertex of the front tells: four leave room for two more in a regular mesh. The end with more of
// them comes first as b, in a mirror image if need be.
inline Stencil triangle_stencil(const Walked& walked, Id base, Id before, Id after,
                                std::uint32_t around_a, std::uint32_t around_b) {
    const auto class_of = [](std::uint32_t around) -> std::uint32_t {
        return std::clamp<std::uint32_t>(around, 2, 5) - 2;
    };
    const Id a = walked.vertex[base], b = walked.vertex[base + 1];
    const Id x = walked.vertex[walked.next_in_cell(before)], y = walked.vertex[after];
    const Beyond u = beyond(walked, walked.twin[base]);
    const Id v_y = beyond(walked, after).start, u_x = beyond(walked, before).end;
    const std::uint32_t of_a = class_of(around_a), of_b = class_of(around_b);
    Stencil stencil =
        of_b < of_a ? stencil_of(Configuration::triangle, {b, a, u.end, u.start, x, y, u_x, v_y})
                    : stencil_of(Configuration::triangle, {a, b, u.start, u.end, y, x, v_y, u_x});
    const std::uint32_t high = std::max(of_a, of_b), low = std::min(of_a, of_b);
    stencil.variant = static_cast<std::uint8_t>(high * (high + 1) / 2 + low);
    return stencil;
}

}  // namespace ravel
