#include "ravel/input_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "io/mesh_io.h"
#include "ravel/output_file.h"
#include "ravel/talk.h"

namespace ravel::tool {
namespace {

// An empty file is an empty mesh in most formats; that is seldom what somebody meant.
Result<Mesh> with_remark(const std::string& name, Result<Mesh> mesh) {
    if (mesh && mesh->point_count() == 0 && mesh->cell_count() == 0)
        remark(name + " holds no points and no cells");
    return mesh;
}

Error unreadable(std::string detail) {
    return {Code::unreadable, 0, std::move(detail)};
}

}  // namespace

Result<std::vector<std::byte>> read_bytes(const std::string& path) {
    std::error_code ignored;
    if (path != "-" && std::filesystem::is_directory(path, ignored))
        return unreadable(path + " is a folder");
    struct Closer {
        void operator()(std::FILE* file) const {
            if (file != stdin) std::fclose(file);
        }
    };
    const std::unique_ptr<std::FILE, Closer> file(path == "-" ? stdin
                                                              : std::fopen(path.c_str(), "rb"));
    if (!file) return unreadable(path + ": " + std::strerror(errno));
    std::vector<std::byte> bytes;
    std::size_t size = 0;
    while (true) {
        bytes.resize(size + (size < (1u << 20) ? (1u << 16) : size / 2));
        const std::size_t got = std::fread(bytes.data() + size, 1, bytes.size() - size, file.get());
        size += got;
        if (got == 0) break;
    }
    if (std::ferror(file.get())) return unreadable(path + ": " + std::strerror(errno));
    bytes.resize(size);
    return bytes;
}

Result<Mesh> read_mesh_input(const std::string& path, const std::string& ending) {
    if (path != "-") return with_remark(path, io::read_mesh(path));
    if (ending.empty())
        return Error{Code::bad_option, 0, "a mesh from stdin needs --from ENDING, e.g. --from obj"};
    auto bytes = read_bytes(path);
    if (!bytes) return bytes.error();
    // The readers want a seekable file.
    auto folder = TemporaryFolder::make(std::filesystem::temp_directory_path());
    if (!folder) return folder.error();
    const std::string copy = (folder->path() / ("stdin." + ending)).string();
    if (Status status = write_file(copy, *bytes); !status) return status.error();
    return with_remark("stdin", io::read_mesh(copy));
}

bool is_ravel_name(const std::string& path) {
    return std::filesystem::path(path).extension() == ".ravel";
}

}  // namespace ravel::tool
