// The paper's figures are copied from its tables. It counts cycles after fan merges and before
// splits; that is one more than the splits of a component, and so are ours. Its strips of tets are
// the unmatched edges of the template's matching, ours beside it, too.
#include "ravel/strip_tables.h"

#include <array>
#include <cmath>
#include <optional>

#include "ravel/wind.h"

namespace ravel::tool {
namespace {

struct Table1 {
    const char* model;
    int faces, final_faces;
    double increase;
    int nodal, splits;
    double seconds;
};
constexpr std::array<Table1, 3> kTable1{{{"Sphere", 640, 646, 0.9, 26, 1, 0.12},
                                         {"Trico", 2830, 2902, 2.5, 119, 12, 0.99},
                                         {"Blob", 8020, 8146, 1.6, 334, 21, 6.89}}};

struct Table2 {
    const char* model;
    int tets, vertices, nodal, cycles, linear;
    double more_tets, more_vertices, seconds;
};
constexpr std::array<Table2, 5> kTable2{{{"Trico", 15310, 4633, 139, 376, 12, 9.8, 8.1, 132},
                                         {"Fandisk", 22491, 7144, 290, 471, 2, 8.3, 6.6, 414},
                                         {"Ball", 430, 162, 3, 9, 0, 7.4, 4.9, 1},  // "<1" seconds
                                         {"Spring", 24359, 7226, 326, 737, 4, 12.1, 10.2, 415},
                                         {"Blob", 31526, 8769, 197, 974, 66, 12.3, 11.1, 527}}};

// The entry whose size (the first number) is nearest, within a quarter more or less.
template <class Rows, class Size>
auto like_size(const Rows& rows, double cells, Size size) {
    std::optional<typename Rows::value_type> best;
    double nearest = std::log(1.25);
    for (const auto& row : rows) {
        const double far = std::fabs(std::log(cells / size(row)));
        if (far < nearest) {
            nearest = far;
            best = row;
        }
    }
    return best;
}

Json row_of(const Table1& paper) {
    Json row;
    row["model"] = paper.model;
    row["by"] = "paper, two-pass";
    row["faces"] = paper.faces;
    row["final_faces"] = paper.final_faces;
    row["increase_percent"] = paper.increase;
    row["nodal_vertices"] = paper.nodal;
    row["edge_splits"] = paper.splits;
    row["seconds"] = paper.seconds;
    return row;
}

Json row_of(const Table2& paper) {
    Json row;
    row["model"] = paper.model;
    row["by"] = "paper, template";
    row["tets"] = paper.tets;
    row["vertices"] = paper.vertices;
    row["nodal_edges"] = paper.nodal;
    row["cycles"] = paper.cycles;
    row["linear_strips"] = paper.linear;
    row["tets_increase_percent"] = paper.more_tets;
    row["vertices_increase_percent"] = paper.more_vertices;
    row["seconds"] = paper.seconds;
    return row;
}

double percent(Index part, Index whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

Json row_of(const std::string& model, const std::string& by, const Mesh& mesh, const Wound& wound) {
    const StripCounts& counts = wound.strip.counts;
    const Index cells = mesh.cell_count();
    Json row;
    row["model"] = model;
    row["by"] = by;
    if (mesh.kind == CellKind::polygon) {
        row["faces"] = cells;
        row["final_faces"] = cells + wound.made.added_cells;
        row["increase_percent"] = percent(wound.made.added_cells, cells);
        row["nodal_vertices"] = counts.fan_merges;
        row["edge_splits"] = counts.links;
    } else {
        row["tets"] = cells;
        row["vertices"] = mesh.point_count();
        row["nodal_edges"] = counts.fan_merges;
        row["cycles"] = counts.links + counts.strips - counts.open_strips;
        row["linear_strips"] = counts.open_strips;
        row["tets_increase_percent"] = percent(wound.made.added_cells, cells);
        row["vertices_increase_percent"] = percent(wound.made.added_points, mesh.point_count());
    }
    row["seconds"] = wound.seconds;
    return row;
}

}  // namespace

std::vector<std::string> table_columns(CellKind kind) {
    if (kind == CellKind::polygon)
        return {"model",          "by",          "faces",  "final_faces", "increase_percent",
                "nodal_vertices", "edge_splits", "seconds"};
    return {"model",
            "by",
            "tets",
            "vertices",
            "nodal_edges",
            "cycles",
            "linear_strips",
            "tets_increase_percent",
            "vertices_increase_percent",
            "seconds"};
}

Status add_table_rows(const std::string& model, const Mesh& mesh, Json& rows) {
    const auto cells = static_cast<double>(mesh.cell_count());
    struct Run {
        const char* by;
        FactorMethod method;
        StripOptions options;
    };
    std::vector<Run> runs;
    if (mesh.kind == CellKind::polygon) {
        if (const auto paper = like_size(kTable1, cells, [](const Table1& t) { return t.faces; }))
            rows.push_back(row_of(*paper));
        runs = {{"two-pass, fans only", FactorMethod::two_pass, {0}}};
    } else {
        if (const auto paper = like_size(kTable2, cells, [](const Table2& t) { return t.tets; }))
            rows.push_back(row_of(*paper));
        const FactorMethod method = FactorMethod::template_substitution;
        runs = {{"template, unmatched, fans only", method, {0, Reading::unmatched}},
                {"template, fans only", method, {0}}};
    }
    runs.push_back({"steered (default)", FactorMethod::steered, {}});
    for (const Run& run : runs) {
        const auto wound = wind(mesh, {run.method, run.options, {}});
        if (!wound) return wound.error();
        rows.push_back(row_of(model, run.by, mesh, *wound));
    }
    return Done{};
}

}  // namespace ravel::tool
