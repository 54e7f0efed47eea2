// Packed copies of a mesh's arrays in the caller's memory and width.
#include <cstddef>
#include <cstring>
#include <limits>
#include <string>

#include "c/handle.h"

namespace ravel::c {
namespace {

template <class T>
T at(const ravel_array& array, std::uint64_t i) {
    T value;
    std::memcpy(&value,
                static_cast<const std::byte*>(array.data) + (i / array.arity) * array.stride +
                    (i % array.arity) * sizeof(T),
                sizeof value);
    return value;
}

template <class T>
void put(void* out, std::uint64_t i, T value) {
    std::memcpy(static_cast<std::byte*>(out) + i * sizeof value, &value, sizeof value);
}

int copy_narrow(const ravel_array& array, std::uint64_t values, void* out, ravel_error* error) {
    for (std::uint64_t i = 0; i < values; ++i) {
        const auto value = at<std::uint64_t>(array, i);
        if (value >= UINT32_MAX && value != RAVEL_NO_INDEX)
            return fail(error, RAVEL_TOO_SMALL,
                        "an index does not fit into 32 bits; ask for RAVEL_U64", i);
        put(out, i, static_cast<std::uint32_t>(value));
    }
    return RAVEL_DONE;
}

int copy_values(const ravel_array& array, int scalar, void* out, ravel_error* error) {
    const std::uint64_t values = array.count * array.arity;
    const int own = static_cast<int>(array.scalar);
    if (scalar == own) {
        const std::size_t tuple = array.arity * ravel_scalar_size(own);
        for (std::uint64_t i = 0; i < array.count; ++i)
            std::memcpy(static_cast<std::byte*>(out) + i * tuple,
                        static_cast<const std::byte*>(array.data) + i * array.stride, tuple);
    } else if (own == RAVEL_U64 && scalar == RAVEL_U32) {
        return copy_narrow(array, values, out, error);
    } else if (own == RAVEL_F64 && scalar == RAVEL_F32) {
        for (std::uint64_t i = 0; i < values; ++i)
            put(out, i, static_cast<float>(at<double>(array, i)));
    } else {
        for (std::uint64_t i = 0; i < values; ++i)
            put(out, i, static_cast<double>(at<float>(array, i)));
    }
    return RAVEL_DONE;
}

bool converts(int own, int scalar) {
    return own == scalar || (own == RAVEL_U64 && scalar == RAVEL_U32) ||
           (own == RAVEL_F64 && scalar == RAVEL_F32) || (own == RAVEL_F32 && scalar == RAVEL_F64);
}

// The position of each cell, scattered into `out`; the steps are a permutation of the cells.
int copy_strip_positions(const std::vector<StripStep>& steps, int scalar, void* out,
                         ravel_error* error) {
    if (scalar == RAVEL_U32 && steps.size() >= UINT32_MAX)
        return fail(error, RAVEL_TOO_SMALL, "the steps do not fit into 32 bits");
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (scalar == RAVEL_U32)
            put(out, steps[i].cell, static_cast<std::uint32_t>(i));
        else
            put(out, steps[i].cell, static_cast<std::uint64_t>(i));
    return RAVEL_DONE;
}

int copy_part(const ravel_mesh* mesh, int part, std::uint64_t which, int scalar, void* out,
              std::size_t size, ravel_error* error) {
    // The position of a cell is an index as the cell of a position is.
    const bool scatter = part == RAVEL_STRIP_POSITION;
    ravel_array array;
    const int code =
        ravel_mesh_array(mesh, scatter ? RAVEL_STRIP_CELL : part, which, &array, error);
    if (code != RAVEL_DONE) return code;
    if (!converts(static_cast<int>(array.scalar), scalar))
        return fail(error, RAVEL_BAD_ARGUMENT, "this array does not come in that scalar");
    const std::uint64_t values = array.count * array.arity;
    if (values > size / ravel_scalar_size(scalar))
        return fail(error, RAVEL_TOO_SMALL,
                    "the buffer has " + std::to_string(size) + " bytes, the array " +
                        std::to_string(values * ravel_scalar_size(scalar)));
    if (values == 0) return RAVEL_DONE;
    if (out == nullptr) return fail(error, RAVEL_BAD_ARGUMENT, "the buffer is NULL");
    return scatter ? copy_strip_positions(mesh->steps, scalar, out, error)
                   : copy_values(array, scalar, out, error);
}

}  // namespace
}  // namespace ravel::c

extern "C" int ravel_mesh_copy(const ravel_mesh* mesh, int part, uint64_t which, int scalar,
                               void* out, size_t size, ravel_error* error) {
    using namespace ravel::c;
    return guarded(error, [&] { return copy_part(mesh, part, which, scalar, out, size, error); });
}
