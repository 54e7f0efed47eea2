// One pair of functions per file format; `read_mesh` and `write_mesh` choose among them by ending.
// Readers trust nothing: counts are bounded by the bytes left before memory is asked for. Writers
// get meshes that fulfil their invariants.
#pragma once

#include <string>
#include <vector>

#include "io/mesh_io.h"

namespace ravel::io {

using Sentences = std::vector<std::string>;

Result<Mesh> read_obj(const std::string& path);
Status write_obj(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                 Sentences* left_out);

Result<Mesh> read_off(const std::string& path);
Status write_off(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                 Sentences* left_out);

Result<Mesh> read_ply(const std::string& path);
Status write_ply(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                 Sentences* left_out);

Result<Mesh> read_stl(const std::string& path);
Status write_stl(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                 Sentences* left_out);

Result<Mesh> read_medit(const std::string& path);
Status write_medit(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                   Sentences* left_out);

// `path` is any of the family's files; the others are looked for beside it.
Result<Mesh> read_tetgen(const std::string& path);
Status write_tetgen(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                    Sentences* left_out);

Result<Mesh> read_msh(const std::string& path);
Status write_msh(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                 Sentences* left_out);

Result<Mesh> read_vtk(const std::string& path);
Status write_vtk(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                 Sentences* left_out);

Result<Mesh> read_vtu(const std::string& path);
Status write_vtu(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                 Sentences* left_out);

}  // namespace ravel::io
