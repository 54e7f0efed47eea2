// Ravel beside its peers: the same mesh through every codec, each result decoded and checked.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ravel/ravel.h"

namespace ravel::compare {

struct Request {
    EncodeOptions options;
    bool attributes = false;          // give ravel attributes, companions and names too
    std::vector<std::string> codecs;  // names of known_codecs()
    bool keep_file = false;           // ravel's row keeps what was packed
};

// One codec on one mesh. Empty numbers: the codec did not take part, `note` says why.
struct Row {
    std::string mesh;
    Index cells = 0;
    CellKind kind = CellKind::polygon;
    Index vertices = 0;
    std::string codec, settings;
    std::optional<std::uint64_t> bytes, connectivity_bytes, geometry_bytes, attribute_bytes;
    std::optional<double> connectivity_ideal_bytes;  // of an ideal entropy coder, ravel only
    std::optional<double> encode_seconds, decode_seconds, max_error;
    std::string
        connectivity_kept;  // quads, tets, triangulated, lost; empty if it did not take part
    std::string note;
    std::vector<std::byte> file;
};

std::vector<std::string> known_codecs();

// A row per codec, in the order asked for. `settings` describes the position options.
std::vector<Row> compare_mesh(const std::string& name, Mesh mesh, const Request& request,
                              const std::string& settings);

double bits_per_cell(const Row& row);

struct Mean {
    CellKind kind = CellKind::polygon;
    std::string codec;
    Index meshes = 0;
    double bits_per_cell = 0;  // geometric mean over the meshes the codec took part in
};
std::vector<Mean> geometric_means(const std::vector<Row>& rows);

// Bytes of ravel over bytes of `peer`, mesh by mesh, and the meshes where ravel is not smaller.
struct Ratios {
    std::string peer;
    std::vector<std::pair<std::string, double>> all;
    std::vector<std::string> lost;
};
Ratios ratios_to(const std::vector<Row>& rows, CellKind kind, const std::string& peer);

}  // namespace ravel::compare
