// Tets as quadratic ones.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "predict/edge_points.h"
#include "ravel/mesh.h"

namespace ravel::test {

// A point in the middle of every edge of tets with float positions, every `astray`-th of which is
// elsewhere; and one that no cell has. The tets come from last to first. No attributes.
inline Mesh with_edge_nodes(const Mesh& mesh, Index astray) {
    std::vector<Id> points(mesh.point_count());
    std::iota(points.begin(), points.end(), Id{0});
    const EdgePoints edges = edge_points_of(mesh.corners, points);
    Mesh out = mesh;
    out.attributes.clear();
    const Index first = mesh.point_count() + 1;
    out.positions = make_array(mesh.positions.scalar, 3, first + edges.end.size());
    std::copy(mesh.positions.bytes.begin(), mesh.positions.bytes.end(),
              out.positions.bytes.begin());
    const auto x = out.positions.as<float>();
    for (std::size_t e = 0; e < edges.end.size(); ++e)
        for (std::size_t k = 0; k < 3; ++k)
            x[3 * (first + e) + k] = (x[3 * edges.end[e][0] + k] + x[3 * edges.end[e][1] + k]) / 2 +
                                     (astray != 0 && e % astray == 0 ? 0.01f : 0.0f);
    CompanionBlock block{24, 6, mesh.cell_count(), {}, {}};
    for (Index c = mesh.cell_count(); c-- > 0;) {
        block.hosts.push_back(c);
        for (std::size_t k = 0; k < 6; ++k) block.nodes.push_back(first + edges.of[6 * c + k]);
    }
    out.companions.push_back(std::move(block));
    return out;
}

}  // namespace ravel::test
