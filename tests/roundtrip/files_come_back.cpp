// Reads each file, writes it in its own format (as text and, where there is one, as binary), reads
// that again, and compares every field. One line per file; exit 1 when any differs.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>

#include "io/mesh_io.h"
#include "support/same_mesh.h"

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string comes_back(const ravel::Mesh& mesh, const std::filesystem::path& copy, bool binary,
                       double& write_seconds) {
    std::vector<std::string> left_out;
    const auto start = std::chrono::steady_clock::now();
    const ravel::Status status =
        ravel::io::write_mesh(mesh, copy.string(), {.binary = binary}, &left_out);
    write_seconds = seconds_since(start);
    if (!status) return "not written: " + status.error().detail;
    if (!left_out.empty()) return "left out: " + left_out.front();
    const ravel::Result<ravel::Mesh> again = ravel::io::read_mesh(copy.string());
    if (!again) return "not read again: " + again.error().detail;
    const std::string difference = ravel::test::difference(mesh, *again);
    return difference.empty() ? "" : "differs in " + difference;
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() /
        ("ravel-files-" +
         std::to_string(std::chrono::steady_clock::now().time_since_epoch().count()));
    std::filesystem::create_directories(folder);
    int bad = 0;
    for (int i = 1; i < argc; ++i) {
        const std::filesystem::path path = argv[i];
        const auto start = std::chrono::steady_clock::now();
        const ravel::Result<ravel::Mesh> mesh = ravel::io::read_mesh(path.string());
        const double read_seconds = seconds_since(start);
        std::string outcome;
        double write_seconds = 0;
        if (!mesh) {
            outcome = mesh.error().detail;
        } else {
            for (const bool binary : {true, false})
                if (outcome.empty())
                    outcome = comes_back(*mesh, folder / ("copy" + path.extension().string()),
                                         binary, write_seconds);
        }
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
        if (!outcome.empty()) ++bad;
        std::printf(
            "%-40s read %.2f s, write %.2f s, %s %llu points %llu %ss %llu companions: %s\n",
            path.filename().c_str(), read_seconds, write_seconds,
            mesh ? ravel::name_of(mesh->positions.scalar) : "-",
            static_cast<unsigned long long>(mesh ? mesh->point_count() : 0),
            static_cast<unsigned long long>(mesh ? mesh->cell_count() : 0),
            mesh ? ravel::name_of(mesh->kind) : "cell",
            static_cast<unsigned long long>(mesh ? mesh->companion_count() : 0),
            outcome.empty() ? "same" : outcome.c_str());
    }
    std::filesystem::remove_all(folder);
    return bad == 0 ? 0 : 1;
}
