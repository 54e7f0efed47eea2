/* Builds meshes through the C interface, packs them, unpacks them, and finds everything again.
 *   c_roundtrip_test FILE        leaves one packed mesh in FILE for c_decoder_test */
#include <ravel/ravel_c.h>
#include <string.h>

#include "check.h"

static ravel_error error;

static ravel_array array_of(const void* data, uint64_t count, uint32_t arity, uint32_t scalar) {
    ravel_array array;
    array.data = data;
    array.count = count;
    array.arity = arity;
    array.scalar = scalar;
    array.stride = arity * ravel_scalar_size((int)scalar);
    return array;
}

/* Two quads and a triangle; points interleaved with something else; everything that a mesh has. */
static ravel_mesh* make_polygons(void) {
    static const double rows[7][4] = {{0, 0, 0, 9}, {1, 0, 0, 9}, {2, 0, 0, 9}, {0, 1, 0, 9},
                                      {1, 1, 0, 9}, {2, 1, 1, 9}, {3, 0, .5, 9}};
    static const uint32_t corners[] = {0, 1, 4, 3, 1, 2, 5, 4, 2, 6, 5};
    static const int64_t begin[] = {0, 4, 8, 11};
    static const int32_t region[] = {7, -7, 0};
    static const float colour[] = {.5f, 0, 1, .25f};
    static const uint64_t colour_of[] = {0, 1, UINT64_MAX, 1, 0, 0, UINT64_MAX};
    static const uint32_t line[] = {0, 1, 1, 2};
    static const uint32_t nearest[] = {1, 2, 3};
    const ravel_reference reference = {0, RAVEL_ON_CELLS, 1};
    ravel_array a;
    ravel_array index;
    ravel_mesh* mesh = ravel_mesh_new(RAVEL_POLYGONS);
    CHECK(mesh != NULL);
    a = array_of(rows, 7, 3, RAVEL_F64);
    a.stride = sizeof rows[0];
    CHECK(ravel_mesh_set(mesh, RAVEL_POSITIONS, &a, &error) == RAVEL_DONE);
    a = array_of(corners, 11, 1, RAVEL_U32);
    CHECK(ravel_mesh_set(mesh, RAVEL_CORNERS, &a, &error) == RAVEL_DONE);
    a = array_of(begin, 4, 1, RAVEL_I64);
    CHECK(ravel_mesh_set(mesh, RAVEL_CORNER_BEGIN, &a, &error) == RAVEL_DONE);
    a = array_of(region, 3, 1, RAVEL_I32);
    CHECK(ravel_mesh_add_attribute(mesh, "region", RAVEL_ON_CELLS, &a, NULL, &error) == 0);
    a = array_of(colour, 2, 2, RAVEL_F32);
    index = array_of(colour_of, 7, 1, RAVEL_U64);
    CHECK(ravel_mesh_add_attribute(mesh, "colour", RAVEL_ON_POINTS, &a, &index, &error) == 0);
    a = array_of(nearest, 3, 1, RAVEL_U32);
    CHECK(ravel_mesh_add_attribute(mesh, "next", RAVEL_ON_CELLS, &a, NULL, &error) == 0);
    CHECK(ravel_mesh_add_reference(mesh, 2, &reference, &error) == RAVEL_DONE);
    a = array_of(line, 2, 2, RAVEL_U32);
    CHECK(ravel_mesh_add_companion(mesh, 3, &a, NULL, &error) == RAVEL_DONE);
    CHECK(ravel_mesh_add_tag_name(mesh, "region", 2, -7, "inlet", &error) == RAVEL_DONE);
    CHECK(ravel_mesh_add_note(mesh, "made by", "C", &error) == RAVEL_DONE);
    return mesh;
}

static void find_polygons_again(const ravel_mesh* mesh) {
    ravel_summary s;
    ravel_array a;
    ravel_attribute attribute;
    ravel_reference reference;
    ravel_companion companion;
    ravel_tag_name tag;
    ravel_note note;
    uint32_t corners[11], position[3], i;
    uint64_t cell[3];
    float narrow[21];
    ravel_summary_init(&s, sizeof s);
    CHECK(ravel_mesh_summary(mesh, &s, &error) == RAVEL_DONE);
    CHECK(s.kind == RAVEL_POLYGONS && s.points == 7 && s.cells == 3 && s.corners == 11);
    CHECK(s.attributes == 3 && s.companion_blocks == 1 && s.position_scalar == RAVEL_F64);
    CHECK(ravel_mesh_array(mesh, RAVEL_POSITIONS, 0, &a, &error) == RAVEL_DONE);
    CHECK(a.count == 7 && a.arity == 3 && ((const double*)a.data)[18] == 3);
    CHECK(ravel_mesh_copy(mesh, RAVEL_POSITIONS, 0, RAVEL_F32, narrow, sizeof narrow, &error) == 0);
    CHECK(narrow[20] == .5f);
    CHECK(ravel_mesh_copy(mesh, RAVEL_CORNERS, 0, RAVEL_U32, corners, sizeof corners, &error) == 0);
    CHECK(corners[0] == 0 && corners[1] == 1 && corners[10] == 5);

    CHECK(ravel_mesh_find_attribute(mesh, RAVEL_ON_CELLS, "region") == 0);
    CHECK(ravel_mesh_find_attribute(mesh, RAVEL_ON_POINTS, "region") == -1);
    CHECK(ravel_mesh_attribute(mesh, 1, &attribute, &error) == RAVEL_DONE);
    CHECK(strcmp(attribute.name.text, "colour") == 0 && attribute.name.size == 6);
    CHECK(attribute.place == RAVEL_ON_POINTS && attribute.scalar == RAVEL_F32);
    CHECK(attribute.is_pool == 1 && attribute.tuples == 2 && attribute.arity == 2);
    CHECK(ravel_mesh_array(mesh, RAVEL_ATTRIBUTE_INDEX, 1, &a, &error) == RAVEL_DONE);
    CHECK(a.count == 7 && ((const uint64_t*)a.data)[2] == RAVEL_NO_INDEX);
    CHECK(ravel_mesh_array(mesh, RAVEL_ATTRIBUTE_VALUES, 0, &a, &error) == RAVEL_DONE);
    CHECK(a.count == 3 && ((const int32_t*)a.data)[1] == -7);
    CHECK(ravel_mesh_reference(mesh, 2, 0, &reference, &error) == RAVEL_DONE);
    CHECK(reference.place == RAVEL_ON_CELLS && reference.base == 1);
    CHECK(ravel_mesh_companion(mesh, 0, &companion, &error) == RAVEL_DONE);
    CHECK(companion.vtk_type == 3 && companion.nodes_per_cell == 2 && companion.cells == 2);
    CHECK(ravel_mesh_array(mesh, RAVEL_COMPANION_NODES, 0, &a, &error) == RAVEL_DONE);
    CHECK(a.count == 2 && ((const uint64_t*)a.data)[3] == 2);
    CHECK(ravel_mesh_array(mesh, RAVEL_COMPANION_HOSTS, 0, &a, &error) == RAVEL_DONE);
    CHECK(a.count == 0 && a.data == NULL);
    CHECK(ravel_mesh_tag_names(mesh) == 1 && ravel_mesh_notes(mesh) == 1);
    CHECK(ravel_mesh_tag_name(mesh, 0, &tag, &error) == RAVEL_DONE);
    CHECK(tag.value == -7 && tag.dimension == 2 && strcmp(tag.name.text, "inlet") == 0);
    CHECK(ravel_mesh_note(mesh, 0, &note, &error) == RAVEL_DONE);
    CHECK(strcmp(note.key.text, "made by") == 0 && strcmp(note.text.text, "C") == 0);

    /* The strip visits every cell once; RAVEL_STRIP_POSITION is the inverse. */
    CHECK(ravel_mesh_copy(mesh, RAVEL_STRIP_CELL, 0, RAVEL_U64, cell, sizeof cell, &error) == 0);
    CHECK(ravel_mesh_copy(mesh, RAVEL_STRIP_POSITION, 0, RAVEL_U32, position, sizeof position,
                          &error) == RAVEL_DONE);
    for (i = 0; i < 3; ++i) CHECK(position[cell[i]] == i);
    CHECK(ravel_mesh_array(mesh, RAVEL_STRIP_FROM, 0, &a, &error) == RAVEL_DONE);
    CHECK(a.count == 3 && *(const uint64_t*)a.data == RAVEL_NO_INDEX);
    CHECK(ravel_mesh_array(mesh, RAVEL_STRIP_LINK, 0, &a, &error) == RAVEL_DONE);
    CHECK(a.count == 3 && a.scalar == RAVEL_U8);
}

static void polygons_come_back(const char* path) {
    ravel_mesh* mesh = make_polygons();
    ravel_mesh* again = NULL;
    ravel_packed* packed = NULL;
    ravel_encode_options options;
    ravel_array file;
    FILE* out;
    ravel_encode_options_init(&options, sizeof options);
    options.keep_order = 1;
    options.fast = 1;
    CHECK(options.threads == 1);
    options.threads = UINT32_MAX;
    CHECK(ravel_encode(mesh, &options, &packed, &error) == RAVEL_BAD_OPTION && packed == NULL);
    options.threads = 3;
    CHECK(ravel_encode(mesh, &options, &packed, &error) == RAVEL_DONE);
    CHECK(ravel_packed_bound(packed) == 0);
    CHECK(ravel_packed_array(packed, RAVEL_FILE, &file, &error) == RAVEL_DONE);
    CHECK(ravel_decode(file.data, (size_t)file.count, NULL, &again, &error) == RAVEL_DONE);
    find_polygons_again(again);
    ravel_mesh_free(again);

    out = fopen(path, "wb");
    CHECK(out != NULL);
    CHECK(fwrite(file.data, 1, (size_t)file.count, out) == file.count);
    CHECK(fclose(out) == 0);
    ravel_packed_free(packed);
    ravel_mesh_free(mesh);
}

static void tets_come_back(void) {
    static const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    static const uint32_t tets[] = {0, 1, 2, 3, 1, 2, 3, 4};
    ravel_mesh* mesh = ravel_mesh_new(RAVEL_TETS);
    ravel_mesh* again = NULL;
    ravel_packed* packed = NULL;
    ravel_array a = array_of(positions, 5, 3, RAVEL_F32);
    ravel_array file, map;
    ravel_encode_options options;
    CHECK(ravel_mesh_set(mesh, RAVEL_POSITIONS, &a, &error) == RAVEL_DONE);
    a = array_of(tets, 2, 4, RAVEL_U32);
    CHECK(ravel_mesh_set(mesh, RAVEL_CORNERS, &a, &error) == RAVEL_DONE);
    ravel_encode_options_init(&options, sizeof options);
    options.max_error = .001;
    CHECK(ravel_encode(mesh, &options, &packed, &error) == RAVEL_DONE);
    CHECK(ravel_packed_bound(packed) > 0 && ravel_packed_bound(packed) <= .001);
    CHECK(ravel_packed_error(packed) <= ravel_packed_bound(packed));
    CHECK(ravel_packed_array(packed, RAVEL_NEW_POINT, &map, &error) == RAVEL_DONE);
    CHECK(map.count == 5);
    CHECK(ravel_packed_array(packed, RAVEL_NEW_CELL, &map, &error) == RAVEL_DONE);
    CHECK(map.count == 2);
    CHECK(ravel_packed_array(packed, RAVEL_TURN, &map, &error) == RAVEL_DONE);
    CHECK(map.count == 2 && map.scalar == RAVEL_U32);
    CHECK(ravel_packed_array(packed, RAVEL_FILE, &file, &error) == RAVEL_DONE);
    CHECK(ravel_decode(file.data, (size_t)file.count, NULL, &again, &error) == RAVEL_DONE);
    CHECK(ravel_mesh_array(again, RAVEL_CORNERS, 0, &a, &error) == RAVEL_DONE);
    CHECK(a.count == 2 && a.arity == 4 && a.stride == 32);
    CHECK(ravel_mesh_array(again, RAVEL_CORNER_BEGIN, 0, &a, &error) == RAVEL_DONE);
    CHECK(a.count == 0);
    ravel_mesh_free(again);
    ravel_packed_free(packed);
    ravel_mesh_free(mesh);
}

static void errors_are_values(void) {
    static const uint32_t corners[] = {0, 1, 9};
    static const int32_t negative[] = {0, -2};
    static const uint32_t begin[] = {0, 3};
    ravel_mesh* mesh = ravel_mesh_new(RAVEL_POLYGONS);
    ravel_packed* packed = NULL;
    ravel_encode_options options;
    ravel_array a = array_of(corners, 3, 1, RAVEL_U32);
    const ravel_attribute_bound bound = {"heat", 4.5, RAVEL_BITS, 0};
    CHECK(ravel_mesh_new(2) == NULL);
    CHECK(ravel_mesh_set(mesh, RAVEL_CORNERS, &a, &error) == RAVEL_DONE);
    a = array_of(begin, 2, 1, RAVEL_U32);
    CHECK(ravel_mesh_set(mesh, RAVEL_CORNER_BEGIN, &a, &error) == RAVEL_DONE);
    CHECK(ravel_encode(mesh, NULL, &packed, &error) == RAVEL_BAD_MESH);
    CHECK(packed == NULL && error.code == RAVEL_BAD_MESH && strlen(error.sentence) > 10);
    CHECK(ravel_encode(mesh, NULL, &packed, NULL) == RAVEL_BAD_MESH);
    ravel_encode_options_init(&options, sizeof options);
    options.position_bits = 99;
    CHECK(ravel_encode(mesh, &options, &packed, &error) == RAVEL_BAD_OPTION);
    options.position_bits = 0;
    options.attribute_bound_count = 1;
    CHECK(ravel_encode(mesh, &options, &packed, &error) == RAVEL_BAD_ARGUMENT);
    options.attribute_bounds = &bound;
    CHECK(ravel_encode(mesh, &options, &packed, &error) == RAVEL_BAD_OPTION);
    a = array_of(negative, 2, 1, RAVEL_I32);
    CHECK(ravel_mesh_set(mesh, RAVEL_CORNERS, &a, &error) == RAVEL_BAD_ARGUMENT);
    CHECK(error.place == 1);
    a.scalar = 77;
    CHECK(ravel_mesh_set(mesh, RAVEL_CORNERS, &a, &error) == RAVEL_BAD_ARGUMENT);
    CHECK(ravel_mesh_set(mesh, RAVEL_POSITIONS, &a, &error) == RAVEL_BAD_ARGUMENT);
    CHECK(ravel_mesh_set(mesh, RAVEL_STRIP_CELL, &a, &error) == RAVEL_BAD_ARGUMENT);
    CHECK(ravel_mesh_set(NULL, RAVEL_CORNERS, &a, &error) == RAVEL_BAD_ARGUMENT);
    CHECK(ravel_mesh_add_attribute(mesh, "x", 9, &a, NULL, &error) == RAVEL_BAD_ARGUMENT);
    CHECK(ravel_mesh_add_companion(mesh, 1u << 20, &a, NULL, &error) == RAVEL_BAD_ARGUMENT);
    CHECK(ravel_packed_array(NULL, RAVEL_FILE, &a, &error) == RAVEL_BAD_ARGUMENT);
    ravel_mesh_free(mesh);
    ravel_mesh_free(NULL);
    ravel_packed_free(NULL);
}

int main(int count, char** words) {
    CHECK(count == 2);
    CHECK(ravel_abi() == RAVEL_ABI);
    polygons_come_back(words[1]);
    tets_come_back();
    errors_are_values();
    return 0;
}
