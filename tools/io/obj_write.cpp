// Wavefront OBJ, writing.
#include "io/attributes.h"
#include "io/decimals.h"
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/left_out.h"

namespace ravel::io {

namespace {

void append_tuple(std::string& out, const Array& array, Index tuple) {
    for (std::uint32_t k = 0; k < array.arity; ++k) {
        out += ' ';
        append_number(out, array, tuple * array.arity + k);
    }
}

// An attribute the writer knows by name: right place, right arity, and integers where asked.
const Attribute* known(const Mesh& mesh, Place place, std::string_view name, std::uint32_t fewest,
                       std::uint32_t most) {
    const Attribute* attribute = find_attribute(mesh, place, name);
    if (!attribute || attribute->values.arity < fewest || attribute->values.arity > most)
        return nullptr;
    return attribute;
}

// Writes usemtl, g, o or s where the value changes. Names are numbered by first appearance when
// the file is read again, so a name's predecessors are written before it even where no cell has
// them.
class StateWriter {
  public:
    StateWriter(const Mesh& mesh, std::string keyword, const std::string& attribute, bool named,
                LeftOut& left_out)
        : keyword_(std::move(keyword)), named_(named) {
        attribute_ = known(mesh, Place::cell, attribute, 1, 1);
        if (!attribute_ || is_float(attribute_->values.scalar) || !attribute_->index.empty()) {
            attribute_ = nullptr;
            return;
        }
        left_out.take(attribute_);
        if (!named) return;
        left_out.take_tag_names(attribute);
        while (const TagName* tag =
                   find_tag_name(mesh, attribute, static_cast<std::int64_t>(names_.size())))
            names_.push_back(tag->name);
    }

    void before_cell(std::string& out, Index cell) {
        if (!attribute_) return;
        std::int64_t value = -1;
        integer_at(attribute_->values, cell, value);
        if (value == now_) return;
        if (named_ && value >= 0) introduce_up_to(out, static_cast<std::size_t>(value));
        state(out, value);
        now_ = value;
    }

    void after_cells(std::string& out) {
        if (!attribute_) return;
        if (named_) introduce_up_to(out, names_.size());
        // The statement itself tells that the file has such values, if only "none".
        if (!stated_) state(out, -1);
    }

  private:
    void introduce_up_to(std::string& out, std::size_t value) {
        for (; introduced_ < value && introduced_ < names_.size(); ++introduced_)
            state(out, static_cast<std::int64_t>(introduced_));
        if (introduced_ == value && value < names_.size()) ++introduced_;
    }

    void state(std::string& out, std::int64_t value) {
        stated_ = true;
        out += keyword_;
        if (value >= 0) {
            out += ' ';
            if (named_ && static_cast<std::size_t>(value) < names_.size()) {
                out += names_[static_cast<std::size_t>(value)];
            } else {
                append_number(out, value);
            }
        }
        out += '\n';
    }

    std::string keyword_;
    bool named_;
    const Attribute* attribute_ = nullptr;
    std::vector<std::string> names_;
    std::size_t introduced_ = 0;
    std::int64_t now_ = -1;
    bool stated_ = false;
};

void append_points(std::string& out, const Mesh& mesh, LeftOut& left_out) {
    const Attribute* weight = known(mesh, Place::point, "obj:w", 1, 1);
    const Attribute* color = known(mesh, Place::point, "obj:color", 3, 3);
    const Attribute* alpha = color ? known(mesh, Place::point, "obj:alpha", 1, 1) : nullptr;
    left_out.take(weight);
    left_out.take(color);
    left_out.take(alpha);
    for (Index p = 0; p < mesh.point_count(); ++p) {
        out += 'v';
        append_tuple(out, mesh.positions, p);
        const auto append = [&](const Attribute* attribute) {
            const Index tuple = attribute ? tuple_of(*attribute, p) : kNoIndex;
            if (tuple != kNoIndex) append_tuple(out, attribute->values, tuple);
            return tuple != kNoIndex;
        };
        if (!append(weight) && append(color)) append(alpha);
        out += '\n';
    }
}

// The pool of vt or vn, on corners, or on the mesh where it has no corners.
const Attribute* append_pool(std::string& out, const Mesh& mesh, const std::string& name,
                             std::uint32_t fewest, LeftOut& left_out) {
    const Attribute* pool = known(mesh, Place::corner, "obj:" + name, fewest, 3);
    if (!pool) pool = known(mesh, Place::mesh, "obj:" + name, fewest, 3);
    if (!pool) return nullptr;
    left_out.take(pool);
    for (Index i = 0; i < pool->values.count(); ++i) {
        out += name;
        append_tuple(out, pool->values, i);
        out += '\n';
    }
    return pool->place == Place::corner ? pool : nullptr;
}

void append_corner(std::string& out, Index point, Index texture, Index normal) {
    out += ' ';
    append_number(out, point + 1);
    if (texture == kNoIndex && normal == kNoIndex) return;
    out += '/';
    if (texture != kNoIndex) append_number(out, texture + 1);
    if (normal == kNoIndex) return;
    out += '/';
    append_number(out, normal + 1);
}

void append_companions(std::string& out, const Mesh& mesh, LeftOut& left_out) {
    constexpr std::uint16_t kVertex = 1, kLine = 3, kPolyLine = 4;
    for (std::size_t b = 0; b < mesh.companions.size(); ++b) {
        const CompanionBlock& block = mesh.companions[b];
        const bool is_line = block.vtk_type == kLine || block.vtk_type == kPolyLine;
        if (!is_line && (block.vtk_type != kVertex || block.nodes_per_cell != 1)) continue;
        left_out.take_block(b);
        for (Index c = 0; c < block.cell_count; ++c) {
            out += is_line ? 'l' : 'p';
            for (std::uint32_t k = 0; k < block.nodes_per_cell; ++k) {
                out += ' ';
                append_number(out, block.nodes[c * block.nodes_per_cell + k] + 1);
            }
            out += '\n';
        }
    }
}

}  // namespace

Status write_obj(const Mesh& mesh, const std::string& path, const WriteOptions&,
                 Sentences* left_out_sentences) {
    if (mesh.kind != CellKind::polygon && mesh.cell_count() != 0)
        return cannot_hold(path, "OBJ holds polygons, not tetrahedra");
    LeftOut left_out(mesh, "OBJ");
    std::string out;
    for (const Note& note : mesh.notes)
        if (note.key == "obj:mtllib") out += "mtllib " + note.text + "\n";
    left_out.take_notes("obj:mtllib");

    append_points(out, mesh, left_out);
    const Attribute* texture = append_pool(out, mesh, "vt", 1, left_out);
    const Attribute* normals = append_pool(out, mesh, "vn", 3, left_out);

    StateWriter states[] = {{mesh, "o", "obj:object", true, left_out},
                            {mesh, "g", "obj:group", true, left_out},
                            {mesh, "usemtl", "obj:material", true, left_out},
                            {mesh, "s", "obj:smoothing", false, left_out}};
    Index corner = 0;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        for (StateWriter& state : states) state.before_cell(out, c);
        out += 'f';
        for (const Index point : mesh.cell(c)) {
            append_corner(out, point, texture ? tuple_of(*texture, corner) : kNoIndex,
                          normals ? tuple_of(*normals, corner) : kNoIndex);
            ++corner;
        }
        out += '\n';
    }
    for (StateWriter& state : states) state.after_cells(out);
    append_companions(out, mesh, left_out);

    left_out.report(left_out_sentences);
    return write_file(path, out);
}

}  // namespace ravel::io
