#include "compare/compare.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "compare/contender.h"
#include "compare/round.h"

namespace ravel::compare {
namespace {

std::vector<Contender> all_contenders() {
    return {ours(),   draco_triangles(), draco_polygons(), raw_zstd(),
            raw_xz(), grid_xz(),         delta_xz()};
}

// The shortest of some runs: the first pays for fresh memory, any may be disturbed.
template <class F>
auto timed(std::optional<double>& seconds, F work) {
    constexpr int kMostRuns = 5;
    constexpr double kEnough = 0.5;
    const auto timed_once = [&](auto& result) {
        const auto start = std::chrono::steady_clock::now();
        result.emplace(work());
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    std::optional<decltype(work())> result;
    double all = *(seconds = timed_once(result));
    for (int run = 1; run < kMostRuns && all < kEnough; ++run) {
        const double once = timed_once(result);
        seconds = std::min(*seconds, once);
        all += once;
    }
    return std::move(*result);
}

void run(const Contender& contender, const Input& input, bool keep_file, Row& row) {
    row.note = contender.refuses(input);
    if (!row.note.empty()) return;
    auto packed = timed(row.encode_seconds, [&] { return contender.encode(input); });
    if (!packed) {
        row.encode_seconds.reset();
        row.note = "can't encode: " + packed.error().detail;
        return;
    }
    row.bytes = packed->bytes.size();
    row.connectivity_bytes = packed->connectivity_bytes;
    row.geometry_bytes = packed->geometry_bytes;
    row.attribute_bytes = packed->attribute_bytes;
    row.connectivity_ideal_bytes = packed->connectivity_ideal_bytes;
    if (contender.connectivity) {
        row.connectivity_bytes = contender.connectivity(input);
        if (row.connectivity_bytes && *row.connectivity_bytes <= *row.bytes)
            row.geometry_bytes = *row.bytes - *row.connectivity_bytes;
    }
    auto decoded =
        timed(row.decode_seconds, [&] { return contender.decode(packed->bytes, input); });
    if (!decoded) {
        row.decode_seconds.reset();
        row.connectivity_kept = "lost";
        row.note = "can't decode: " + decoded.error().detail;
        return;
    }
    const Verdict verdict = contender.check(input, *packed, *decoded);
    row.connectivity_kept = verdict.connectivity_kept;
    row.max_error = verdict.max_error;
    row.note = verdict.note;
    if (keep_file && row.codec == "ravel") row.file = std::move(packed->bytes);
}

}  // namespace

std::vector<std::string> known_codecs() {
    std::vector<std::string> names;
    for (const Contender& contender : all_contenders()) names.emplace_back(contender.name);
    return names;
}

std::vector<Row> compare_mesh(const std::string& name, Mesh mesh, const Request& request,
                              const std::string& settings) {
    Input input;
    input.options = request.options;
    round_if_asked(mesh, request.options);  // before anybody sees it, so that all pack the same
    input.grid = grid_for(mesh, request.options);
    if (!request.attributes) {
        mesh.attributes.clear();
        // The nodes of quadratic tets' edges stay: they are what the points that no corner names
        // are for. Peers get these as points that are just there.
        std::erase_if(mesh.companions, [](const CompanionBlock& block) {
            return block.vtk_type != 24 || block.nodes_per_cell != 6;
        });
        mesh.tag_names.clear();
        mesh.notes.clear();
    }
    input.mesh = std::move(mesh);
    std::vector<Row> rows;
    for (const std::string& codec : request.codecs)
        for (const Contender& contender : all_contenders()) {
            if (codec != contender.name) continue;
            Row row;
            row.mesh = name;
            row.cells = input.mesh.cell_count();
            row.kind = input.mesh.kind;
            row.vertices = input.mesh.point_count();
            row.codec = codec;
            row.settings = settings;
            if (*contender.settings) row.settings += std::string("; ") + contender.settings;
            run(contender, input, request.keep_file, row);
            rows.push_back(std::move(row));
        }
    return rows;
}

double bits_per_cell(const Row& row) {
    return row.bytes && row.cells > 0
               ? 8.0 * static_cast<double>(*row.bytes) / static_cast<double>(row.cells)
               : 0;
}

std::vector<Mean> geometric_means(const std::vector<Row>& rows) {
    std::vector<Mean> means;
    for (const Row& row : rows) {
        if (bits_per_cell(row) <= 0) continue;
        Mean* mean = nullptr;
        for (Mean& known : means)
            if (known.kind == row.kind && known.codec == row.codec) mean = &known;
        if (!mean) mean = &means.emplace_back(Mean{row.kind, row.codec, 0, 0});
        ++mean->meshes;
        mean->bits_per_cell += std::log(bits_per_cell(row));
    }
    for (Mean& mean : means)
        mean.bits_per_cell = std::exp(mean.bits_per_cell / static_cast<double>(mean.meshes));
    return means;
}

Ratios ratios_to(const std::vector<Row>& rows, CellKind kind, const std::string& peer) {
    Ratios ratios{peer, {}, {}};
    for (const Row& ours : rows) {
        if (ours.kind != kind || ours.codec != "ravel" || !ours.bytes) continue;
        for (const Row& theirs : rows) {
            if (theirs.mesh != ours.mesh || theirs.codec != peer || !theirs.bytes) continue;
            ratios.all.emplace_back(
                ours.mesh, static_cast<double>(*ours.bytes) / static_cast<double>(*theirs.bytes));
            if (*ours.bytes >= *theirs.bytes) ratios.lost.push_back(ours.mesh);
        }
    }
    return ratios;
}

}  // namespace ravel::compare
