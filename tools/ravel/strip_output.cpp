#include "ravel/strip_output.h"

namespace ravel::tool {
namespace {

Attribute cell_numbers(const char* name, std::size_t count) {
    return {name, Place::cell, make_array(Scalar::i64, 1, count), {}, {}};
}

}  // namespace

Mesh with_strip_data(Materialised&& strip) {
    const std::size_t cells = strip.mesh.cell_count();
    Attribute position = cell_numbers("strip_position", cells);
    Attribute component = cell_numbers("strip_component", cells);
    Attribute parent = cell_numbers("parent", cells);
    for (std::size_t k = 0; k + 1 < strip.first.size(); ++k)
        for (Index c = strip.first[k]; c < strip.first[k + 1]; ++c) {
            position.values.as<std::int64_t>()[c] = static_cast<std::int64_t>(c - strip.first[k]);
            component.values.as<std::int64_t>()[c] = static_cast<std::int64_t>(k);
            parent.values.as<std::int64_t>()[c] = static_cast<std::int64_t>(strip.parent[c]);
        }
    Mesh mesh = std::move(strip.mesh);
    mesh.attributes.push_back(std::move(position));
    if (strip.first.size() > 2) mesh.attributes.push_back(std::move(component));
    mesh.attributes.push_back(std::move(parent));
    return mesh;
}

Result<Mesh> mesh_of_strip(const Mesh& mesh, const Complex& complex, const Strip& strip) {
    auto materialised = materialise(mesh, complex, strip);
    if (!materialised) return materialised.error();
    return with_strip_data(std::move(*materialised));
}

}  // namespace ravel::tool
