// Writes the seeds of all fuzzers into a folder: small files made from recipes, and random bytes.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "io/file_bytes.h"
#include "io/mesh_io.h"
#include "make/make_mesh.h"
#include "make/random.h"
#include "ravel/ravel.h"

namespace {

void write(const std::filesystem::path& path, const std::vector<std::byte>& bytes) {
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
}

// Small meshes in a format's own words; TetGen's files one after the other, apart by a form feed.
bool write_meshes(const std::filesystem::path& folder, const std::string& format) {
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const char* recipe :
         {"tiny:empty", "tiny:cube", "tiny:two-tets", "polygons:mixed,size=3x3,attributes",
          "grid:size=2x2,double", "tets:box=1,attributes,companions", "soup:tets=4,seed=1",
          "soup:polygons=6,seed=2,attributes"})
        for (const bool binary : {false, true}) {
            const auto mesh = ravel::make::make_mesh(recipe);
            if (!mesh) return false;
            const std::filesystem::path path = folder / ("seed." + format);
            // Not every format holds every mesh.
            if (!ravel::io::write_mesh(*mesh, path.string(), {.binary = binary}, nullptr)) continue;
            const std::filesystem::path seed = folder / std::to_string(number++);
            if (format != "ele") {
                std::filesystem::rename(path, seed);
                continue;
            }
            std::string all;
            for (const char* ending : {"node", "ele", "face", "edge"}) {
                std::filesystem::path part = path;
                const auto bytes = ravel::io::read_file(part.replace_extension(ending).string());
                all += (bytes ? *bytes : "") + '\f';
                std::filesystem::remove(part);
            }
            if (!ravel::io::write_file(seed.string(), all)) return false;
        }
    return number > 0;
}

std::vector<ravel::EncodeOptions> option_rows() {
    std::vector<ravel::EncodeOptions> rows(4);
    rows[1].position_bits = 10;
    rows[2].keep_order = true;
    rows[3].position_bits = 20;
    rows[3].strip_budget = 0;
    return rows;
}

}  // namespace

int main(int count, char** words) {
    if (count != 2) {
        std::fprintf(stderr, "usage: ravel_make_seeds FOLDER\n");
        return 2;
    }
    const std::filesystem::path folder = words[1];
    std::filesystem::create_directories(folder / "decode");
    std::filesystem::create_directories(folder / "info");
    std::filesystem::create_directories(folder / "roundtrip");
    for (const char* format : {"obj", "off", "ply", "stl", "msh", "mesh", "vtk", "vtu", "ele"})
        if (!write_meshes(folder / format, format)) return 1;
    int number = 0;
    for (const char* recipe :
         {"tiny:empty", "tiny:triangle", "tiny:degrees-0-1-2", "tiny:bow-tie", "tiny:pinch",
          "tiny:cube", "tiny:tets-on-one-face", "tiny:flat-tet", "grid:size=5x4",
          "torus:size=8x6,double", "polygons:mixed,size=8x8,attributes", "moebius:size=9x2",
          "tets:box=2,jitter=0.2", "tets:box=2x2x1,attributes,companions,double",
          "soup:polygons=40,seed=3,attributes", "soup:tets=40,seed=4,attributes,companions",
          "tets:box=1x1x3,copies=3,shuffle"}) {
        const auto mesh = ravel::make::make_mesh(recipe);
        if (!mesh) return 1;
        for (const ravel::EncodeOptions& options : option_rows()) {
            const auto packed = ravel::encode(*mesh, options);
            if (!packed) return 1;
            write(folder / "decode" / std::to_string(number), packed->bytes);
            write(folder / "info" / std::to_string(number++), packed->bytes);
        }
    }
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        ravel::make::Random random{seed};
        std::vector<std::byte> bytes(20 + random.below(400));
        for (std::byte& b : bytes) b = static_cast<std::byte>(random.below(256));
        write(folder / "roundtrip" / std::to_string(seed), bytes);
    }
    return 0;
}
