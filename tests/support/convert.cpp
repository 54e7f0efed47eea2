// Converts a mesh file to another format, for checks against other programs' readers and writers.
#include <cstdio>
#include <string_view>

#include "io/mesh_io.h"

int main(int argc, char** argv) {
    if (argc < 3 || (argc == 4 && std::string_view(argv[3]) != "--binary") || argc > 4) {
        std::fprintf(stderr, "usage: ravel_convert IN OUT [--binary]\n");
        return 2;
    }
    const ravel::Result<ravel::Mesh> mesh = ravel::io::read_mesh(argv[1]);
    if (!mesh) {
        std::fprintf(stderr, "%s\n", mesh.error().detail.c_str());
        return 3;
    }
    std::vector<std::string> left_out;
    const ravel::Status status =
        ravel::io::write_mesh(*mesh, argv[2], {.binary = argc == 4}, &left_out);
    for (const std::string& sentence : left_out) std::fprintf(stderr, "%s\n", sentence.c_str());
    if (!status) {
        std::fprintf(stderr, "%s\n", status.error().detail.c_str());
        return 3;
    }
    return 0;
}
