// What the handles of the C interface hold, and how its functions fail: codes instead of
// exceptions.
#pragma once

#include <new>
#include <string_view>
#include <utility>
#include <vector>

#include "ravel/ravel.h"
#include "ravel/ravel_c.h"

struct ravel_mesh {
    ravel::Mesh mesh;
    std::vector<ravel::StripStep> steps;  // of decoded meshes
};

namespace ravel::c {

// Fills *error where there is one, returns `code`.
int fail(ravel_error* error, int code, std::string_view sentence, std::uint64_t place = 0);
int fail(ravel_error* error, const Error& why);

// What `work` returns; nothing that it throws gets past here.
template <class Work>
int guarded(ravel_error* error, Work&& work) {
    try {
        return std::forward<Work>(work)();
    } catch (const std::bad_alloc&) {
        return fail(error, RAVEL_OUT_OF_MEMORY, "out of memory");
    } catch (...) {
        return fail(error, RAVEL_BUG, "this is a bug in ravel, please report it");
    }
}

inline bool is_scalar(std::uint64_t scalar) {
    return scalar <= RAVEL_F64;
}

// The fields of `given` that the caller knew of, defaults for the others. Every such struct begins
// with its size.
template <class T>
T known_fields(const T* given, T defaults) {
    if (given == nullptr) return defaults;
    std::size_t size = given->struct_size;
    if (size > sizeof(T)) size = sizeof(T);
    const auto* from = reinterpret_cast<const unsigned char*>(given);
    auto* to = reinterpret_cast<unsigned char*>(&defaults);
    for (std::size_t i = 0; i < size; ++i) to[i] = from[i];
    return defaults;
}

// Defaults for the `size` bytes of a struct that the caller knows of.
template <class T>
void initialise(T* to, std::size_t size, T defaults) {
    if (to == nullptr) return;
    if (size > sizeof(T)) size = sizeof(T);
    if (size < sizeof defaults.struct_size) return;
    defaults.struct_size = static_cast<std::uint32_t>(size);
    const auto* from = reinterpret_cast<const unsigned char*>(&defaults);
    auto* out = reinterpret_cast<unsigned char*>(to);
    for (std::size_t i = 0; i < size; ++i) out[i] = from[i];
}

// Copies of `from` as far as the caller has room for fields.
template <class T>
void give_fields(const T& from, T* to) {
    std::size_t size = to->struct_size;
    if (size > sizeof(T)) size = sizeof(T);
    const auto* bytes = reinterpret_cast<const unsigned char*>(&from);
    auto* out = reinterpret_cast<unsigned char*>(to);
    for (std::size_t i = sizeof to->struct_size; i < size; ++i) out[i] = bytes[i];
}

}  // namespace ravel::c
