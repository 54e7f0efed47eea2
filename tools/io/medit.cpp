// MEDIT .mesh as text, reading. Sections of cells become cells and companions, one block per type;
// sections about the mesh (Corners, Ridges, Normals and so on) are kept as arrays of their numbers.
#include <algorithm>
#include <array>

#include "io/attributes.h"
#include "io/decimals.h"
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/medit_sections.h"
#include "io/text_reader.h"

namespace ravel::io {

const MeditSection* medit_section(std::string_view keyword) {
    for (const MeditSection& section : kMeditSections)
        if (same_word(section.keyword, keyword)) return &section;
    if (same_word(keyword, "Hexaedra")) return medit_section("Hexahedra");  // an old spelling
    return nullptr;
}

bool medit_has_count(std::string_view keyword) {
    return !same_word(keyword, "AngleOfCornerBound") && !same_word(keyword, "BoundingBox");
}

namespace {

struct Cells {
    const MeditSection* section = nullptr;
    std::vector<Index> nodes;
    std::vector<std::int64_t> references;
};

struct Kept {
    std::string keyword;
    TextNumbers numbers;
};

class MeditReader {
  public:
    MeditReader(std::string_view text, const std::string& path) : in_(text, path) {}
    Result<Mesh> read();

  private:
    Status keyword(const std::string& word);
    Status count(const std::string& what, std::size_t numbers_each, Index& value);
    Status vertices();
    Status cells(const MeditSection& section);
    Status keep(const std::string& word);
    void build();
    void take_cells(const Cells& cells);
    void take_quadratic(const Cells& cells);

    TextReader in_;
    Mesh mesh_;
    bool has_vertices_ = false;
    std::vector<double> positions_;
    std::vector<std::int64_t> point_references_, cell_references_, companion_references_;
    std::vector<Cells> sections_;
    // The largest point number, to be checked when all vertices are known.
    Index largest_ = 0;
    std::size_t largest_at_ = 0;
};

bool is_letter(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

bool is_keyword(std::string_view word) {
    double number = 0;  // "nan" and "inf" are letters too
    return !word.empty() && is_letter(word.front()) && !parse_real(word, number) &&
           std::all_of(word.begin(), word.end(),
                       [](char c) { return is_letter(c) || (c >= '0' && c <= '9'); });
}

bool any_non_zero(std::span<const std::int64_t> numbers) {
    return std::any_of(numbers.begin(), numbers.end(), [](std::int64_t n) { return n != 0; });
}

Status MeditReader::count(const std::string& what, std::size_t numbers_each, Index& value) {
    if (!in_.read(value)) return in_.expected("the number of " + what);
    if (value > (in_.bytes_left() + 1) / (2 * numbers_each))
        return in_.error(std::to_string(value) + " " + what + " are more than the file can hold");
    return Done{};
}

Status MeditReader::vertices() {
    if (has_vertices_) return in_.error("the section Vertices comes twice");
    has_vertices_ = true;
    Index n = 0;
    if (Status status = count("Vertices", 4, n); !status) return status;
    positions_.reserve(3 * n);
    point_references_.reserve(n);
    for (Index i = 0; i < n; ++i) {
        for (int k = 0; k < 3; ++k) {
            double x = 0;
            if (!in_.read(x))
                return in_.expected("a coordinate of vertex " + std::to_string(i + 1) + " of " +
                                    std::to_string(n));
            positions_.push_back(x);
        }
        std::int64_t reference = 0;
        if (!in_.read(reference))
            return in_.expected("the reference of vertex " + std::to_string(i + 1) +
                                ", an integer");
        point_references_.push_back(reference);
    }
    return Done{};
}

Status MeditReader::cells(const MeditSection& section) {
    auto place = std::find_if(sections_.begin(), sections_.end(),
                              [&](const Cells& c) { return c.section == &section; });
    if (place == sections_.end()) place = sections_.insert(place, {&section, {}, {}});
    const std::string name(section.keyword);
    Index n = 0;
    if (Status status = count(name, section.nodes + 1, n); !status) return status;
    place->nodes.reserve(place->nodes.size() + n * section.nodes);
    place->references.reserve(place->references.size() + n);
    for (Index i = 0; i < n; ++i) {
        for (std::uint32_t k = 0; k < section.nodes; ++k) {
            std::int64_t node = 0;
            if (!in_.read(node) || node < 1)
                return in_.expected("a vertex number from 1 on in row " + std::to_string(i + 1) +
                                    " of " + std::to_string(n) + " of " + name);
            place->nodes.push_back(static_cast<Index>(node) - 1);
            if (place->nodes.back() >= largest_) {
                largest_ = static_cast<Index>(node);
                largest_at_ = in_.offset();
            }
        }
        std::int64_t reference = 0;
        if (!in_.read(reference))
            return in_.expected("the reference of row " + std::to_string(i + 1) + " of " +
                                std::to_string(n) + " of " + name + ", an integer");
        place->references.push_back(reference);
    }
    return Done{};
}

Status MeditReader::keep(const std::string& word) {
    Kept kept{word, {}};
    Index n = 1;
    const bool counted = medit_has_count(word);
    if (counted && !in_.read(n))
        return in_.expected("a known keyword with its count; this is what follows " + word);
    while (!in_.at_end() && !is_keyword(in_.peek()))
        if (!kept.numbers.add(in_.word())) return in_.expected("a number of section " + word);
    const std::size_t numbers = kept.numbers.size();
    if (n == 0 ? numbers != 0 : numbers % n != 0 || numbers == 0)
        return in_.error("section " + word + " promises " + std::to_string(n) + " rows, and has " +
                         std::to_string(numbers) + " numbers");
    const auto arity = static_cast<std::uint32_t>(n == 0 ? 1 : numbers / n);
    add_attribute(mesh_, "medit:" + word, Place::mesh, kept.numbers.take(arity));
    return Done{};
}

Status MeditReader::keyword(const std::string& word) {
    if (same_word(word, "MeshVersionFormatted")) {
        std::int64_t version = 0;
        if (!in_.read(version) || version < 0 || version > 4)
            return in_.expected("a version from 1 to 4");
        return Done{};
    }
    if (same_word(word, "Dimension")) {
        std::int64_t dimension = 0;
        if (!in_.read(dimension)) return in_.expected("the dimension");
        if (dimension != 3)
            return in_.error("the mesh has dimension " + std::to_string(dimension) +
                             "; only three dimensions are read");
        return Done{};
    }
    if (same_word(word, "Vertices")) return vertices();
    if (const MeditSection* section = medit_section(word)) return cells(*section);
    return keep(word);
}

void MeditReader::take_quadratic(const Cells& cells) {
    CompanionBlock block{kQuadraticTet, 6, cells.references.size(), {}, {}};
    for (std::size_t c = 0; c < cells.references.size(); ++c) {
        const auto row = cells.nodes.begin() + static_cast<std::ptrdiff_t>(10 * c);
        block.hosts.push_back(mesh_.corners.size() / 4);
        mesh_.corners.insert(mesh_.corners.end(), row, row + 4);
        block.nodes.insert(block.nodes.end(), row + 4, row + 10);
    }
    cell_references_.insert(cell_references_.end(), cells.references.begin(),
                            cells.references.end());
    companion_references_.resize(companion_references_.size() + cells.references.size());
    mesh_.companions.push_back(std::move(block));
}

void MeditReader::take_cells(const Cells& cells) {
    mesh_.corners.insert(mesh_.corners.end(), cells.nodes.begin(), cells.nodes.end());
    cell_references_.insert(cell_references_.end(), cells.references.begin(),
                            cells.references.end());
    if (mesh_.kind == CellKind::tet) return;
    for (std::size_t c = 0; c < cells.references.size(); ++c)
        mesh_.corner_begin.push_back(mesh_.corner_begin.back() + cells.section->nodes);
}

void MeditReader::build() {
    // Tetrahedra, or else triangles and quadrilaterals, are the cells; all others ride along.
    bool tets = false, polygons = false, tet_section = false;
    for (const Cells& cells : sections_) {
        const bool is_tet = cells.section->use == MeditUse::tet;
        tet_section = tet_section || is_tet;
        tets = tets || (is_tet && !cells.references.empty());
        polygons =
            polygons || (cells.section->use == MeditUse::polygon && !cells.references.empty());
    }
    mesh_.kind = tets || (tet_section && !polygons) ? CellKind::tet : CellKind::polygon;
    if (mesh_.kind == CellKind::polygon) mesh_.corner_begin = {0};
    const MeditUse main = mesh_.kind == CellKind::tet ? MeditUse::tet : MeditUse::polygon;
    for (const Cells& cells : sections_)
        if (cells.section->use == main && cells.section->vtk_type != kQuadraticTet)
            take_cells(cells);
    // Edge nodes before other companions, so that writing does not change the order.
    for (const Cells& cells : sections_)
        if (cells.section->vtk_type == kQuadraticTet && !cells.references.empty())
            take_quadratic(cells);
    for (const Cells& cells : sections_) {
        if (cells.section->use == main || cells.section->vtk_type == kQuadraticTet ||
            cells.references.empty())
            continue;
        mesh_.companions.push_back({cells.section->vtk_type,
                                    cells.section->nodes,
                                    cells.references.size(),
                                    cells.nodes,
                                    {}});
        companion_references_.insert(companion_references_.end(), cells.references.begin(),
                                     cells.references.end());
    }
    mesh_.positions = floats_from_text(positions_, 3);
    const auto add = [&](Place place, const std::vector<std::int64_t>& references) {
        if (any_non_zero(references))
            mesh_.attributes.push_back({"medit:ref", place, integers_from_text(references, 1), {}});
    };
    add(Place::point, point_references_);
    add(Place::cell, cell_references_);
    add(Place::companion, companion_references_);
}

Result<Mesh> MeditReader::read() {
    while (true) {
        const std::string word(in_.word());
        if (word.empty() || same_word(word, "End")) break;
        if (!is_keyword(word)) return in_.expected("a keyword of a MEDIT mesh");
        if (Status status = keyword(word); !status) return status.error();
    }
    if (!has_vertices_) return in_.error("the file ends without a section Vertices");
    if (largest_ > point_references_.size()) {
        in_.seek(largest_at_);
        return in_.error("names vertex " + std::to_string(largest_) + ", but the file has " +
                         std::to_string(point_references_.size()));
    }
    build();
    return std::move(mesh_);
}

}  // namespace

Result<Mesh> read_medit(const std::string& path) {
    Result<std::string> text = read_file(path);
    if (!text) return text.error();
    return MeditReader(*text, path).read();
}

}  // namespace ravel::io
