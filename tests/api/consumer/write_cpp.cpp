// Packs one quad into the file it is given.
#include <ravel/ravel.h>

#include <fstream>
#include <iostream>

int main(int count, char** words) {
    if (count != 2) return 2;
    ravel::Mesh mesh;
    mesh.positions = ravel::make_array(ravel::Scalar::f32, 3, 4);
    const auto xyz = mesh.positions.as<float>();
    xyz[3] = xyz[6] = xyz[7] = xyz[10] = 1;
    mesh.corner_begin = {0, 4};
    mesh.corners = {0, 1, 2, 3};
    const auto packed = ravel::encode(mesh);
    if (!packed) {
        std::cerr << packed.error().detail << '\n';
        return 1;
    }
    const auto& bytes = packed->bytes;
    std::ofstream out(words[1], std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<long>(bytes.size()));
    return out.flush() ? 0 : 1;
}
