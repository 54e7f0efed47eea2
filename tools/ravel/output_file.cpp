#include "ravel/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "ravel/input_file.h"
#include "ravel/interrupt.h"

namespace ravel::tool {
namespace {

namespace fs = std::filesystem;

Error unwritable(const std::string& path) {
    return {Code::unwritable, 0, path + ": " + std::strerror(errno)};
}

// Stdout, /dev/null, a named pipe: nothing there can be renamed.
bool is_stream(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return path == "-" ||
           (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

Status write_all(int file, std::span<const std::byte> bytes, const std::string& path) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return unwritable(path);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return Done{};
}

Status sync_path(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return unwritable(path.string());
    const int failed = ::fsync(file);
    ::close(file);
    // Some file systems have no fsync for folders; the rename itself is still whole.
    if (failed != 0 && errno != EINVAL) return unwritable(path.string());
    return Done{};
}

fs::path folder_of(const std::string& path) {
    const fs::path parent = fs::path(path).parent_path();
    return parent.empty() ? fs::path(".") : parent;
}

// Files of an older mesh beside the target that a reader would take for parts of the new one.
std::vector<fs::path> stale_parts(const fs::path& target, const std::vector<fs::path>& files) {
    std::vector<fs::path> stale;
    for (const std::string& ending : io::endings_together(target.string())) {
        fs::path part = target;
        part.replace_extension(ending);
        const bool is_new = std::any_of(files.begin(), files.end(), [&](const fs::path& file) {
            return file.filename() == part.filename();
        });
        std::error_code ignored;
        if (!is_new && fs::is_regular_file(part, ignored)) stale.push_back(part);
    }
    return stale;
}

Status publish(const TemporaryFolder& folder, const fs::path& target, bool force) {
    const fs::path target_folder = folder_of(target.string());
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder.path())) files.push_back(entry.path());
    const std::vector<fs::path> stale = stale_parts(target, files);
    for (const fs::path& part : stale)
        if (Status status = may_write(part.string(), force); !status) return status;
    for (const fs::path& file : files) {
        if (Status status = may_write((target_folder / file.filename()).string(), force); !status)
            return status;
        if (Status status = sync_path(file); !status) return status;
    }
    // All of them or, where a signal comes first, none.
    Status renamed = without_interruption([&]() -> Status {
        for (const fs::path& part : stale)
            if (std::remove(part.c_str()) != 0) return unwritable(part.string());
        for (const fs::path& file : files) {
            const fs::path name = target_folder / file.filename();
            if (std::rename(file.c_str(), name.c_str()) != 0) return unwritable(name.string());
        }
        return Done{};
    });
    if (!renamed) return renamed;
    return sync_path(target_folder);
}

}  // namespace

Result<TemporaryFolder> TemporaryFolder::make(const fs::path& parent) {
    auto folder = make_leftover(parent);
    if (!folder) return folder.error();
    return TemporaryFolder(std::move(*folder));
}

TemporaryFolder::~TemporaryFolder() {
    if (!path_.empty()) remove_leftover(path_);
}

Status may_write(const std::string& path, bool force) {
    std::error_code ignored;
    if (is_stream(path)) return Done{};
    if (fs::is_directory(path, ignored)) return Error{Code::unwritable, 0, path + " is a folder"};
    if (!force && fs::exists(path, ignored))
        return Error{Code::bad_option, 0, path + " exists; --force overwrites it"};
    return Done{};
}

Status write_file(const std::string& path, std::span<const std::byte> bytes) {
    const int file = path == "-"
                         ? STDOUT_FILENO
                         : ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) return unwritable(path);
    Status status = write_all(file, bytes, path);
    if (path != "-" && ::close(file) != 0 && status) status = unwritable(path);
    return status;
}

Status write_bytes_output(const std::string& path, std::span<const std::byte> bytes, bool force) {
    if (is_stream(path)) return write_file(path, bytes);
    if (Status status = may_write(path, force); !status) return status;
    auto folder = TemporaryFolder::make(folder_of(path));
    if (!folder) return folder.error();
    const fs::path name = fs::path(path).filename();
    if (Status status = write_file((folder->path() / name).string(), bytes); !status) return status;
    return publish(*folder, path, force);
}

Status write_mesh_output(const Mesh& mesh, const std::string& path, const std::string& ending,
                         const io::WriteOptions& options, bool force,
                         std::vector<std::string>* left_out) {
    const bool stream = is_stream(path);
    if (stream && ending.empty())
        return Error{Code::bad_option, 0, "a mesh to stdout needs --to ENDING, e.g. --to obj"};
    if (Status status = may_write(path, force); !status) return status;
    auto folder = TemporaryFolder::make(stream ? fs::temp_directory_path() : folder_of(path));
    if (!folder) return folder.error();
    const fs::path name = stream ? fs::path("stdout." + ending) : fs::path(path).filename();
    const std::string copy = (folder->path() / name).string();
    if (Status status = io::write_mesh(mesh, copy, options, left_out); !status) {
        // The user knows the file by its own name, not by the temporary one.
        Error error = status.error();
        const std::size_t at = error.detail.find(copy);
        if (at != std::string::npos) error.detail.replace(at, copy.size(), path);
        return error;
    }
    if (!stream) return publish(*folder, path, force);
    auto bytes = read_bytes(copy);
    if (!bytes) return bytes.error();
    return write_file(path, *bytes);
}

}  // namespace ravel::tool
