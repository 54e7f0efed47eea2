// ravel compare MESH...: ravel beside Draco and general compressors, every result checked.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "compare/compare.h"
#include "ravel/compare_report.h"
#include "ravel/encode_options.h"
#include "ravel/input_file.h"
#include "ravel/output_file.h"
#include "ravel/progress.h"
#include "ravel/talk.h"
#include "ravel/verbs.h"
#include "ravel/viewer_page.h"

namespace ravel::tool {
namespace {

struct Options {
    std::vector<std::string> meshes;
    std::string codecs, html;
    bool json = false, csv = false, markdown = false, attributes = false;
    EncodeFlags flags;
};

const std::vector<std::string> kTextColumns = {"mesh",
                                               "cells",
                                               "cell_kind",
                                               "codec",
                                               "bytes",
                                               "bits_per_cell",
                                               "connectivity_bits_per_cell",
                                               "encode_seconds",
                                               "decode_seconds",
                                               "max_error",
                                               "connectivity_kept",
                                               "note"};

Result<std::vector<std::string>> codecs_of(const std::string& list) {
    const std::vector<std::string> known = compare::known_codecs();
    if (list.empty()) return known;
    std::vector<std::string> chosen;
    std::istringstream words(list);
    for (std::string word; std::getline(words, word, ',');) {
        if (std::find(known.begin(), known.end(), word) == known.end()) {
            std::string all;
            for (const std::string& name : known) all += " " + name;
            return Error{Code::bad_option, 0, "no codec \"" + word + "\"; there are:" + all};
        }
        chosen.push_back(word);
    }
    return chosen;
}

// Rows tell meshes by their stem, or by their path where another mesh has the same stem. A path
// that comes twice counts once.
std::vector<std::pair<std::string, std::string>> names_and_paths(std::vector<std::string> paths) {
    std::vector<std::pair<std::string, std::string>> meshes;
    std::map<std::string, int> stems;
    const auto stem_of = [](const std::string& path) {
        return std::filesystem::path(path).stem().string();
    };
    std::set<std::string> known;
    for (std::string& path : paths)
        if (known.insert(path).second) meshes.emplace_back(stem_of(path), std::move(path));
    for (const auto& [stem, path] : meshes) ++stems[stem];
    for (auto& [name, path] : meshes)
        if (stems[name] > 1) name = path;
    return meshes;
}

// The viewer with the packed files in it; the bare table where the viewer was not built.
std::string page_of(const std::vector<compare::Row>& rows, const Json& facts,
                    const std::string& summary) {
    auto page = viewer_page(viewer_data(rows, facts, summary));
    if (page) return std::move(*page);
    remark("--html: a table only, for " + page.error().detail);
    return html_of(facts, "ravel and its peers", summary);
}

ExitCode print(const Options& options, const std::vector<compare::Row>& rows) {
    const Json facts = json_rows(rows);
    const std::string summary = summary_of(rows);
    if (!options.html.empty()) {
        const std::string page = page_of(rows, facts, summary);
        const auto bytes = std::as_bytes(std::span(page));
        if (Status status = write_bytes_output(options.html, bytes, true); !status)
            return complain(options.html, status.error());
        if (options.html == "-") return ExitCode::done;
    }
    if (options.json)
        fmt::print("{}", json_of(facts));
    else if (options.csv)
        fmt::print("{}", csv_of(facts));
    else if (options.markdown)
        fmt::print("{}\n{}", markdown_of(facts, kTextColumns), summary);
    else
        fmt::print("{}\n{}", table_of(facts, kTextColumns), summary);
    return ExitCode::done;
}

ExitCode run(const Options& options) {
    auto codecs = codecs_of(options.codecs);
    if (!codecs) return complain("", codecs.error());
    compare::Request request;
    request.options = options_of(options.flags);
    request.attributes = options.attributes;
    request.codecs = *codecs;
    request.keep_file = !options.html.empty();
    const std::string settings = words_for(request.options);
    std::vector<compare::Row> rows;
    ExitCode worst = ExitCode::done;
    const auto meshes = names_and_paths(options.meshes);
    for (const auto& [name, path] : meshes) {
        Progress progress(path, "comparing");
        auto mesh = read_mesh_input(path, "");
        if (!mesh) {
            worst = complain(path, mesh.error());
            continue;
        }
        if (meshes.size() > 1) remark(path);
        for (compare::Row& row : compare::compare_mesh(name, std::move(*mesh), request, settings)) {
            if (row.codec == "ravel" && !row.note.empty()) {
                remark(fmt::format("{}: {}", path, row.note));
                worst = ExitCode::no;
            }
            rows.push_back(std::move(row));
        }
    }
    const ExitCode printed = print(options, rows);
    return printed == ExitCode::done ? worst : printed;
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb =
        app.add_subcommand("compare", "Ravel beside Draco, zstd and xz, every result checked");
    std::string codecs;
    for (const std::string& name : compare::known_codecs())
        codecs += (codecs.empty() ? "" : ",") + name;
    verb->add_option("MESH", options->meshes, "Meshes")->required();
    verb->add_option("--codecs", options->codecs, "Which codecs, by commas: " + codecs)
        ->type_name("LIST");
    verb->add_flag(
        "--attributes", options->attributes,
        "Give ravel attributes, companions and names too (peers get cells and positions)");
    auto* json = verb->add_flag("--json", options->json, "Rows as a JSON array");
    auto* csv = verb->add_flag("--csv", options->csv, "Rows as CSV");
    auto* markdown = verb->add_flag("--markdown", options->markdown, "A table in Markdown");
    json->excludes(csv)->excludes(markdown);
    csv->excludes(markdown);
    verb->add_option("--html", options->html,
                     "A page as well: the viewer with the packed meshes and all numbers in it")
        ->type_name("FILE");
    add_encode_flags(*verb, options->flags);
    verb->footer(
        "Every codec gets the same cells and positions; what it gives back is decoded and "
        "checked.\n"
        "connectivity_kept: quads (polygons of any degree) or tets came back as they were, "
        "triangulated\n"
        "(as the fans of the polygons), or something was lost; the note says what.\n"
        "Draco's connectivity bytes are those of the same mesh with all positions zero.\n\n"
        "Example:\n"
        "  ravel compare *.obj --position-bits 14 --codecs ravel,draco-polygons --markdown");
    verb->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace ravel::tool
