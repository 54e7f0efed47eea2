// Draco at its smallest (edgebreaker, speed 0): as triangles, and with the polygons kept.
#include <draco/compression/decode.h>
#include <draco/compression/expert_encode.h>

#include <algorithm>

#include "compare/contender.h"
#include "compare/draco_polygons.h"
#include "compare/polygon_match.h"

namespace ravel::compare {
namespace {

// Draco stores float64 as they are and quantises float32 only.
bool wants_double(const Input& input) {
    return !input.grid && input.mesh.positions.scalar == Scalar::f64;
}

bool all_triangles(const Mesh& mesh) {
    for (Index c = 0; c < mesh.cell_count(); ++c)
        if (mesh.cell(c).size() > 3) return false;
    return true;
}

std::string refuses(const Input& input) {
    if (input.mesh.kind == CellKind::tet) return "Draco has no tets";
    if (input.mesh.cell_count() == 0) return "Draco takes no mesh without faces";
    if (input.mesh.corners.size() > 0x7fffffffu) return "too large for Draco";
    if (input.grid && !all_finite(input.mesh))
        return "Draco can't quantise positions that are no numbers";
    return {};
}

Result<std::vector<std::byte>> pack(const Input& input, bool polygons, bool flat) {
    const bool mark = polygons && !all_triangles(input.mesh);
    const auto mesh = draco_mesh_of(input.mesh, wants_double(input) && !flat, mark, flat);
    draco::ExpertEncoder encoder(*mesh);
    encoder.SetSpeedOptions(0, 0);
    encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
    const int positions = mesh->GetNamedAttributeId(draco::GeometryAttribute::POSITION);
    if (flat)
        encoder.SetAttributeQuantization(positions, 1);
    else if (input.grid)
        encoder.SetAttributeQuantization(positions, input.grid->bits);
    draco::EncoderBuffer buffer;
    const draco::Status status = encoder.EncodeToBuffer(&buffer);
    if (!status.ok()) return Error{Code::bad_mesh, 0, "Draco: " + status.error_msg_string()};
    const auto* begin = reinterpret_cast<const std::byte*>(buffer.data());
    return std::vector<std::byte>(begin, begin + buffer.size());
}

template <bool polygons>
Result<Packed> encode_draco(const Input& input) {
    auto bytes = pack(input, polygons, false);
    if (!bytes) return bytes.error();
    Packed packed;
    packed.bytes = std::move(*bytes);
    return packed;
}

Result<Mesh> decode_draco(std::span<const std::byte> bytes, const Input&) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::Decoder decoder;
    auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
    if (!mesh.ok()) return Error{Code::corrupt, 0, "Draco: " + mesh.status().error_msg_string()};
    return mesh_of_draco(*mesh.value());
}

// The mesh Draco was asked for: fans of triangles, or the polygons it can hold.
Mesh expectation(const Mesh& mesh, bool polygons) {
    Mesh expected;
    expected.positions = mesh.positions;
    expected.corner_begin.push_back(0);
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const auto cell = mesh.cell(c);
        if (polygons || cell.size() < 3) {
            expected.corners.insert(expected.corners.end(), cell.begin(), cell.end());
            expected.corner_begin.push_back(expected.corners.size());
            continue;
        }
        for (std::size_t t = 1; t + 1 < cell.size(); ++t) {
            expected.corners.insert(expected.corners.end(), {cell[0], cell[t], cell[t + 1]});
            expected.corner_begin.push_back(expected.corners.size());
        }
    }
    return expected;
}

void add_note(std::string& note, Index count, const char* what) {
    if (count == 0) return;
    if (!note.empty()) note += "; ";
    note += std::to_string(count) + " " + what;
}

template <bool polygons>
Verdict check_draco(const Input& input, const Packed&, const Mesh& decoded) {
    const Mesh& mesh = input.mesh;
    const PolygonMatch match = match_polygons(expectation(mesh, polygons), decoded, input.grid);
    std::vector<bool> used(mesh.point_count(), false);
    for (Index p : mesh.corners) used[p] = true;
    const auto used_points = static_cast<Index>(std::count(used.begin(), used.end(), true));

    Verdict verdict;
    verdict.max_error = match.max_error;
    if (match.found == match.expected && match.extra == 0)
        verdict.connectivity_kept = polygons || all_triangles(mesh) ? "quads" : "triangulated";
    add_note(verdict.note, match.expected - match.found,
             polygons ? "polygons lost" : "triangles lost");
    add_note(verdict.note, match.extra, polygons ? "polygons made up" : "triangles made up");
    add_note(verdict.note, mesh.point_count() - used_points, "unused points dropped");
    if (decoded.point_count() > used_points)
        add_note(verdict.note, decoded.point_count() - used_points, "points split");
    if (input.grid && mesh.positions.scalar == Scalar::f64)
        verdict.note += std::string(verdict.note.empty() ? "" : "; ") + "float64 cut to float32";
    return verdict;
}

// A file whose positions are all zero is connectivity and a few bytes of headers.
template <bool polygons>
std::optional<std::uint64_t> connectivity_of(const Input& input) {
    auto bytes = pack(input, polygons, true);
    if (!bytes) return std::nullopt;
    return bytes->size();
}

}  // namespace

Contender draco_triangles() {
    return {"draco-triangles",  "edgebreaker, speed 0", refuses, encode_draco<false>, decode_draco,
            check_draco<false>, connectivity_of<false>};
}
Contender draco_polygons() {
    return {"draco-polygons",
            "edgebreaker, speed 0, polygons kept",
            refuses,
            encode_draco<true>,
            decode_draco,
            check_draco<true>,
            connectivity_of<true>};
}

}  // namespace ravel::compare
