// Mesh files of other programs, chosen by ending: OBJ OFF PLY STL, Gmsh MSH, MEDIT .mesh, legacy
// VTK, VTU, TetGen .node/.ele(/.face/.edge). Nothing is repaired, merged, dropped or rounded on the
// way.
#pragma once

#include <string>
#include <vector>

#include "ravel/mesh.h"
#include "ravel/result.h"

namespace ravel::io {

// Errors carry one line "FILE:LINE: what is wrong" (text) or "FILE: byte N: what is wrong"
// (binary).
Result<Mesh> read_mesh(const std::string& path);

struct WriteOptions {
    bool binary =
        false;  // where a format has both; text otherwise (PLY, STL, MSH, VTK; VTU: appended zlib)
};

// Writes to exactly this path (the caller makes it atomic). `unwritable` where the format can't
// hold what the mesh holds is only for cells and points; data that a format has no place for is
// reported in `left_out`, one sentence each.
Status write_mesh(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                  std::vector<std::string>* left_out = nullptr);

// Where a mesh is several files of one stem (TetGen), the endings of all that a reader of `path`
// would take for its parts; empty for other formats.
std::vector<std::string> endings_together(const std::string& path);

// Endings that can be read and written, for help texts: "obj", "off", ...
std::vector<std::string> known_endings();

}  // namespace ravel::io
