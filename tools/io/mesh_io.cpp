#include "io/mesh_io.h"

#include <array>
#include <string_view>

#include "io/formats.h"
#include "io/text_reader.h"

namespace ravel::io {

namespace {

struct Format {
    std::string_view ending;
    Result<Mesh> (*read)(const std::string& path);
    Status (*write)(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                    Sentences* left_out);
};

constexpr std::array kFormats = {
    Format{"obj", read_obj, write_obj},        Format{"off", read_off, write_off},
    Format{"ply", read_ply, write_ply},        Format{"stl", read_stl, write_stl},
    Format{"msh", read_msh, write_msh},        Format{"mesh", read_medit, write_medit},
    Format{"vtk", read_vtk, write_vtk},        Format{"vtu", read_vtu, write_vtu},
    Format{"node", read_tetgen, write_tetgen}, Format{"ele", read_tetgen, write_tetgen},
};

const Format* format_of(const std::string& path) {
    const std::size_t name = path.find_last_of("/\\");
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos || (name != std::string::npos && dot < name)) return nullptr;
    const std::string ending = lower_case(std::string_view(path).substr(dot + 1));
    for (const Format& format : kFormats)
        if (format.ending == ending) return &format;
    return nullptr;
}

std::string unknown_ending(const std::string& path) {
    std::string sentence = path + ": the ending names no known format; known are";
    for (const Format& format : kFormats) sentence += " ." + std::string(format.ending);
    return sentence;
}

}  // namespace

Result<Mesh> read_mesh(const std::string& path) {
    const Format* format = format_of(path);
    if (!format) return Error{Code::unreadable, 0, unknown_ending(path)};
    Result<Mesh> mesh = format->read(path);
    if (mesh)
        if (Status status = check_mesh(*mesh); !status)
            return Error{Code::unreadable, 0, path + ": " + status.error().detail};
    return mesh;
}

Status write_mesh(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                  std::vector<std::string>* left_out) {
    const Format* format = format_of(path);
    if (!format) return Error{Code::unwritable, 0, unknown_ending(path)};
    if (Status status = check_mesh(mesh); !status) return status;
    return format->write(mesh, path, options, left_out);
}

std::vector<std::string> endings_together(const std::string& path) {
    const Format* format = format_of(path);
    if (!format || format->read != read_tetgen) return {};
    return {"node", "ele", "face", "edge"};
}

std::vector<std::string> known_endings() {
    std::vector<std::string> endings;
    for (const Format& format : kFormats) endings.emplace_back(format.ending);
    return endings;
}

}  // namespace ravel::io
