// TetGen's .node, .ele, .face and .edge, writing.
#include <algorithm>

#include "io/attributes.h"
#include "io/decimals.h"
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/left_out.h"
#include "io/tetgen_files.h"

namespace ravel::io {

namespace {

class TetgenWriter {
  public:
    TetgenWriter(const Mesh& mesh, const std::string& path)
        : mesh_(mesh), paths_(tetgen_paths(path)), left_out_(mesh, "TetGen's files") {
        const Note* first = find_note(mesh, "tetgen:first");
        first_ = first && first->text == "1" ? 1 : 0;
        left_out_.take_notes("tetgen:first");
    }

    Status write(Sentences* sentences) {
        if (Status status = nodes(); !status) return status;
        if (Status status = tets(); !status) return status;
        markers_ = column(Place::companion, "tetgen:marker", true);
        if (markers_ && markers_->values.arity != 1) markers_ = nullptr;
        left_out_.take(markers_);
        left_out_.take_notes("tetgen:unmarked");
        if (Status status = companions(paths_.face, "face", {kTetgenTriangle, kTetgenTriangle6});
            !status)
            return status;
        if (Status status = companions(paths_.edge, "edge", {kTetgenLine, kTetgenLine3}); !status)
            return status;
        left_out_.report(sentences);
        return Done{};
    }

  private:
    // An attribute with a value for every element, and whole numbers where the format wants them.
    const Attribute* column(Place place, std::string_view name, bool whole) {
        const Attribute* attribute = find_attribute(mesh_, place, name);
        if (!attribute || !attribute->index.empty()) return nullptr;
        if (whole && !all_integers(attribute->values)) return nullptr;
        return attribute;
    }
    void append(std::string& out, const Attribute* attribute, Index element) {
        if (!attribute) return;
        for (std::uint32_t k = 0; k < attribute->values.arity; ++k) {
            out += ' ';
            append_number(out, attribute->values, element * attribute->values.arity + k);
        }
    }
    void append_index(std::string& out, Index index) {
        out += ' ';
        append_number(out, index + first_);
    }
    Status nodes();
    Status tets();
    Status companions(const std::string& path, const std::string& name,
                      std::pair<std::uint16_t, std::uint16_t> types);

    const Mesh& mesh_;
    TetgenPaths paths_;
    LeftOut left_out_;
    Index first_ = 0;
    bool quadratic_ = false;
    const Attribute* markers_ = nullptr;
};

std::string words(std::initializer_list<std::uint64_t> numbers) {
    std::string line;
    for (const std::uint64_t number : numbers) {
        if (!line.empty()) line += ' ';
        append_number(line, number);
    }
    return line + "\n";
}

Status TetgenWriter::nodes() {
    const Attribute* reals = column(Place::point, "tetgen:attribute", false);
    const Attribute* markers = column(Place::point, "tetgen:marker", false);
    left_out_.take(reals);
    left_out_.take(markers);
    std::string out = words({mesh_.point_count(), 3, reals ? reals->values.arity : 0,
                             markers ? markers->values.arity : 0});
    for (Index p = 0; p < mesh_.point_count(); ++p) {
        append_number(out, p + first_);
        for (std::size_t k = 0; k < 3; ++k) {
            out += ' ';
            append_number(out, mesh_.positions, 3 * p + k);
        }
        append(out, reals, p);
        append(out, markers, p);
        out += '\n';
    }
    return write_file(paths_.node, out);
}

Status TetgenWriter::tets() {
    const Attribute* regions = column(Place::cell, "tetgen:region", false);
    left_out_.take(regions);
    const CompanionBlock* middles = nullptr;
    std::vector<Index> middle_of;  // the edge nodes of each tet; all or none must have them
    for (std::size_t b = 0; b < mesh_.companions.size() && !middles; ++b) {
        const CompanionBlock& block = mesh_.companions[b];
        if (block.vtk_type != kTetgenEdgeNodes || block.nodes_per_cell != 6 ||
            block.hosts.size() != mesh_.cell_count() || block.hosts.empty())
            continue;
        middle_of.assign(mesh_.cell_count(), kNoIndex);
        for (Index i = 0; i < block.cell_count; ++i) middle_of[block.hosts[i]] = i;
        if (std::find(middle_of.begin(), middle_of.end(), kNoIndex) != middle_of.end()) continue;
        middles = &block;
        left_out_.take_block(b);
    }
    quadratic_ = middles != nullptr;
    std::string out =
        words({mesh_.cell_count(), quadratic_ ? 10u : 4u, regions ? regions->values.arity : 0});
    for (Index c = 0; c < mesh_.cell_count(); ++c) {
        append_number(out, c + first_);
        for (const Index node : mesh_.cell(c)) append_index(out, node);
        if (quadratic_) {
            Index six[6] = {};
            for (std::size_t k = 0; k < 6; ++k)
                six[kTetgenOfVtk[k]] = middles->nodes[6 * middle_of[c] + k];
            for (const Index node : six) append_index(out, node);
        }
        append(out, regions, c);
        out += '\n';
    }
    return write_file(paths_.ele, out);
}

Status TetgenWriter::companions(const std::string& path, const std::string& name,
                                std::pair<std::uint16_t, std::uint16_t> types) {
    std::uint16_t type = 0;  // a file holds either straight or quadratic ones
    std::uint32_t nodes = 0;
    Index count = 0, first = 0;
    for (std::size_t b = 0; b < mesh_.companions.size(); ++b) {
        const CompanionBlock& block = mesh_.companions[b];
        const bool fits =
            block.vtk_type == types.first || (block.vtk_type == types.second && quadratic_);
        if (!fits || (type != 0 && type != block.vtk_type)) continue;
        type = block.vtk_type;
        nodes = block.nodes_per_cell;
        count += block.cell_count;
        left_out_.take_block(b);
    }
    if (type == 0) {
        if (file_exists(path))
            left_out_.say("an older file " + path +
                          " lies beside, and would be read with this mesh");
        return Done{};
    }
    bool marked = markers_ != nullptr;
    for (const Note& note : mesh_.notes)
        if (note.key == "tetgen:unmarked" && note.text == name) marked = false;
    const Attribute* neighbours = find_attribute(mesh_, Place::mesh, "tetgen:neighbours:" + name);
    if (neighbours && neighbours->values.count() != count) neighbours = nullptr;
    left_out_.take(neighbours);

    std::string out = words({count, marked ? 1u : 0u});
    Index row = 0;
    for (const CompanionBlock& block : mesh_.companions) {
        if (block.vtk_type == type) {
            for (Index c = 0; c < block.cell_count; ++c, ++row) {
                append_number(out, row + first_);
                for (std::uint32_t k = 0; k < nodes; ++k)
                    append_index(out, block.nodes[c * nodes + k]);
                if (marked) append(out, markers_, first + c);
                append(out, neighbours, row);
                out += '\n';
            }
        }
        first += block.cell_count;
    }
    return write_file(path, out);
}

}  // namespace

Status write_tetgen(const Mesh& mesh, const std::string& path, const WriteOptions&,
                    Sentences* left_out) {
    if (mesh.kind != CellKind::tet && mesh.cell_count() != 0)
        return cannot_hold(path, "TetGen's files hold tetrahedra, not polygons");
    return TetgenWriter(mesh, path).write(left_out);
}

}  // namespace ravel::io
