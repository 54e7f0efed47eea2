// Writes the seeds of both fuzzers into a folder: small files made from recipes, and random bytes.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "make/make_mesh.h"
#include "make/random.h"
#include "ravel/ravel.h"

namespace {

void write(const std::filesystem::path& path, const std::vector<std::byte>& bytes) {
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
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
    std::filesystem::create_directories(folder / "roundtrip");
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
            write(folder / "decode" / std::to_string(number++), packed->bytes);
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
