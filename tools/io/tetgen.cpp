// TetGen's .node, .ele, .face and .edge, reading.
#include <algorithm>
#include <optional>

#include "io/attributes.h"
#include "io/decimals.h"
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/tetgen_files.h"
#include "io/text_reader.h"

namespace ravel::io {

TetgenPaths tetgen_paths(const std::string& path) {
    const std::string base = path.substr(0, path.rfind('.'));
    TetgenPaths paths{base + ".node", base + ".ele", base + ".face", base + ".edge"};
    const std::string ending = lower_case(path.substr(base.size()));
    for (std::string* file : {&paths.node, &paths.ele, &paths.face, &paths.edge})
        if (file->substr(base.size()) == ending) *file = path;  // with the capitals it came with
    return paths;
}

namespace {

// Rows of numbers after a header line of counts.
class TableReader {
  public:
    TableReader(std::string_view text, const std::string& path)
        : in_(text, path, {.within_words = true}) {}

    // The header's numbers; those after the first may be missing and keep their value.
    Status header(std::span<std::uint64_t> counts, const std::string& what) {
        if (!in_.next_filled_line() || !in_.read_in_line(counts[0]))
            return in_.expected("the number of " + what);
        rows_ = counts[0];
        what_ = what;
        for (std::uint64_t& count : counts.subspan(1))
            if (!in_.line_ended() && !in_.read_in_line(count))
                return in_.expected("a count of the header of " + what);
        if (!in_.line_ended()) {
            in_.line_word();
            return in_.expected("the end of the header");
        }
        return Done{};
    }

    Status check_size(std::uint64_t columns) {
        const std::uint64_t left = in_.bytes_left() + 1;
        if (rows_ != 0 && (columns > left || rows_ > left / (2 * columns)))
            return in_.error("the header promises " + std::to_string(rows_) + " " + what_ +
                             ", more than the file can hold");
        return Done{};
    }

    // How many words the first row has.
    std::size_t words_of_first_row() {
        const std::size_t before = in_.offset();
        std::size_t words = 0;
        if (in_.next_filled_line())
            while (!in_.line_ended()) {
                in_.line_word();
                ++words;
            }
        in_.seek(before);
        return words;
    }

    Status begin_row(std::int64_t& number) {
        ++row_;
        if (!in_.read(number)) return in_.expected("the number that begins " + row());
        return Done{};
    }
    Status end_row() {
        if (in_.line_ended()) return Done{};
        in_.line_word();
        return in_.expected("the end of " + row());
    }
    Status end() {
        if (in_.at_end()) return Done{};
        in_.word();
        return in_.expected("the end of the file after " + std::to_string(rows_) + " " + what_);
    }
    template <class T>
    Status number(T& value, const char* what) {
        if (!in_.read_in_line(value)) return in_.expected(std::string(what) + " in " + row());
        return Done{};
    }
    Status number(TextNumbers& numbers, const char* what) {
        if (!numbers.add(in_.line_word())) return in_.expected(std::string(what) + " in " + row());
        return Done{};
    }
    Status node(std::int64_t first, std::uint64_t points, Index& index) {
        std::int64_t value = 0;
        if (in_.read_in_line(value) && value >= first) {
            index = static_cast<std::uint64_t>(value) - static_cast<std::uint64_t>(first);
            if (index < points) return Done{};
        }
        return in_.expected("a node's number from " + std::to_string(first) + " to " +
                            std::to_string(first + static_cast<std::int64_t>(points) - 1) + " in " +
                            row());
    }
    Error error(const std::string& sentence) const { return in_.error(sentence); }
    std::uint64_t rows() const { return rows_; }

  private:
    std::string row() const {
        return "row " + std::to_string(row_) + " of " + std::to_string(rows_) + " " + what_;
    }

    TextReader in_;
    std::uint64_t rows_ = 0, row_ = 0;
    std::string what_;
};

class TetgenReader {
  public:
    explicit TetgenReader(TetgenPaths paths) : paths_(std::move(paths)) {}

    Result<Mesh> read(bool needs_tets) {
        mesh_.kind = CellKind::tet;
        if (Status status = nodes(); !status) return status.error();
        if (needs_tets || file_exists(paths_.ele))
            if (Status status = tets(); !status) return status.error();
        Companions faces{"face", 3, kTetgenTriangle, 6, kTetgenTriangle6, {}, false};
        Companions edges{"edge", 2, kTetgenLine, 3, kTetgenLine3, {}, false};
        const bool has_faces = file_exists(paths_.face), has_edges = file_exists(paths_.edge);
        if (has_faces)
            if (Status status = companions(paths_.face, faces); !status) return status.error();
        if (has_edges)
            if (Status status = companions(paths_.edge, edges); !status) return status.error();
        finish_markers(has_faces ? &faces : nullptr, has_edges ? &edges : nullptr);
        return std::move(mesh_);
    }

  private:
    struct Companions {
        std::string name;
        std::uint32_t nodes;
        std::uint16_t vtk_type;
        std::uint32_t quadratic_nodes;
        std::uint16_t quadratic_type;
        std::vector<std::int64_t> markers;
        bool marked;
    };

    Status nodes();
    Status tets();
    Status companions(const std::string& path, Companions& kind);
    void finish_markers(const Companions* faces, const Companions* edges);

    TetgenPaths paths_;
    Mesh mesh_;
    std::int64_t first_ = 0;
    bool quadratic_ = false;
};

Status TetgenReader::nodes() {
    Result<std::string> text = read_file(paths_.node);
    if (!text) return text.error();
    TableReader table(*text, paths_.node);
    std::uint64_t counts[4] = {0, 3, 0, 0};
    if (Status status = table.header(counts, "nodes"); !status) return status;
    const auto [points, dimension, reals, promised_markers] = counts;
    if (dimension != 3)
        return table.error("the nodes have dimension " + std::to_string(dimension) +
                           "; only three dimensions are read");
    if (reals > text->size() || promised_markers > text->size())
        return table.error("the header promises more columns than the file can hold");
    // TetGen accepts a header that promises markers which the rows don't have.
    const std::uint64_t markers = table.words_of_first_row() == 4 + reals ? 0 : promised_markers;
    if (Status status = table.check_size(4 + reals + markers); !status) return status;

    std::vector<double> positions(3 * points);
    TextNumbers marker_numbers;
    std::vector<double> attributes(reals * points);
    double* position = positions.data();
    double* attribute = attributes.data();
    for (std::uint64_t i = 0; i < points; ++i) {
        std::int64_t number = 0;
        if (Status status = table.begin_row(number); !status) return status;
        if (i == 0) {
            if (number != 0 && number != 1)
                return table.error("expected the first node to have number 0 or 1, found " +
                                   std::to_string(number));
            first_ = number;
        }
        if (number != first_ + static_cast<std::int64_t>(i))
            return table.error("expected node " +
                               std::to_string(first_ + static_cast<std::int64_t>(i)) + ", found " +
                               std::to_string(number));
        for (int k = 0; k < 3; ++k)
            if (Status status = table.number(*position++, "a coordinate"); !status) return status;
        for (std::uint64_t k = 0; k < reals; ++k)
            if (Status status = table.number(*attribute++, "an attribute"); !status) return status;
        for (std::uint64_t k = 0; k < markers; ++k)
            if (Status status = table.number(marker_numbers, "a marker"); !status) return status;
        if (Status status = table.end_row(); !status) return status;
    }
    if (Status status = table.end(); !status) return status;
    mesh_.positions = floats_from_text(positions, 3);
    if (reals != 0)
        add_attribute(mesh_, "tetgen:attribute", Place::point,
                      floats_from_text(attributes, static_cast<std::uint32_t>(reals)));
    if (markers != 0)
        add_attribute(mesh_, "tetgen:marker", Place::point,
                      marker_numbers.take(static_cast<std::uint32_t>(markers)));
    mesh_.notes.push_back({"tetgen:first", std::to_string(first_)});
    return Done{};
}

Status TetgenReader::tets() {
    Result<std::string> text = read_file(paths_.ele);
    if (!text) return text.error();
    TableReader table(*text, paths_.ele);
    std::uint64_t counts[3] = {0, 4, 0};
    if (Status status = table.header(counts, "tetrahedra"); !status) return status;
    const auto [tet_count, nodes, regions] = counts;
    if (nodes != 4 && nodes != 10)
        return table.error("expected tetrahedra of 4 or 10 nodes, found " + std::to_string(nodes));
    if (regions > text->size())
        return table.error("the header promises more columns than the file can hold");
    if (Status status = table.check_size(1 + nodes + regions); !status) return status;
    quadratic_ = nodes == 10;

    const Index points = mesh_.point_count();
    mesh_.corners.resize(4 * tet_count);
    CompanionBlock middles{kTetgenEdgeNodes, 6, tet_count, {}, {}};
    if (quadratic_) {
        middles.nodes.resize(6 * tet_count);
        middles.hosts.resize(tet_count);
    }
    TextNumbers region_numbers;
    for (Index c = 0; c < tet_count; ++c) {
        std::int64_t number = 0;  // nothing refers to it
        if (Status status = table.begin_row(number); !status) return status;
        for (std::size_t k = 0; k < 4; ++k)
            if (Status status = table.node(first_, points, mesh_.corners[4 * c + k]); !status)
                return status;
        if (quadratic_) {
            Index six[6];
            for (Index& node : six)
                if (Status status = table.node(first_, points, node); !status) return status;
            for (std::size_t k = 0; k < 6; ++k) middles.nodes[6 * c + k] = six[kTetgenOfVtk[k]];
            middles.hosts[c] = c;
        }
        for (std::uint64_t k = 0; k < regions; ++k)
            if (Status status = table.number(region_numbers, "a region"); !status) return status;
        if (Status status = table.end_row(); !status) return status;
    }
    if (Status status = table.end(); !status) return status;
    if (regions != 0)
        add_attribute(mesh_, "tetgen:region", Place::cell,
                      region_numbers.take(static_cast<std::uint32_t>(regions)));
    if (quadratic_) mesh_.companions.push_back(std::move(middles));
    return Done{};
}

Status TetgenReader::companions(const std::string& path, Companions& kind) {
    Result<std::string> text = read_file(path);
    if (!text) return text.error();
    TableReader table(*text, path);
    std::uint64_t counts[2] = {0, 0};
    if (Status status = table.header(counts, kind.name + "s"); !status) return status;
    const auto [cell_count, promised_markers] = counts;
    if (promised_markers > 1)
        return table.error("expected 0 or 1 markers, found " + std::to_string(promised_markers));
    const std::size_t words = table.words_of_first_row();
    const bool quadratic = quadratic_ && words >= 1 + kind.quadratic_nodes;
    const std::uint32_t nodes = quadratic ? kind.quadratic_nodes : kind.nodes;
    const std::uint64_t markers = words == 1 + nodes ? 0 : promised_markers;
    if (Status status = table.check_size(1 + nodes + markers); !status) return status;
    // More columns name neighbours: two tets of a face, one of an edge, -1 for none.
    const std::size_t more =
        cell_count != 0 && words > 1 + nodes + markers ? words - 1 - nodes - markers : 0;

    CompanionBlock block{
        quadratic ? kind.quadratic_type : kind.vtk_type, nodes, cell_count, {}, {}};
    block.nodes.resize(cell_count * nodes);
    std::vector<std::int64_t> neighbours;
    kind.marked = markers != 0;
    kind.markers.resize(cell_count);
    for (Index c = 0; c < cell_count; ++c) {
        std::int64_t number = 0;
        if (Status status = table.begin_row(number); !status) return status;
        for (std::uint32_t k = 0; k < nodes; ++k)
            if (Status status = table.node(first_, mesh_.point_count(), block.nodes[c * nodes + k]);
                !status)
                return status;
        if (kind.marked)
            if (Status status = table.number(kind.markers[c], "a marker"); !status) return status;
        for (std::size_t k = 0; k < more; ++k) {
            neighbours.push_back(0);
            if (Status status = table.number(neighbours.back(), "a neighbour"); !status)
                return status;
        }
        if (Status status = table.end_row(); !status) return status;
    }
    if (Status status = table.end(); !status) return status;
    if (more != 0) {
        Attribute& attribute =
            add_attribute(mesh_, "tetgen:neighbours:" + kind.name, Place::mesh,
                          integers_from_text(neighbours, static_cast<std::uint32_t>(more)));
        for (std::uint32_t k = 0; k < std::min<std::size_t>(more, kind.nodes - 1); ++k)
            attribute.references.push_back({k, Place::cell, first_});
    }
    mesh_.companions.push_back(std::move(block));
    return Done{};
}

// One attribute covers all companions; a note tells which of two files had no markers.
void TetgenReader::finish_markers(const Companions* faces, const Companions* edges) {
    const bool face_marks = faces && faces->marked, edge_marks = edges && edges->marked;
    if (!face_marks && !edge_marks) return;
    std::vector<std::int64_t> markers(quadratic_ ? mesh_.cell_count() : 0);
    for (const Companions* kind : {faces, edges}) {
        if (!kind) continue;
        markers.insert(markers.end(), kind->markers.begin(), kind->markers.end());
        if (!kind->marked) mesh_.notes.push_back({"tetgen:unmarked", kind->name});
    }
    add_attribute(mesh_, "tetgen:marker", Place::companion, integers_from_text(markers, 1));
}

}  // namespace

Result<Mesh> read_tetgen(const std::string& path) {
    const TetgenPaths paths = tetgen_paths(path);
    return TetgenReader(paths).read(path == paths.ele);
}

}  // namespace ravel::io
