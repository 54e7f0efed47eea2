// Encoding for C.
#include <climits>
#include <cmath>

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
    options.threads = static_cast<std::uint32_t>(EncodeOptions{}.threads);
    return options;
}

// False where the kind is none, or the number of bits no whole number.
bool add_bound(const ravel_attribute_bound& given, EncodeOptions& options) {
    AttributeOptions bound;
    bound.name = given.name;
    const bool whole =
        given.value >= 0 && given.value <= 64 && given.value == std::floor(given.value);
    switch (given.kind) {
        case RAVEL_BITS:
            if (whole) bound.bits = static_cast<int>(given.value);
            break;
        case RAVEL_OCTAHEDRAL:
            if (whole) bound.octahedral = static_cast<int>(given.value);
            break;
        case RAVEL_MAX_ERROR:
            bound.max_error = given.value;
            break;
        case RAVEL_MAX_ERROR_RELATIVE:
            bound.max_error_relative = given.value;
            break;
        default:
            return false;
    }
    options.attributes.push_back(std::move(bound));
    return given.kind == RAVEL_MAX_ERROR || given.kind == RAVEL_MAX_ERROR_RELATIVE || whole;
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
    options.fast = given.fast != 0;
    options.threads = given.threads <= INT_MAX ? static_cast<int>(given.threads) : -1;
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
        const ravel_encode_options given = known_fields(options, default_options());
        EncodeOptions wanted = options_of(given);
        if (given.attribute_bounds == nullptr && given.attribute_bound_count > 0)
            return fail(error, RAVEL_BAD_ARGUMENT, "the list of attribute bounds is NULL");
        for (std::uint64_t i = 0; i < given.attribute_bound_count; ++i) {
            const ravel_attribute_bound& bound = given.attribute_bounds[i];
            if (bound.name == nullptr || !add_bound(bound, wanted))
                return fail(error, RAVEL_BAD_OPTION,
                            "an attribute bound has no name, no kind or no whole number of bits");
        }
        Result<Encoded> encoded = encode(mesh->mesh, wanted);
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
        case RAVEL_NEW_COMPANION:
            *array = view_of(e.order.companion, RAVEL_U64);
            return RAVEL_DONE;
        case RAVEL_COMPANION_TURN:
            *array = view_of(e.order.companion_turn, RAVEL_U32);
            return RAVEL_DONE;
        case RAVEL_ATTRIBUTE_BOUNDS:
            *array = view_of(e.attribute_bounds, RAVEL_F64);
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
