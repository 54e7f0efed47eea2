#include "ravel/compare_report.h"

#include <fmt/format.h>

#include "ravel/viewer_page.h"

namespace ravel::tool {
namespace {

template <class T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json bits_each(const std::optional<std::uint64_t>& bytes, Index elements) {
    if (!bytes || elements == 0) return nullptr;
    return 8.0 * static_cast<double>(*bytes) / static_cast<double>(elements);
}

std::string ratio_lines(const std::vector<compare::Row>& rows, CellKind kind,
                        const std::string& peer) {
    const compare::Ratios ratios = compare::ratios_to(rows, kind, peer);
    if (ratios.all.empty()) return {};
    std::string line = fmt::format("ravel/{}:", peer);
    for (const auto& [mesh, ratio] : ratios.all) line += fmt::format(" {} {:.3f}", mesh, ratio);
    line += ratios.lost.empty() ? "; smaller on all" : "; not smaller on:";
    for (const std::string& mesh : ratios.lost) line += " " + mesh;
    return line + "\n";
}

}  // namespace

Json json_rows(const std::vector<compare::Row>& rows) {
    Json result = Json::array();
    for (const compare::Row& row : rows) {
        Json fact;
        fact["mesh"] = row.mesh;
        fact["cells"] = row.cells;
        fact["cell_kind"] = name_of(row.kind);
        fact["vertices"] = row.vertices;
        fact["codec"] = row.codec;
        fact["settings"] = row.settings;
        fact["bytes"] = or_null(row.bytes);
        fact["connectivity_bytes"] = or_null(row.connectivity_bytes);
        fact["geometry_bytes"] = or_null(row.geometry_bytes);
        fact["attribute_bytes"] = or_null(row.attribute_bytes);
        fact["bits_per_vertex"] = bits_each(row.bytes, row.vertices);
        fact["bits_per_cell"] = bits_each(row.bytes, row.cells);
        fact["connectivity_bits_per_cell"] = bits_each(row.connectivity_bytes, row.cells);
        fact["connectivity_ideal_bytes"] = or_null(row.connectivity_ideal_bytes);
        fact["encode_seconds"] = or_null(row.encode_seconds);
        fact["decode_seconds"] = or_null(row.decode_seconds);
        fact["max_error"] = or_null(row.max_error);
        fact["connectivity_kept"] =
            row.connectivity_kept.empty() ? Json(nullptr) : Json(row.connectivity_kept);
        fact["note"] = row.note;
        result.push_back(std::move(fact));
    }
    return result;
}

Json viewer_data(const std::vector<compare::Row>& rows, const Json& facts,
                 const std::string& summary) {
    Json files = Json::array();
    for (const compare::Row& row : rows) {
        if (row.file.empty()) continue;
        Json file;
        file["name"] = row.mesh;
        file["data"] = base64_of(row.file);
        file["rows"] = Json::array();
        for (const Json& fact : facts)
            if (fact.at("mesh") == row.mesh) file["rows"].push_back(fact);
        files.push_back(std::move(file));
    }
    Json data;
    data["files"] = std::move(files);
    data["rows"] = facts;
    data["summary"] = summary;
    return data;
}

std::string summary_of(const std::vector<compare::Row>& rows) {
    std::string text;
    for (const CellKind kind : {CellKind::polygon, CellKind::tet})
        for (const compare::Mean& mean : compare::geometric_means(rows))
            if (mean.kind == kind)
                text += fmt::format("geometric mean, {} mesh{} of {}s: {} {:.3f} bits per cell\n",
                                    mean.meshes, mean.meshes == 1 ? "" : "es", name_of(kind),
                                    mean.codec, mean.bits_per_cell);
    text += ratio_lines(rows, CellKind::tet, "xz");
    text += ratio_lines(rows, CellKind::tet, "xz-grid");
    text += ratio_lines(rows, CellKind::polygon, "draco-triangles");
    text += ratio_lines(rows, CellKind::polygon, "draco-polygons");
    return text;
}

}  // namespace ravel::tool
