/* The decoder alone: no symbol of the encoder is linked.
 *   c_decoder_test FILE        FILE is what c_roundtrip_test left: two quads and a triangle */
#include <ravel/ravel_c.h>
#include <string.h>

#include "check.h"

static ravel_error error;
static unsigned char bytes[1 << 16];

static void sizes_come_first(size_t size) {
    ravel_summary s;
    struct {
        ravel_summary summary;
        uint32_t behind;
    } guard;
    ravel_summary_init(&s, sizeof s);
    CHECK(ravel_inspect(bytes, size, &s, &error) == RAVEL_DONE);
    CHECK(s.points == 7 && s.cells == 3 && s.corners == 11 && s.kind == RAVEL_POLYGONS);
    CHECK(s.exact_positions == 1 && s.keeps_order == 1 && s.file_bytes == size);
    CHECK(s.attributes == 3 && s.companion_blocks == 1 && s.components == 1);

    /* An older caller, whose struct ends behind `cells`, gets no byte more. */
    memset(&guard, 0x5A, sizeof guard);
    guard.summary.struct_size = (uint32_t)offsetof(ravel_summary, corners);
    CHECK(ravel_inspect(bytes, size, &guard.summary, &error) == RAVEL_DONE);
    CHECK(guard.summary.cells == 3);
    CHECK(*(const unsigned char*)&guard.summary.corners == 0x5A);

    memset(&guard, 0x5A, sizeof guard);
    ravel_summary_init(&guard.summary, offsetof(ravel_summary, corners));
    CHECK(guard.summary.struct_size == offsetof(ravel_summary, corners) && guard.summary.cells == 0);
    CHECK(*(const unsigned char*)&guard.summary.corners == 0x5A);
}

static void buffers_are_filled(size_t size) {
    float positions[21];
    uint32_t corners[11], begin[4], cell[3], position[3];
    double exact[21];
    uint64_t wide[11];
    ravel_buffers b;
    ravel_buffers_init(&b, sizeof b);
    b.positions = positions;
    b.positions_size = sizeof positions;
    b.corners = corners;
    b.corners_size = sizeof corners;
    b.corner_begin = begin;
    b.corner_begin_size = sizeof begin;
    b.strip_cell = cell;
    b.strip_cell_size = sizeof cell;
    b.strip_position = position;
    b.strip_position_size = sizeof position;
    CHECK(ravel_decode_into(bytes, size, NULL, &b, &error) == RAVEL_DONE);
    CHECK(begin[0] == 0 && begin[1] == 4 && begin[3] == 11 && corners[10] == 5);
    CHECK(positions[18] == 3 && position[cell[2]] == 2);
    b.corners_size = sizeof corners - 1;
    CHECK(ravel_decode_into(bytes, size, NULL, &b, &error) == RAVEL_TOO_SMALL);
    CHECK(strstr(error.sentence, "corners") != NULL);

    ravel_buffers_init(&b, sizeof b);
    b.index_scalar = RAVEL_U64;
    b.position_scalar = RAVEL_F64;
    b.positions = exact;
    b.positions_size = sizeof exact;
    b.corners = wide;
    b.corners_size = sizeof wide;
    CHECK(ravel_decode_into(bytes, size, NULL, &b, &error) == RAVEL_DONE);
    CHECK(wide[10] == 5 && exact[20] == .5);
    b.index_scalar = RAVEL_F32;
    CHECK(ravel_decode_into(bytes, size, NULL, &b, &error) == RAVEL_BAD_ARGUMENT);
    CHECK(ravel_decode_into(bytes, size, NULL, NULL, &error) == RAVEL_BAD_ARGUMENT);
}

/* Every cut and every flipped bit is an error with a sentence, and leaves no mesh. */
static void damage_is_refused(size_t size) {
    ravel_mesh* mesh = NULL;
    ravel_decode_options options;
    size_t i;
    for (i = 0; i < size; ++i) {
        CHECK(ravel_decode(bytes, i, NULL, &mesh, &error) != RAVEL_DONE);
        CHECK(mesh == NULL && error.sentence[0] != 0);
        bytes[i] ^= 1u << i % 8;
        CHECK(ravel_decode(bytes, size, NULL, &mesh, &error) != RAVEL_DONE || mesh != NULL);
        ravel_mesh_free(mesh);
        mesh = NULL;
        bytes[i] ^= 1u << i % 8;
    }
    CHECK(ravel_decode(NULL, 0, NULL, &mesh, &error) == RAVEL_NOT_A_RAVEL_FILE);
    CHECK(ravel_decode(NULL, 5, NULL, &mesh, &error) == RAVEL_BAD_ARGUMENT);
    CHECK(ravel_decode(bytes, size, NULL, NULL, &error) == RAVEL_BAD_ARGUMENT);
    ravel_decode_options_init(&options, sizeof options);
    options.memory_limit = 1000;
    CHECK(ravel_decode(bytes, size, &options, &mesh, &error) == RAVEL_LIMIT_EXCEEDED);
    CHECK(mesh == NULL && strstr(error.sentence, "memory") != NULL);
}

static void parts_that_are_not_there(size_t size) {
    ravel_mesh* mesh = NULL;
    ravel_array a;
    ravel_companion companion;
    uint64_t wide[11];
    int part;
    CHECK(ravel_decode(bytes, size, NULL, &mesh, &error) == RAVEL_DONE);
    for (part = -1; part < 16; ++part) {
        const int code = ravel_mesh_array(mesh, part, 99, &a, &error);
        CHECK(code == RAVEL_BAD_ARGUMENT && a.data == NULL && error.place == 99);
    }
    CHECK(ravel_mesh_array(mesh, RAVEL_STRIP_POSITION, 0, &a, &error) == RAVEL_BAD_ARGUMENT);
    CHECK(ravel_mesh_companion(mesh, 1, &companion, &error) == RAVEL_BAD_ARGUMENT);
    CHECK(ravel_mesh_copy(mesh, RAVEL_CORNERS, 0, RAVEL_F32, wide, sizeof wide, &error) ==
          RAVEL_BAD_ARGUMENT);
    CHECK(ravel_mesh_copy(mesh, RAVEL_CORNERS, 0, -1, wide, sizeof wide, &error) ==
          RAVEL_BAD_ARGUMENT);
    CHECK(ravel_mesh_copy(mesh, RAVEL_CORNERS, 0, RAVEL_U64, wide, 8 * 10, &error) ==
          RAVEL_TOO_SMALL);
    CHECK(ravel_mesh_copy(mesh, RAVEL_CORNERS, 0, RAVEL_U64, NULL, 8 * 11, &error) ==
          RAVEL_BAD_ARGUMENT);
    ravel_mesh_free(mesh);
}

int main(int count, char** words) {
    FILE* in;
    size_t size;
    CHECK(count == 2);
    in = fopen(words[1], "rb");
    CHECK(in != NULL);
    size = fread(bytes, 1, sizeof bytes, in);
    fclose(in);
    CHECK(size > 0 && size < sizeof bytes);
    CHECK(ravel_abi() == RAVEL_ABI);
    CHECK(strcmp(ravel_code_name(RAVEL_CORRUPT), "corrupt") == 0);
    CHECK(strcmp(ravel_code_name(-1), "unknown") == 0 && ravel_scalar_size(42) == 0);
    sizes_come_first(size);
    buffers_are_filled(size);
    damage_is_refused(size);
    parts_that_are_not_there(size);
    return 0;
}
