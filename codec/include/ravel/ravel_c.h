/* Ravel for C, and for every language that calls C: Python's ctypes, WebAssembly, Rust, Julia.
 *
 *     ravel_mesh *mesh = NULL;
 *     ravel_error error;
 *     if (ravel_decode(bytes, size, NULL, &mesh, &error) != RAVEL_DONE) complain(error.sentence);
 *     ravel_array corners;
 *     ravel_mesh_array(mesh, RAVEL_CORNERS, 0, &corners, NULL);    // a view, no copy
 *     ...
 *     ravel_mesh_free(mesh);
 *
 * Every function that can fail returns RAVEL_DONE or another ravel_code, and fills *error where
 * `error` is not NULL. Nothing throws, aborts or leaks; any bytes are safe to decode. Two threads
 * may work at the same time, and read one mesh; nobody may change or free what another reads.
 *
 * Structs that may grow begin with `struct_size`. The _init functions set it and the defaults; they
 * are told the size of the caller's struct, and a library reads and writes only the fields that the
 * caller knew of. ravel_abi() changes when anything else does.
 *
 * The first part of this header needs the decoder alone (target ravel::decode, -lravel_decode),
 * the second part the encoder too (ravel::ravel, -lravel). */
#ifndef RAVEL_RAVEL_C_H
#define RAVEL_RAVEL_C_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* -- Words ---------------------------------------------------------------------------------- */

enum { RAVEL_ABI = 2 };
/* The RAVEL_ABI the library was built with; the program that calls it expects the same. */
uint32_t ravel_abi(void);

typedef enum ravel_code {
    RAVEL_DONE = 0,
    RAVEL_NOT_A_RAVEL_FILE = 1,    /* the magic bytes are missing */
    RAVEL_UNSUPPORTED_VERSION = 2, /* written by another version of ravel */
    RAVEL_TRUNCATED = 3,           /* the bytes end before the data does */
    RAVEL_CHECKSUM_MISMATCH = 4,   /* the bytes are not those that were written */
    RAVEL_CORRUPT = 5,             /* a value that no encoder writes */
    RAVEL_LIMIT_EXCEEDED = 6,      /* more memory than the caller allows */
    RAVEL_BAD_OPTION = 7,          /* options that contradict each other or are out of range */
    RAVEL_BAD_MESH = 8,            /* e.g. a corner that names no point */
    RAVEL_BAD_ARGUMENT = 20,       /* NULL, a part or an index that does not exist */
    RAVEL_TOO_SMALL = 21,          /* the caller's buffer */
    RAVEL_OUT_OF_MEMORY = 22,      /* the machine has less than the limit allows */
    RAVEL_BUG = 23                 /* of ravel; please report it */
} ravel_code;

/* The spelling used in messages, e.g. "checksum_mismatch". Never NULL. */
const char* ravel_code_name(int code);

typedef struct ravel_error {
    int32_t code;       /* a ravel_code */
    int32_t reserved;   /* 0 */
    uint64_t place;     /* byte offset in a file, index of a cell, corner or attribute in a mesh */
    char sentence[240]; /* what is wrong and what to do; ends with 0, cut if need be */
} ravel_error;

typedef enum ravel_kind { RAVEL_POLYGONS = 0, RAVEL_TETS = 1 } ravel_kind;

typedef enum ravel_scalar {
    RAVEL_U8 = 0,
    RAVEL_I8 = 1,
    RAVEL_U16 = 2,
    RAVEL_I16 = 3,
    RAVEL_U32 = 4,
    RAVEL_I32 = 5,
    RAVEL_U64 = 6,
    RAVEL_I64 = 7,
    RAVEL_F32 = 8,
    RAVEL_F64 = 9
} ravel_scalar;

/* Bytes of one scalar; 0 for a number that is none. */
size_t ravel_scalar_size(int scalar);

typedef enum ravel_place {
    RAVEL_ON_POINTS = 0,
    RAVEL_ON_CORNERS = 1,
    RAVEL_ON_CELLS = 2,
    RAVEL_ON_COMPANIONS = 3, /* all blocks, one after the other */
    RAVEL_ON_MESH = 4
} ravel_place;

/* RAVEL_NO_INDEX in an index of an attribute: this element has no tuple. In RAVEL_STRIP_FROM: the
 * strip starts here. */
static const uint64_t RAVEL_NO_INDEX = UINT64_MAX;

/* `count` tuples of `arity` scalars, native byte order; tuple i stands `i * stride` bytes behind
 * `data`. A view into memory that belongs to somebody else. */
typedef struct ravel_array {
    uint64_t count;
    uint64_t stride; /* arity * size of the scalar where the tuples are packed */
    uint32_t arity;
    uint32_t scalar; /* a ravel_scalar */
    const void* data;
} ravel_array;

/* The arrays of a mesh. `which` is the number of the block or attribute, 0 for the others. */
typedef enum ravel_part {
    RAVEL_POSITIONS = 0,       /* arity 3, F32 or F64, one tuple per point */
    RAVEL_CORNERS = 1,         /* U64 points; polygons: arity 1; tets: arity 4, one tuple per tet */
    RAVEL_CORNER_BEGIN = 2,    /* polygons: cells + 1 U64 offsets into the corners; tets: none */
    RAVEL_COMPANION_NODES = 3, /* which = block; U64 points, arity = nodes per cell */
    RAVEL_COMPANION_HOSTS = 4, /* which = block; U64 cells, none in most blocks */
    RAVEL_ATTRIBUTE_VALUES = 5, /* which = attribute; its scalar and arity */
    RAVEL_ATTRIBUTE_INDEX = 6,  /* which = attribute; U64 tuple of each element, or none at all */
    /* The strip, one entry per step; decoded meshes only. Facet f of a polygon is its side from
     * corner f to f + 1; facet f of a tet lies opposite corner f. */
    RAVEL_STRIP_CELL = 7,   /* U64 cell that the step visits */
    RAVEL_STRIP_FROM = 8,   /* U64 cell that the strip came from, or RAVEL_NO_INDEX */
    RAVEL_STRIP_EXIT = 9,   /* U32 facet of that cell */
    RAVEL_STRIP_ENTRY = 10, /* U32 facet of this cell */
    RAVEL_STRIP_LINK = 11,  /* U8 1 where the step splits both cells once materialised */
    /* The inverse of RAVEL_STRIP_CELL: U64 step of each cell. ravel_mesh_copy only. */
    RAVEL_STRIP_POSITION = 12
} ravel_part;

/* Any bytes and their number; followed by a 0 that is not counted. */
typedef struct ravel_text {
    const char* text;
    size_t size;
} ravel_text;

/* What a file or a mesh holds: all that a caller needs to make room for it. */
typedef struct ravel_summary {
    uint32_t struct_size; /* set it (or call ravel_summary_init) before the call */
    uint32_t kind;        /* a ravel_kind */
    uint64_t points, cells, corners;
    uint64_t companion_blocks, attributes;
    uint32_t position_scalar;   /* RAVEL_F32 or RAVEL_F64 */
    uint32_t exact_positions;   /* 1: bit for bit; of files only, as all that follows */
    uint64_t components, links; /* of the strip as the walk runs */
    uint32_t keeps_order;       /* 1: points and cells come back in the order they had */
    uint32_t format_version;
    double position_bound, position_error; /* allowed and measured, 0 for exact positions */
    uint64_t file_bytes;
} ravel_summary;
void ravel_summary_init(ravel_summary* summary, size_t struct_size);

/* -- Decoding ------------------------------------------------------------------------------- */

typedef struct ravel_mesh ravel_mesh;

typedef struct ravel_decode_options {
    uint32_t struct_size;
    uint32_t strip;        /* 1: also how the strip runs, 0: not (its arrays are then empty) */
    uint64_t memory_limit; /* bytes the decoder may take in all, 16 GiB unless set */
} ravel_decode_options;
void ravel_decode_options_init(ravel_decode_options* options, size_t struct_size);

/* The size query: reads the heads of a file, unpacks nothing. Takes time and memory of the heads
 * only. A file that passes may still be corrupt behind its heads. */
int ravel_inspect(const void* bytes, size_t size, ravel_summary* summary, ravel_error* error);

/* Unpacks. `*mesh` is NULL unless RAVEL_DONE comes back; free it with ravel_mesh_free. `options`
 * may be NULL. The mesh holds nothing of `bytes`. Linear in input plus output. */
int ravel_decode(const void* bytes, size_t size, const ravel_decode_options* options,
                 ravel_mesh** mesh, ravel_error* error);

/* Unpacks into the caller's memory what most callers want: points and cells. A buffer that is NULL
 * is left out; one that is too small gives RAVEL_TOO_SMALL before anything is decoded. Sizes are in
 * bytes; ravel_inspect tells the counts:
 *   positions     3 * points scalars of `position_scalar`
 *   corners       `corners` indices     corner_begin  cells + 1 indices (polygons)
 *   strip_cell    `cells` indices       strip_position `cells` indices
 * Indices are RAVEL_U32 or RAVEL_U64, positions RAVEL_F32 (rounded where the file has F64) or
 * RAVEL_F64. On failure the buffers may hold anything. */
typedef struct ravel_buffers {
    uint32_t struct_size;
    uint32_t index_scalar;    /* RAVEL_U32 unless set */
    uint32_t position_scalar; /* RAVEL_F32 unless set */
    uint32_t reserved;
    void* positions;
    size_t positions_size;
    void* corners;
    size_t corners_size;
    void* corner_begin;
    size_t corner_begin_size;
    void* strip_cell;
    size_t strip_cell_size;
    void* strip_position;
    size_t strip_position_size;
} ravel_buffers;
void ravel_buffers_init(ravel_buffers* buffers, size_t struct_size);
int ravel_decode_into(const void* bytes, size_t size, const ravel_decode_options* options,
                      const ravel_buffers* buffers, ravel_error* error);

void ravel_mesh_free(ravel_mesh* mesh); /* NULL is nothing */

/* -- Reading a mesh. Views and texts stay good until the mesh is changed or freed. ---------------
 */

int ravel_mesh_summary(const ravel_mesh* mesh, ravel_summary* summary, ravel_error* error);

/* A view of one array; count 0 and data NULL where the mesh has none. */
int ravel_mesh_array(const ravel_mesh* mesh, int part, uint64_t which, ravel_array* array,
                     ravel_error* error);

/* Copies one array, packed, into `out` of `size` bytes. `scalar` is the array's own, or for indices
 * also RAVEL_U32 (which fails where one does not fit, but RAVEL_NO_INDEX becomes UINT32_MAX), or
 * RAVEL_F32 for RAVEL_F64 and the reverse. */
int ravel_mesh_copy(const ravel_mesh* mesh, int part, uint64_t which, int scalar, void* out,
                    size_t size, ravel_error* error);

typedef struct ravel_companion {
    uint32_t vtk_type; /* VTK's cell type number, nodes in VTK's order */
    uint32_t nodes_per_cell;
    uint64_t cells;
    uint32_t has_hosts; /* 1: edge nodes of quadratic tets (vtk_type 24), one host tet each */
    uint32_t reserved;
} ravel_companion;
int ravel_mesh_companion(const ravel_mesh* mesh, uint64_t block, ravel_companion* companion,
                         ravel_error* error);

typedef struct ravel_attribute {
    ravel_text name;
    uint64_t tuples;
    uint32_t place;  /* a ravel_place */
    uint32_t scalar; /* a ravel_scalar */
    uint32_t arity;
    uint32_t is_pool;    /* 1: element i has tuple index[i], or none; 0: one tuple per element */
    uint32_t references; /* how many components are numbers of points or cells */
    uint32_t reserved;
} ravel_attribute;
int ravel_mesh_attribute(const ravel_mesh* mesh, uint64_t number, ravel_attribute* attribute,
                         ravel_error* error);
/* The first attribute of this place and name (which ends with 0); -1 where there is none. */
int64_t ravel_mesh_find_attribute(const ravel_mesh* mesh, int place, const char* name);

/* Component `component` holds numbers of points or cells, counted from `base`. */
typedef struct ravel_reference {
    uint32_t component;
    uint32_t place; /* RAVEL_ON_POINTS or RAVEL_ON_CELLS */
    int64_t base;
} ravel_reference;
int ravel_mesh_reference(const ravel_mesh* mesh, uint64_t attribute, uint32_t number,
                         ravel_reference* reference, ravel_error* error);

/* The name of a value of an integer attribute: physical names, groups, materials. */
typedef struct ravel_tag_name {
    ravel_text attribute, name;
    int64_t value;
    int32_t dimension; /* 0..3 where names are per dimension (Gmsh), -1 otherwise */
    int32_t reserved;
} ravel_tag_name;
uint64_t ravel_mesh_tag_names(const ravel_mesh* mesh);
int ravel_mesh_tag_name(const ravel_mesh* mesh, uint64_t number, ravel_tag_name* name,
                        ravel_error* error);

/* Words about the mesh as a whole, in order. */
typedef struct ravel_note {
    ravel_text key, text;
} ravel_note;
uint64_t ravel_mesh_notes(const ravel_mesh* mesh);
int ravel_mesh_note(const ravel_mesh* mesh, uint64_t number, ravel_note* note, ravel_error* error);

/* == With the encoder only ======================================================================
 */

/* -- Building a mesh. What is given is copied; arrays may be strided. ------------------------ */

/* An empty mesh, or NULL where memory is out. Free it with ravel_mesh_free. */
ravel_mesh* ravel_mesh_new(int kind);

/* Sets RAVEL_POSITIONS (arity 3, F32 or F64), RAVEL_CORNERS or RAVEL_CORNER_BEGIN (U32 or U64, or
 * I32 or I64 without negative numbers; corners in one column or four). Parts may come in any order:
 * whether they fit together is asked by ravel_encode. */
int ravel_mesh_set(ravel_mesh* mesh, int part, const ravel_array* array, ravel_error* error);

/* Adds a block of `nodes->count` cells with `nodes->arity` nodes each; `hosts` is mostly NULL. */
int ravel_mesh_add_companion(ravel_mesh* mesh, uint32_t vtk_type, const ravel_array* nodes,
                             const ravel_array* hosts, ravel_error* error);

/* Adds an attribute; `index` is NULL for one tuple per element. Names need not differ. */
int ravel_mesh_add_attribute(ravel_mesh* mesh, const char* name, int place,
                             const ravel_array* values, const ravel_array* index,
                             ravel_error* error);
int ravel_mesh_add_reference(ravel_mesh* mesh, uint64_t attribute, const ravel_reference* reference,
                             ravel_error* error);
int ravel_mesh_add_tag_name(ravel_mesh* mesh, const char* attribute, int32_t dimension,
                            int64_t value, const char* name, ravel_error* error);
int ravel_mesh_add_note(ravel_mesh* mesh, const char* key, const char* text, ravel_error* error);

/* -- Encoding ------------------------------------------------------------------------------- */

/* How an attribute of floats may lose precision; attributes that none names come back exactly. */
typedef enum ravel_bound_kind {
    RAVEL_BITS = 0,               /* 1..30 along the widest range of a component */
    RAVEL_MAX_ERROR = 1,          /* largest absolute error of any component */
    RAVEL_MAX_ERROR_RELATIVE = 2, /* the same in widest ranges */
    RAVEL_OCTAHEDRAL = 3          /* 3..24 bits, unit vectors of 3 components by two numbers */
} ravel_bound_kind;
typedef struct ravel_attribute_bound {
    const char* name; /* all attributes of this name */
    double value;
    uint32_t kind; /* ravel_bound_kind */
    uint32_t reserved;
} ravel_attribute_bound;

typedef struct ravel_encode_options {
    uint32_t struct_size;
    /* Positions are exact unless one of position_bits, max_error, max_error_relative and lattice is
     * not 0. */
    int32_t position_bits; /* 1..30 along the longest side */
    double max_error;      /* largest error of any coordinate */
    double strip_budget;   /* percent of cells the strip may add unmended; < 0: ravel's choice */
    int32_t level;         /* zstd's, 1..22 */
    uint32_t keep_order;   /* 1: the order of points and cells comes back */
    uint32_t float32;      /* 1: round F64 positions to F32 first */
    uint32_t fast; /* 1: faster to make and decode: no repeats, mirrors, planes are sought */
    double max_error_relative; /* as max_error, in diagonals of the bounding box */
    double lattice; /* a power of two: coordinates become multiples of it, alike in every mesh */
    const ravel_attribute_bound* attribute_bounds;
    uint64_t attribute_bound_count;
    uint32_t threads; /* that may work at a time, yours among them; 0: all; the same bytes */
    uint32_t reserved;
} ravel_encode_options;
void ravel_encode_options_init(ravel_encode_options* options, size_t struct_size);

typedef struct ravel_packed ravel_packed;

/* Packs. `*packed` is NULL unless RAVEL_DONE comes back; free it with ravel_packed_free. `options`
 * may be NULL: exact positions, order not kept. The same bytes on every machine. */
int ravel_encode(const ravel_mesh* mesh, const ravel_encode_options* options, ravel_packed** packed,
                 ravel_error* error);
void ravel_packed_free(ravel_packed* packed);

/* What came of it; views are good until ravel_packed_free. */
typedef enum ravel_outcome {
    RAVEL_FILE = 0,           /* U8: the file */
    RAVEL_NEW_POINT = 1,      /* U64: where each point of the mesh is in the decoded mesh */
    RAVEL_NEW_CELL = 2,       /* U64: where each cell is */
    RAVEL_TURN = 3,           /* U32: the corner (tets: the permutation) its new cell starts with */
    RAVEL_NEW_COMPANION = 4,  /* U64: where each companion is, over all blocks */
    RAVEL_COMPANION_TURN = 5, /* U32: the node its new companion starts with */
    RAVEL_ATTRIBUTE_BOUNDS = 6 /* F64: the largest error each attribute may have; 0 if exact */
} ravel_outcome;
int ravel_packed_array(const ravel_packed* packed, int outcome, ravel_array* array,
                       ravel_error* error);
/* The largest error of a coordinate that the file may have; 0 for exact positions. */
double ravel_packed_bound(const ravel_packed* packed);
double ravel_packed_error(const ravel_packed* packed); /* as measured */

#ifdef __cplusplus
}
#endif

#endif
