// MEDIT .mesh as text, writing. Each section comes once, as other programs ask for.
#include <algorithm>
#include <array>
#include <cmath>

#include "io/attributes.h"
#include "io/decimals.h"
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/left_out.h"
#include "io/medit_sections.h"

namespace ravel::io {

namespace {

bool lies_in_plane(const Mesh& mesh) {
    for (Index p = 0; p < mesh.point_count(); ++p) {
        const std::size_t z = 3 * p + 2;
        const double height = mesh.positions.scalar == Scalar::f32
                                  ? static_cast<double>(mesh.positions.as<float>()[z])
                                  : mesh.positions.as<double>()[z];
        if (height != 0 || std::signbit(height)) return false;
    }
    return true;
}

class MeditWriter {
  public:
    MeditWriter(const Mesh& mesh, const std::string& path)
        : mesh_(mesh), path_(path), left_out_(mesh, "MEDIT") {}

    Status write(Sentences* sentences);

  private:
    void append_head();
    const Attribute* references(Place place);
    void append_reference(const Attribute* attribute, Index element);
    void append_nodes(std::span<const Index> nodes);
    void begin_section(std::string_view keyword, Index count);
    void append_vertices();
    void append_tets();
    Status append_polygons();
    void append_companions();
    void append_kept();
    void append_rows(const Attribute& attribute, const Attribute* reals);
    bool append_corner_rows(const Attribute& attribute, const std::string& keyword);

    const Mesh& mesh_;
    const std::string& path_;
    LeftOut left_out_;
    std::string out_;
    std::size_t dimension_ = 3;
    std::vector<Index> number_of_cell_;  // from 1 on in the section that it was written to
};

const Attribute* MeditWriter::references(Place place) {
    const Attribute* attribute = find_attribute(mesh_, place, "medit:ref");
    if (!attribute || attribute->values.arity != 1 || is_float(attribute->values.scalar) ||
        !attribute->index.empty() || !all_integers(attribute->values))
        return nullptr;
    left_out_.take(attribute);
    return attribute;
}

void MeditWriter::append_reference(const Attribute* attribute, Index element) {
    if (attribute) {
        append_number(out_, attribute->values, element);
    } else {
        out_ += '0';
    }
    out_ += '\n';
}

void MeditWriter::append_nodes(std::span<const Index> nodes) {
    for (const Index node : nodes) {
        append_number(out_, node + 1);
        out_ += ' ';
    }
}

void MeditWriter::begin_section(std::string_view keyword, Index count) {
    out_ += keyword;
    out_ += '\n';
    append_number(out_, count);
    out_ += '\n';
}

void MeditWriter::append_vertices() {
    const Attribute* refs = references(Place::point);
    begin_section("Vertices", mesh_.point_count());
    for (Index p = 0; p < mesh_.point_count(); ++p) {
        for (std::size_t k = 0; k < dimension_; ++k) {
            append_number(out_, mesh_.positions, 3 * p + k);
            out_ += ' ';
        }
        append_reference(refs, p);
    }
}

// Tets with edge nodes go to TetrahedraP2, the others to Tetrahedra. A file has the latter first,
// so hosts in any other order change the order of the tets.
void MeditWriter::append_tets() {
    const Attribute* refs = references(Place::cell);
    const CompanionBlock* middles = nullptr;
    std::vector<Index> middle_of(mesh_.cell_count(), kNoIndex);
    for (std::size_t b = 0; b < mesh_.companions.size() && !middles; ++b) {
        const CompanionBlock& block = mesh_.companions[b];
        if (block.vtk_type != kQuadraticTet || block.nodes_per_cell != 6 ||
            block.hosts.size() != block.cell_count)
            continue;
        const bool one_each = std::adjacent_find(block.hosts.begin(), block.hosts.end(),
                                                 std::greater_equal<>()) == block.hosts.end();
        if (!one_each) continue;
        middles = &block;
        left_out_.take_block(b);
        for (Index i = 0; i < block.cell_count; ++i) middle_of[block.hosts[i]] = i;
    }
    const Index quadratic = middles ? middles->cell_count : 0;
    if (quadratic != 0 && middles->hosts.front() != mesh_.cell_count() - quadratic)
        left_out_.say(
            "the order of the tets has no place in MEDIT: tets with edge nodes come last");
    if (quadratic != mesh_.cell_count() || quadratic == 0) {
        begin_section("Tetrahedra", mesh_.cell_count() - quadratic);
        Index number = 0;
        for (Index c = 0; c < mesh_.cell_count(); ++c) {
            if (middle_of[c] != kNoIndex) continue;
            number_of_cell_[c] = ++number;
            append_nodes(mesh_.cell(c));
            append_reference(refs, c);
        }
    }
    if (quadratic == 0) return;
    begin_section("TetrahedraP2", quadratic);
    for (Index i = 0; i < quadratic; ++i) {
        append_nodes(mesh_.cell(middles->hosts[i]));
        append_nodes({middles->nodes.data() + 6 * i, 6});
        number_of_cell_[middles->hosts[i]] = i + 1;
        append_reference(refs, middles->hosts[i]);
    }
}

Status MeditWriter::append_polygons() {
    const Attribute* refs = references(Place::cell);
    std::vector<std::size_t> sizes;  // in order of first appearance
    std::size_t changes = 0, last = 0;
    for (Index c = 0; c < mesh_.cell_count(); ++c) {
        const std::size_t size = mesh_.cell(c).size();
        if (size != 3 && size != 4)
            return cannot_hold(path_, "MEDIT holds triangles and quadrilaterals, and cell " +
                                          std::to_string(c) + " has " + std::to_string(size) +
                                          " corners");
        if (size != last) ++changes;
        last = size;
        if (std::find(sizes.begin(), sizes.end(), size) == sizes.end()) sizes.push_back(size);
    }
    if (changes > sizes.size())
        left_out_.say(
            "the order of the cells has no place in MEDIT: triangles and quadrilaterals "
            "are apart");
    for (const std::size_t size : sizes) {
        Index count = 0;
        for (Index c = 0; c < mesh_.cell_count(); ++c) count += mesh_.cell(c).size() == size;
        begin_section(size == 3 ? "Triangles" : "Quadrilaterals", count);
        Index number = 0;
        for (Index c = 0; c < mesh_.cell_count(); ++c) {
            if (mesh_.cell(c).size() != size) continue;
            number_of_cell_[c] = ++number;
            append_nodes(mesh_.cell(c));
            append_reference(refs, c);
        }
    }
    return Done{};
}

void MeditWriter::append_companions() {
    const Attribute* refs = references(Place::companion);
    std::vector<const MeditSection*> sections;
    const auto section_of = [&](const CompanionBlock& block) -> const MeditSection* {
        if (block.cell_count == 0 || block.vtk_type == kQuadraticTet) return nullptr;
        for (const MeditSection& section : kMeditSections) {
            const bool is_cell = mesh_.kind == CellKind::tet ? section.use == MeditUse::tet
                                                             : section.use != MeditUse::other;
            if (section.vtk_type == block.vtk_type && section.nodes == block.nodes_per_cell &&
                !is_cell)
                return &section;
        }
        return nullptr;
    };
    for (const CompanionBlock& block : mesh_.companions)
        if (const MeditSection* section = section_of(block))
            if (std::find(sections.begin(), sections.end(), section) == sections.end())
                sections.push_back(section);
    for (const MeditSection* section : sections) {
        Index count = 0;
        for (const CompanionBlock& block : mesh_.companions)
            if (section_of(block) == section) count += block.cell_count;
        begin_section(section->keyword, count);
        Index first = 0;
        for (std::size_t b = 0; b < mesh_.companions.size(); ++b) {
            const CompanionBlock& block = mesh_.companions[b];
            if (section_of(block) == section) {
                left_out_.take_block(b);
                for (Index c = 0; c < block.cell_count; ++c) {
                    append_nodes({block.nodes.data() + c * section->nodes, section->nodes});
                    append_reference(refs, first + c);
                }
            }
            first += block.cell_count;
        }
    }
}

// Rows of an attribute and, behind them, those of its reals. Numbers of points and cells become
// those of this file.
void MeditWriter::append_rows(const Attribute& attribute, const Attribute* reals) {
    const Array& values = attribute.values;
    const auto append = [&](std::size_t row, std::uint32_t k) {
        const std::size_t flat = row * values.arity + k;
        for (const Reference& r : attribute.references) {
            std::int64_t number = 0;
            if (r.component != k || !integer_at(values, flat, number)) continue;
            const Index named = static_cast<Index>(number) - static_cast<Index>(r.base);
            if (named >= element_count(mesh_, r.place)) continue;
            append_number(out_, r.place == Place::cell ? number_of_cell_[named] : named + 1);
            return;
        }
        append_number(out_, values, flat);
    };
    for (std::size_t row = 0; row < values.count(); ++row) {
        for (std::uint32_t k = 0; k < values.arity; ++k) {
            if (k != 0) out_ += ' ';
            append(row, k);
        }
        for (std::uint32_t k = 0; reals && k < reals->values.arity; ++k) {
            out_ += ' ';
            append_number(out_, reals->values, row * reals->values.arity + k);
        }
        out_ += '\n';
    }
}

// Rows of a cell, a corner of it and a value, in the order of the values. False where the values
// are not those of one corner each, of cells of the right size.
bool MeditWriter::append_corner_rows(const Attribute& attribute, const std::string& keyword) {
    const std::optional<MeditNames> names = medit_names(keyword, attribute.values.arity + 2);
    if (!names || !names->corners || mesh_.kind != CellKind::polygon || attribute.index.empty())
        return false;
    const std::size_t size = medit_section(names->section)->nodes;
    const Array& values = attribute.values;
    std::vector<std::array<Index, 2>> place(values.count(), {kNoIndex, 0});  // cell and corner
    for (Index c = 0; c < mesh_.cell_count(); ++c) {
        for (Index k = 0; k < mesh_.cell(c).size(); ++k) {
            const Index row = attribute.index[mesh_.corner_begin[c] + k];
            if (row == kNoIndex) continue;
            if (mesh_.cell(c).size() != size || place[row][0] != kNoIndex) return false;
            place[row] = {c, k};
        }
    }
    for (const auto& [cell, corner] : place)
        if (cell == kNoIndex) return false;
    begin_section(keyword, values.count());
    for (std::size_t row = 0; row < values.count(); ++row) {
        append_number(out_, number_of_cell_[place[row][0]]);
        out_ += ' ';
        append_number(out_, place[row][1] + 1);
        out_ += ' ';
        for (std::uint32_t k = 0; k < values.arity; ++k) {
            append_number(out_, values, row * values.arity + k);
            out_ += k + 1 == values.arity ? '\n' : ' ';
        }
    }
    return true;
}

void MeditWriter::append_kept() {
    constexpr std::string_view kPrefix = "medit:", kReals = ":reals";
    const std::vector<Attribute>& all = mesh_.attributes;
    for (std::size_t a = 0; a < all.size(); ++a) {
        const Attribute& attribute = all[a];
        if (!attribute.name.starts_with(kPrefix)) continue;
        const std::string keyword = attribute.name.substr(kPrefix.size());
        const bool is_word =
            !keyword.empty() && std::all_of(keyword.begin(), keyword.end(), [](char c) {
                return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
            });
        if (!is_word) continue;
        if (attribute.place == Place::corner && append_corner_rows(attribute, keyword))
            left_out_.take(&attribute);
        const std::size_t rows = attribute.values.count();
        if (attribute.place != Place::mesh || (!medit_has_count(keyword) && rows != 1)) continue;
        const bool more = a + 1 < all.size() && all[a + 1].place == Place::mesh &&
                          all[a + 1].name == attribute.name + std::string(kReals) &&
                          all[a + 1].values.count() == rows;
        left_out_.take(&attribute);
        if (more) left_out_.take(&all[a + 1]);
        if (medit_has_count(keyword)) {
            begin_section(keyword, rows);
        } else {
            out_ += keyword + "\n";
        }
        append_rows(attribute, more ? &all[a + 1] : nullptr);
    }
}

// Two dimensions where the mesh was read from two, and still lies in that plane.
void MeditWriter::append_head() {
    if (find_note(mesh_, kMeditDimension) != nullptr && lies_in_plane(mesh_)) {
        dimension_ = 2;
        left_out_.take_notes(kMeditDimension);
    }
    out_ = "MeshVersionFormatted ";
    out_ += mesh_.positions.scalar == Scalar::f32 ? '1' : '2';
    out_ += "\nDimension ";
    append_number(out_, dimension_);
    out_ += '\n';
}

Status MeditWriter::write(Sentences* sentences) {
    append_head();
    append_vertices();
    number_of_cell_.resize(mesh_.cell_count());
    if (mesh_.kind == CellKind::tet) {
        append_tets();
    } else if (Status status = append_polygons(); !status) {
        return status;
    }
    append_companions();
    append_kept();
    out_ += "End\n";
    left_out_.report(sentences);
    return write_file(path_, out_);
}

}  // namespace

Status write_medit(const Mesh& mesh, const std::string& path, const WriteOptions&,
                   Sentences* left_out) {
    return MeditWriter(mesh, path).write(left_out);
}

}  // namespace ravel::io
