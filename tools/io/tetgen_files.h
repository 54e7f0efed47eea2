// The files of one TetGen mesh: X.node X.ele X.face X.edge.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace ravel::io {

inline constexpr std::uint16_t kTetgenEdgeNodes = 24;
inline constexpr std::uint16_t kTetgenTriangle = 5, kTetgenTriangle6 = 22;
inline constexpr std::uint16_t kTetgenLine = 3, kTetgenLine3 = 21;

// Where VTK's edge node k (of edges 01 12 20 03 13 23) stands among TetGen's six, which it makes in
// the order of its own edge table: 23 03 01 12 13 02.
inline constexpr std::array<std::size_t, 6> kTetgenOfVtk = {2, 3, 5, 1, 4, 0};

struct TetgenPaths {
    std::string node, ele, face, edge;
};

TetgenPaths tetgen_paths(const std::string& path);

}  // namespace ravel::io
