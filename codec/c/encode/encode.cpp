// Encoding for C.
#include "c/handle.h"

struct ravel_packed {
    ravel::Encoded encoded;
};

namespace ravel::c {
namespace {

ravel_encode_options default_options() {
    ravel_encode_options options{};
    options.struct_size = sizeof options;
    options.strip_budget = -1;
    options.level = EncodeOptions{}.level;
    return options;
}

EncodeOptions options_of(const ravel_encode_options& given) {
    EncodeOptions options;
    if (given.position_bits != 0) options.position_bits = given.position_bits;
    if (given.max_error != 0) options.max_error = given.max_error;
    if (given.max_error_relative != 0) options.max_error_relative = given.max_error_relative;
    if (given.lattice != 0) options.lattice = given.lattice;
    if (given.strip_budget >= 0) options.strip_budget = given.strip_budget;
    options.level = given.level;
    options.keep_order = given.keep_order != 0;
    options.float32 = given.float32 != 0;
    return options;
}

template <class T>
ravel_array view_of(const std::vector<T>& list, std::uint32_t scalar) {
    return {list.size(), sizeof(T), 1, scalar, list.empty() ? nullptr : list.data()};
}

}  // namespace
}  // namespace ravel::c

using namespace ravel;
using namespace ravel::c;

extern "C" {

void ravel_encode_options_init(ravel_encode_options* options, std::size_t struct_size) {
    initialise(options, struct_size, default_options());
}

int ravel_encode(const ravel_mesh* mesh, const ravel_encode_options* options, ravel_packed** packed,
                 ravel_error* error) {
    if (packed == nullptr)
        return fail(error, RAVEL_BAD_ARGUMENT, "an argument is NULL that must not be");
    *packed = nullptr;
    if (mesh == nullptr) return fail(error, RAVEL_BAD_ARGUMENT, "the mesh is NULL");
    return guarded(error, [&]() -> int {
        Result<Encoded> encoded =
            encode(mesh->mesh, options_of(known_fields(options, default_options())));
        if (!encoded) return fail(error, encoded.error());
        *packed = new ravel_packed{std::move(*encoded)};
        return RAVEL_DONE;
    });
}

void ravel_packed_free(ravel_packed* packed) {
    delete packed;
}

int ravel_packed_array(const ravel_packed* packed, int outcome, ravel_array* array,
                       ravel_error* error) {
    if (packed == nullptr || array == nullptr)
        return fail(error, RAVEL_BAD_ARGUMENT, "an argument is NULL that must not be");
    *array = {};
    const Encoded& e = packed->encoded;
    switch (outcome) {
        case RAVEL_FILE:
            *array = view_of(e.bytes, RAVEL_U8);
            return RAVEL_DONE;
        case RAVEL_NEW_POINT:
            *array = view_of(e.order.point, RAVEL_U64);
            return RAVEL_DONE;
        case RAVEL_NEW_CELL:
            *array = view_of(e.order.cell, RAVEL_U64);
            return RAVEL_DONE;
        case RAVEL_TURN:
            *array = view_of(e.order.turn, RAVEL_U32);
            return RAVEL_DONE;
        default:
            return fail(error, RAVEL_BAD_ARGUMENT, "this outcome does not exist");
    }
}

double ravel_packed_bound(const ravel_packed* packed) {
    return packed == nullptr ? 0 : packed->encoded.position_bound;
}

double ravel_packed_error(const ravel_packed* packed) {
    return packed == nullptr ? 0 : packed->encoded.position_error;
}
}
