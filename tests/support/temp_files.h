// Small files for tests, in a folder of their own that goes away with the test.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh_io.h"
#include "support/same_mesh.h"

namespace ravel::test {

class TempFolder {
  public:
    TempFolder() {
        static std::atomic<int> made = 0;
        const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
        path_ = std::filesystem::temp_directory_path() /
                ("ravel-test-" + std::to_string(now) + "-" + std::to_string(made++));
        std::filesystem::create_directories(path_);
    }
    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    std::string operator/(std::string_view name) const { return (path_ / name).string(); }
    std::string write(std::string_view name, std::string_view bytes) const {
        const std::string path = *this / name;
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }
    std::string read(std::string_view name) const {
        std::ifstream file(*this / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

  private:
    std::filesystem::path path_;
};

// The mesh of a file with these bytes; the error's detail without the folder where it fails.
inline Result<Mesh> read_bytes(std::string_view name, std::string_view bytes) {
    const TempFolder folder;
    Result<Mesh> mesh = io::read_mesh(folder.write(name, bytes));
    if (!mesh) {
        std::string& detail = mesh.error().detail;
        const std::string prefix = folder / "";
        for (std::size_t at; (at = detail.find(prefix)) != std::string::npos;)
            detail.erase(at, prefix.size());
    }
    return mesh;
}

inline std::string error_of(std::string_view name, std::string_view bytes) {
    const Result<Mesh> mesh = read_bytes(name, bytes);
    return mesh ? "no error" : mesh.error().detail;
}

// Empty when a mesh comes back from a file of this name with every bit, else what is wrong.
inline std::string trouble_coming_back(const Mesh& mesh, std::string_view name,
                                       bool binary = false) {
    const TempFolder folder;
    std::vector<std::string> left_out;
    const Status status = io::write_mesh(mesh, folder / name, {.binary = binary}, &left_out);
    if (!status) return status.error().detail;
    if (!left_out.empty()) return left_out.front();
    const Result<Mesh> again = io::read_mesh(folder / name);
    return again ? difference(mesh, *again) : again.error().detail;
}

// The same for the mesh of these bytes.
inline std::string trouble_reading_again(std::string_view name, std::string_view bytes,
                                         bool binary = false) {
    const Result<Mesh> mesh = read_bytes(name, bytes);
    return mesh ? trouble_coming_back(*mesh, name, binary) : mesh.error().detail;
}

}  // namespace ravel::test
