// A mesh and options from any bytes, through the codec and back.
#include <cstdio>
#include <cstdlib>

#include "support/mesh_from_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto made =
        ravel::test::mesh_from_bytes({reinterpret_cast<const std::byte*>(data), size});
    const std::string found = ravel::test::trouble(made.mesh, made.options);
    if (!found.empty()) {
        std::fprintf(stderr, "%s\n", found.c_str());
        std::abort();
    }
    return 0;
}
