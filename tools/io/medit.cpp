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
    // Old spellings.
    if (same_word(keyword, "Hexaedra")) return medit_section("Hexahedra");
    if (same_word(keyword, "Pentahedra")) return medit_section("Prisms");
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
    Index first = kNoIndex;  // of these among the mesh's cells
};

struct Kept {
    std::string keyword;
    std::uint32_t arity = 1;
    std::vector<std::string_view> numbers;
    std::size_t at = 0;  // where in the file

    std::size_t rows() const { return numbers.size() / arity; }
    Array columns(std::uint32_t first, std::uint32_t last) const {
        TextNumbers column;
        for (std::size_t r = 0; r < rows(); ++r)
            for (std::uint32_t k = first; k < last; ++k) column.add(numbers[r * arity + k]);
        return column.take(last - first);
    }
};

class MeditReader {
  public:
    MeditReader(std::string_view text, const std::string& path)
        : in_(text, path, {.within_words = true}) {}
    Result<Mesh> read();

  private:
    Status keyword(const std::string& word);
    Status count(const std::string& what, std::size_t numbers_each, Index& value);
    Status vertices();
    Status cells(const MeditSection& section);
    Status keep(const std::string& word);
    void build();
    void take_cells(Cells& cells);
    void take_quadratic(const Cells& cells);
    Status take_kept(const Kept& kept);
    Status take_corners(const Kept& kept, const Cells& cells);
    Status cell_named(const Kept& kept, const Cells& cells, std::int64_t number);
    const Cells* named_cells(const MeditNames& names) const;
    void take_references();

    TextReader in_;
    Mesh mesh_;
    int dimension_ = 3;
    bool has_vertices_ = false;
    std::vector<double> positions_;
    std::vector<std::int64_t> point_references_, cell_references_, companion_references_;
    std::vector<Cells> sections_;
    std::vector<Kept> kept_;
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
    if (Status status = count("Vertices", static_cast<std::size_t>(dimension_) + 1, n); !status)
        return status;
    positions_.reserve(3 * n);
    point_references_.reserve(n);
    for (Index i = 0; i < n; ++i) {
        for (int k = 0; k < 3; ++k) {
            double x = 0;
            if (k < dimension_ && !in_.read(x))
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
    if (place == sections_.end()) place = sections_.insert(place, {&section, {}, {}, kNoIndex});
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
    Kept kept{word, 1, {}, in_.offset()};
    Index n = 1;
    const bool counted = medit_has_count(word);
    if (counted && !in_.read(n))
        return in_.expected("a known keyword with its count; this is what follows " + word);
    while (!in_.at_end() && !is_keyword(in_.peek())) {
        double ignored = 0;
        kept.numbers.push_back(in_.word());
        if (!parse_real(kept.numbers.back(), ignored))
            return in_.expected("a number of section " + word);
    }
    const std::size_t numbers = kept.numbers.size();
    constexpr std::size_t kMostEach = 65535;
    if (n == 0 ? numbers != 0 : numbers % n != 0 || numbers == 0 || numbers / n > kMostEach)
        return in_.error("section " + word + " promises " + std::to_string(n) + " rows, and has " +
                         std::to_string(numbers) + " numbers");
    if (n != 0) kept.arity = static_cast<std::uint32_t>(numbers / n);
    kept_.push_back(std::move(kept));
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
        if (!in_.read(dimension_) || dimension_ < 2 || dimension_ > 3)
            return in_.expected("the dimension, 2 or 3");
        if (has_vertices_) return in_.error("the dimension comes after the vertices");
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

void MeditReader::take_cells(Cells& cells) {
    cells.first = mesh_.cell_count();
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
    for (Cells& cells : sections_)
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
    if (dimension_ == 2) mesh_.notes.push_back({std::string(kMeditDimension), "2"});
}

// The cells a section's numbers are about; nullptr where these are points, companions or not there.
const Cells* MeditReader::named_cells(const MeditNames& names) const {
    for (const Cells& cells : sections_)
        if (cells.section->keyword == names.section && cells.first != kNoIndex) return &cells;
    return nullptr;
}

Status MeditReader::cell_named(const Kept& kept, const Cells& cells, std::int64_t number) {
    if (number >= 1 && static_cast<Index>(number) <= cells.references.size()) return Done{};
    in_.seek(kept.at);
    return in_.error("section " + kept.keyword + " names number " + std::to_string(number) +
                     " of " + std::to_string(cells.references.size()) + " " +
                     std::string(cells.section->keyword));
}

// Values at corners of cells, such as NormalAtTriangleVertices: a pool of them in the order of the
// rows, since a number of a corner could not follow a cell that is turned.
Status MeditReader::take_corners(const Kept& kept, const Cells& cells) {
    std::vector<Index> index(mesh_.corners.size(), kNoIndex);
    const Array where = kept.columns(0, 2);
    for (std::size_t r = 0; r < kept.rows(); ++r) {
        std::int64_t cell = 0, corner = 0;
        if (!integer_at(where, 2 * r, cell) || !integer_at(where, 2 * r + 1, corner)) cell = 0;
        if (Status status = cell_named(kept, cells, cell); !status) return status;
        const Index size = cells.section->nodes;
        const Index at = (static_cast<Index>(cell) - 1) * size + static_cast<Index>(corner) - 1;
        const Index first = mesh_.corner_begin[cells.first];
        if (corner < 1 || static_cast<Index>(corner) > size || index[first + at] != kNoIndex) {
            in_.seek(kept.at);
            return in_.error("section " + kept.keyword + " names corner " + std::to_string(corner) +
                             " of number " + std::to_string(cell) +
                             ", which is not there or comes twice");
        }
        index[first + at] = r;
    }
    add_attribute(mesh_, "medit:" + kept.keyword, Place::corner, kept.columns(2, kept.arity),
                  std::move(index));
    return Done{};
}

Status MeditReader::take_kept(const Kept& kept) {
    const std::string name = "medit:" + kept.keyword;
    const std::optional<MeditNames> names = medit_names(kept.keyword, kept.arity);
    const bool of_points = names && names->section == "Vertices";
    const Cells* cells = names && !of_points ? named_cells(*names) : nullptr;
    if (kept.numbers.empty() || !(of_points || cells)) {
        add_attribute(mesh_, name, Place::mesh, kept.columns(0, kept.arity));
        return Done{};
    }
    if (names->corners && mesh_.kind == CellKind::polygon) return take_corners(kept, *cells);
    const std::uint32_t whole = std::min(names->whole, kept.arity);
    Attribute& attribute = add_attribute(mesh_, name, Place::mesh, kept.columns(0, whole));
    if (!is_float(attribute.values.scalar)) {
        const std::int64_t base = cells ? 1 - static_cast<std::int64_t>(cells->first) : 1;
        for (std::uint32_t k = 0; k < names->columns; ++k)
            attribute.references.push_back({k, cells ? Place::cell : Place::point, base});
        for (std::size_t i = 0; cells && i < attribute.values.count() * whole; ++i) {
            std::int64_t number = 0;
            integer_at(attribute.values, i, number);
            if (i % whole >= names->columns) continue;
            if (Status status = cell_named(kept, *cells, number); !status) return status;
        }
    }
    if (whole < kept.arity)
        add_attribute(mesh_, name + ":reals", Place::mesh, kept.columns(whole, kept.arity));
    return Done{};
}

void MeditReader::take_references() {
    const auto add = [&](Place place, const std::vector<std::int64_t>& references) {
        if (any_non_zero(references))
            add_attribute(mesh_, "medit:ref", place, integers_from_text(references, 1));
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
    for (const Kept& kept : kept_)
        if (Status status = take_kept(kept); !status) return status.error();
    take_references();
    return std::move(mesh_);
}

}  // namespace

Result<Mesh> read_medit(const std::string& path) {
    Result<std::string> text = read_file(path);
    if (!text) return text.error();
    return MeditReader(*text, path).read();
}

}  // namespace ravel::io
