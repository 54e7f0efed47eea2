// Building a mesh from C. Arrays are copied and checked for what would make a Mesh unreadable;
// whether the parts fit together is for check_mesh, which `encode` asks.
#include <cstring>
#include <limits>
#include <optional>

#include "c/handle.h"

namespace ravel::c {
namespace {

int refuse(ravel_error* error, const char* why) {
    return fail(error, RAVEL_BAD_ARGUMENT, why);
}

bool sound(const ravel_array& array) {
    return is_scalar(array.scalar) && array.arity > 0 && array.arity <= 65535 &&
           (array.data != nullptr || array.count == 0) &&
           array.count <= std::numeric_limits<std::ptrdiff_t>::max() / (8 * std::uint64_t{65535});
}

// Index `i` of an integer array; nothing where it is negative. RAVEL_NO_INDEX has a 32-bit form.
template <class T>
std::optional<Index> index_at(const std::byte* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    if (value == static_cast<T>(-1)) return kNoIndex;
    if constexpr (std::numeric_limits<T>::is_signed)
        if (value < 0) return std::nullopt;
    return static_cast<Index>(value);
}

std::optional<Index> index_at(const ravel_array& array, std::uint64_t tuple, std::uint32_t k) {
    const auto scalar = static_cast<Scalar>(array.scalar);
    const std::byte* from =
        static_cast<const std::byte*>(array.data) + tuple * array.stride + k * size_of(scalar);
    switch (scalar) {
        case Scalar::u32:
            return index_at<std::uint32_t>(from);
        case Scalar::i32:
            return index_at<std::int32_t>(from);
        case Scalar::u64:
            return index_at<std::uint64_t>(from);
        case Scalar::i64:
            return index_at<std::int64_t>(from);
        default:
            return std::nullopt;
    }
}

int copy_indices(const ravel_array& array, std::vector<Index>& out, ravel_error* error) {
    if (!sound(array)) return refuse(error, "an array of indices makes no sense");
    std::vector<Index> list;
    list.reserve(array.count * array.arity);
    for (std::uint64_t i = 0; i < array.count; ++i)
        for (std::uint32_t k = 0; k < array.arity; ++k) {
            const std::optional<Index> index = index_at(array, i, k);
            if (!index)
                return fail(error, RAVEL_BAD_ARGUMENT,
                            "indices are RAVEL_U32, RAVEL_U64, or signed without negative numbers",
                            i);
            list.push_back(*index);
        }
    out = std::move(list);
    return RAVEL_DONE;
}

int copy_array(const ravel_array& array, Array& out, ravel_error* error) {
    if (!sound(array)) return refuse(error, "an array of values makes no sense");
    Array copy = make_array(static_cast<Scalar>(array.scalar), array.arity, array.count);
    const std::size_t tuple = copy.stride();
    for (std::uint64_t i = 0; i < array.count; ++i)
        std::memcpy(copy.bytes.data() + i * tuple,
                    static_cast<const std::byte*>(array.data) + i * array.stride, tuple);
    out = std::move(copy);
    return RAVEL_DONE;
}

int set_part(ravel_mesh& handle, int part, const ravel_array& array, ravel_error* error) {
    Mesh& mesh = handle.mesh;
    int code = RAVEL_BAD_ARGUMENT;
    if (part == RAVEL_POSITIONS) {
        if (array.arity != 3 || (array.scalar != RAVEL_F32 && array.scalar != RAVEL_F64))
            return refuse(error, "positions have arity 3 and are RAVEL_F32 or RAVEL_F64");
        code = copy_array(array, mesh.positions, error);
    } else if (part == RAVEL_CORNERS) {
        code = copy_indices(array, mesh.corners, error);
    } else if (part == RAVEL_CORNER_BEGIN) {
        code = copy_indices(array, mesh.corner_begin, error);
    } else {
        return refuse(error, "only positions, corners and corner_begin can be set");
    }
    if (code == RAVEL_DONE) handle.steps.clear();  // a strip of other cells
    return code;
}

int add_attribute(Mesh& mesh, const char* name, int place, const ravel_array& values,
                  const ravel_array* index, ravel_error* error) {
    if (place < RAVEL_ON_POINTS || place > RAVEL_ON_MESH)
        return refuse(error, "this place does not exist");
    Attribute attribute;
    attribute.name = name;
    attribute.place = static_cast<Place>(place);
    if (const int code = copy_array(values, attribute.values, error); code != RAVEL_DONE)
        return code;
    if (index != nullptr)
        if (const int code = copy_indices(*index, attribute.index, error); code != RAVEL_DONE)
            return code;
    mesh.attributes.push_back(std::move(attribute));
    return RAVEL_DONE;
}

int add_companion(Mesh& mesh, std::uint32_t vtk_type, const ravel_array& nodes,
                  const ravel_array* hosts, ravel_error* error) {
    if (vtk_type > 0xFFFF) return refuse(error, "VTK has no such cell type");
    CompanionBlock block;
    block.vtk_type = static_cast<std::uint16_t>(vtk_type);
    block.nodes_per_cell = nodes.arity;
    block.cell_count = nodes.count;
    // Cells without nodes have nothing to copy.
    if (nodes.arity > 0)
        if (const int code = copy_indices(nodes, block.nodes, error); code != RAVEL_DONE)
            return code;
    if (hosts != nullptr)
        if (const int code = copy_indices(*hosts, block.hosts, error); code != RAVEL_DONE)
            return code;
    mesh.companions.push_back(std::move(block));
    return RAVEL_DONE;
}

constexpr const char* kNull = "an argument is NULL that must not be";

}  // namespace
}  // namespace ravel::c

using namespace ravel;
using namespace ravel::c;

extern "C" {

ravel_mesh* ravel_mesh_new(int kind) {
    if (kind != RAVEL_POLYGONS && kind != RAVEL_TETS) return nullptr;
    auto* mesh = new (std::nothrow) ravel_mesh;
    if (mesh != nullptr) mesh->mesh.kind = static_cast<CellKind>(kind);
    return mesh;
}

int ravel_mesh_set(ravel_mesh* mesh, int part, const ravel_array* array, ravel_error* error) {
    if (mesh == nullptr || array == nullptr) return refuse(error, kNull);
    return guarded(error, [&] { return set_part(*mesh, part, *array, error); });
}

int ravel_mesh_add_companion(ravel_mesh* mesh, uint32_t vtk_type, const ravel_array* nodes,
                             const ravel_array* hosts, ravel_error* error) {
    if (mesh == nullptr || nodes == nullptr) return refuse(error, kNull);
    return guarded(error,
                   [&] { return add_companion(mesh->mesh, vtk_type, *nodes, hosts, error); });
}

int ravel_mesh_add_attribute(ravel_mesh* mesh, const char* name, int place,
                             const ravel_array* values, const ravel_array* index,
                             ravel_error* error) {
    if (mesh == nullptr || name == nullptr || values == nullptr) return refuse(error, kNull);
    return guarded(error,
                   [&] { return add_attribute(mesh->mesh, name, place, *values, index, error); });
}

int ravel_mesh_add_reference(ravel_mesh* mesh, uint64_t attribute, const ravel_reference* reference,
                             ravel_error* error) {
    if (mesh == nullptr || reference == nullptr) return refuse(error, kNull);
    return guarded(error, [&]() -> int {
        if (attribute >= mesh->mesh.attributes.size())
            return refuse(error, "the mesh has no such attribute");
        if (reference->place != RAVEL_ON_POINTS && reference->place != RAVEL_ON_CELLS)
            return refuse(error, "references name points or cells");
        mesh->mesh.attributes[attribute].references.push_back(
            {reference->component, static_cast<Place>(reference->place), reference->base});
        return RAVEL_DONE;
    });
}

int ravel_mesh_add_tag_name(ravel_mesh* mesh, const char* attribute, int32_t dimension,
                            int64_t value, const char* name, ravel_error* error) {
    if (mesh == nullptr || attribute == nullptr || name == nullptr) return refuse(error, kNull);
    return guarded(error, [&]() -> int {
        mesh->mesh.tag_names.push_back({attribute, dimension, value, name});
        return RAVEL_DONE;
    });
}

int ravel_mesh_add_note(ravel_mesh* mesh, const char* key, const char* text, ravel_error* error) {
    if (mesh == nullptr || key == nullptr || text == nullptr) return refuse(error, kNull);
    return guarded(error, [&]() -> int {
        mesh->mesh.notes.push_back({key, text});
        return RAVEL_DONE;
    });
}
}
