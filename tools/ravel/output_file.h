// Outputs appear whole or not at all: they are written into a hidden folder beside their place,
// then renamed. "-" is stdout, and a device or pipe is written to as it is.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/mesh_io.h"
#include "ravel/result.h"

namespace ravel::tool {

// Removed with everything in it when the object goes, or a signal ends the program.
class TemporaryFolder {
  public:
    static Result<TemporaryFolder> make(const std::filesystem::path& parent);
    TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::move(other.path_)) {
        other.path_.clear();
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(TemporaryFolder&&) = delete;
    ~TemporaryFolder();

    const std::filesystem::path& path() const { return path_; }

  private:
    explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)) {}
    std::filesystem::path path_;
};

// Fails with bad_option where the path exists and `force` is not given. Ask before long work.
Status may_write(const std::string& path, bool force);

// Plain write, neither atomic nor careful.
Status write_file(const std::string& path, std::span<const std::byte> bytes);

Status write_bytes_output(const std::string& path, std::span<const std::byte> bytes, bool force);

// `ending` is the format for stdout; files tell it by their name. Formats of several files (TetGen)
// appear all or none.
Status write_mesh_output(const Mesh& mesh, const std::string& path, const std::string& ending,
                         const io::WriteOptions& options, bool force,
                         std::vector<std::string>* left_out);

}  // namespace ravel::tool
