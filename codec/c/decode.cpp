// Decoding for C: into a handle, or into the caller's buffers.
#include <span>
#include <string>

#include "c/handle.h"

namespace ravel::c {
namespace {

std::span<const std::byte> bytes_of(const void* bytes, std::size_t size) {
    return {static_cast<const std::byte*>(bytes), size};
}

int inspect_file(std::span<const std::byte> bytes, ravel_summary* out, ravel_error* error) {
    const Result<FileInfo> info = inspect(bytes);
    if (!info) return fail(error, info.error());
    ravel_summary s{};
    s.kind = static_cast<std::uint32_t>(info->kind);
    s.points = info->points;
    s.cells = info->cells;
    s.corners = info->corners;
    s.companion_blocks = info->companions;
    s.attributes = info->attributes.size();
    s.position_scalar = static_cast<std::uint32_t>(info->position_scalar);
    s.exact_positions = info->lossless_positions ? 1 : 0;
    s.components = info->components;
    s.links = info->links;
    s.keeps_order = info->keeps_order ? 1 : 0;
    s.format_version = static_cast<std::uint32_t>(info->version);
    s.position_bound = info->position_bound;
    s.position_error = info->position_error;
    s.file_bytes = info->file_bytes;
    give_fields(s, out);
    return RAVEL_DONE;
}

ravel_decode_options default_options() {
    return {sizeof(ravel_decode_options), 1, DecodeOptions{}.memory_limit};
}

ravel_buffers default_buffers() {
    ravel_buffers buffers{};
    buffers.struct_size = sizeof buffers;
    buffers.index_scalar = RAVEL_U32;
    buffers.position_scalar = RAVEL_F32;
    return buffers;
}

int decode_into(std::span<const std::byte> bytes, const ravel_decode_options* options,
                const ravel_buffers& to, ravel_error* error) {
    const auto index = static_cast<int>(to.index_scalar),
               position = static_cast<int>(to.position_scalar);
    if ((index != RAVEL_U32 && index != RAVEL_U64) ||
        (position != RAVEL_F32 && position != RAVEL_F64))
        return fail(error, RAVEL_BAD_ARGUMENT,
                    "indices are RAVEL_U32 or RAVEL_U64, positions RAVEL_F32 or RAVEL_F64");
    ravel_summary holds;
    ravel_summary_init(&holds, sizeof holds);
    if (const int code = inspect_file(bytes, &holds, error); code != RAVEL_DONE) return code;
    const std::uint64_t begins = holds.kind == RAVEL_TETS ? 0 : holds.cells + 1;
    struct Wanted {
        int part, scalar;
        void* out;
        std::size_t size;
        std::uint64_t values;
        const char* name;
    };
    const Wanted wanted[] = {
        {RAVEL_POSITIONS, position, to.positions, to.positions_size, 3 * holds.points, "positions"},
        {RAVEL_CORNERS, index, to.corners, to.corners_size, holds.corners, "corners"},
        {RAVEL_CORNER_BEGIN, index, to.corner_begin, to.corner_begin_size, begins, "corner_begin"},
        {RAVEL_STRIP_CELL, index, to.strip_cell, to.strip_cell_size, holds.cells, "strip_cell"},
        {RAVEL_STRIP_POSITION, index, to.strip_position, to.strip_position_size, holds.cells,
         "strip_position"}};
    for (const Wanted& w : wanted)
        if (w.out != nullptr && w.values > w.size / ravel_scalar_size(w.scalar))
            return fail(error, RAVEL_TOO_SMALL,
                        std::string("the buffer for ") + w.name + " has " + std::to_string(w.size) +
                            " bytes for " + std::to_string(w.values) + " values");
    ravel_mesh* mesh = nullptr;
    int code = ravel_decode(bytes.data(), bytes.size(), options, &mesh, error);
    for (const Wanted& w : wanted)
        if (code == RAVEL_DONE && w.out != nullptr)
            code = ravel_mesh_copy(mesh, w.part, 0, w.scalar, w.out, w.size, error);
    ravel_mesh_free(mesh);
    return code;
}

int null_bytes(ravel_error* error) {
    return fail(error, RAVEL_BAD_ARGUMENT, "an argument is NULL that must not be");
}

}  // namespace
}  // namespace ravel::c

using namespace ravel;
using namespace ravel::c;

extern "C" {

void ravel_decode_options_init(ravel_decode_options* options, std::size_t struct_size) {
    initialise(options, struct_size, default_options());
}

void ravel_buffers_init(ravel_buffers* buffers, std::size_t struct_size) {
    initialise(buffers, struct_size, default_buffers());
}

int ravel_inspect(const void* bytes, size_t size, ravel_summary* summary, ravel_error* error) {
    if ((bytes == nullptr && size > 0) || summary == nullptr) return null_bytes(error);
    return guarded(error, [&] { return inspect_file(bytes_of(bytes, size), summary, error); });
}

int ravel_decode(const void* bytes, size_t size, const ravel_decode_options* options,
                 ravel_mesh** mesh, ravel_error* error) {
    if (mesh == nullptr) return null_bytes(error);
    *mesh = nullptr;
    if (bytes == nullptr && size > 0) return null_bytes(error);
    return guarded(error, [&]() -> int {
        const ravel_decode_options given = known_fields(options, default_options());
        DecodeOptions wanted;
        wanted.memory_limit = given.memory_limit;
        wanted.steps = given.strip != 0;
        Result<Decoded> decoded = decode(bytes_of(bytes, size), wanted);
        if (!decoded) return fail(error, decoded.error());
        *mesh = new ravel_mesh{std::move(decoded->mesh), std::move(decoded->steps)};
        return RAVEL_DONE;
    });
}

int ravel_decode_into(const void* bytes, size_t size, const ravel_decode_options* options,
                      const ravel_buffers* buffers, ravel_error* error) {
    if ((bytes == nullptr && size > 0) || buffers == nullptr) return null_bytes(error);
    return guarded(error, [&] {
        return decode_into(bytes_of(bytes, size), options, known_fields(buffers, default_buffers()),
                           error);
    });
}

void ravel_mesh_free(ravel_mesh* mesh) {
    delete mesh;
}
}
