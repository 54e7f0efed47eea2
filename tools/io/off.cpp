// Object File Format: OFF, COFF, NOFF, STOFF and their combinations, as text.
#include <algorithm>
#include <array>
#include <cmath>

#include "io/attributes.h"
#include "io/decimals.h"
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/left_out.h"
#include "io/text_reader.h"

namespace ravel::io {

namespace {

// Numbers of which only some elements have a tuple. They are integers only if all are written
// so: OFF means 0..255 by "1" and 0..1 by "1.0".
struct Values {
    std::string name;
    std::uint32_t arity = 1;
    std::vector<double> numbers;
    std::vector<Index> index;
    bool integers = true;

    void add(Index element, std::span<const double> tuple, bool are_integers) {
        index.resize(element, kNoIndex);
        index.push_back(numbers.size() / arity);
        numbers.insert(numbers.end(), tuple.begin(), tuple.end());
        integers = integers && are_integers;
    }

    void finish(Mesh& mesh, Place place, Index elements) {
        if (numbers.empty()) return;
        if (numbers.size() / arity == elements) {
            index.clear();
        } else {
            index.resize(elements, kNoIndex);
        }
        Array array = floats_from_text(numbers, arity);
        if (integers) {
            const std::vector<std::int64_t> whole(numbers.begin(), numbers.end());
            array = integers_from_text(whole, arity);
        }
        add_attribute(mesh, name, place, std::move(array), std::move(index));
    }
};

// A colour of one, three or four numbers: a colour map's entry, red green blue, and alpha.
struct Colors {
    Values map{"off:colormap", 1, {}, {}, true}, rgb{"off:color", 3, {}, {}, true},
        alpha{"off:alpha", 1, {}, {}, true};

    bool add(Index element, std::span<const double> numbers, bool integers) {
        switch (numbers.size()) {
            case 0:
                return true;
            case 1:
                map.add(element, numbers, integers);
                return true;
            case 3:
                rgb.add(element, numbers, integers);
                return true;
            case 4:
                rgb.add(element, numbers.first(3), integers);
                alpha.add(element, numbers.last(1), integers);
                return true;
            default:
                return false;
        }
    }

    void finish(Mesh& mesh, Place place, Index elements) {
        alpha.integers = rgb.integers;  // they are read together
        for (Values* values : {&map, &rgb, &alpha}) values->finish(mesh, place, elements);
    }
};

class OffReader {
  public:
    OffReader(std::string_view text, const std::string& path)
        : in_(text, path, {.within_words = true}) {}
    Result<Mesh> read();

  private:
    Status header();
    Status point(Index p);
    Status face(Index f);
    Status rest_of_line();  // into rest_ and whole_
    // Are these numbers, a part of rest_, all written as integers?
    bool integers(std::span<const double> part) const {
        const auto first = whole_.begin() + (part.data() - rest_.data());
        return std::all_of(first, first + static_cast<std::ptrdiff_t>(part.size()),
                           [](bool whole) { return whole; });
    }

    TextReader in_;
    Mesh mesh_;
    bool has_normals_ = false, has_texture_ = false;
    std::int64_t points_ = 0, faces_ = 0;
    std::vector<double> positions_;
    Values normals_{"off:normal", 3, {}, {}, false}, texture_{"off:texture", 2, {}, {}, false};
    Colors point_colors_, face_colors_;
    std::vector<double> rest_;
    std::vector<bool> whole_;
};

Status OffReader::header() {
    const std::string_view first = in_.peek();
    std::int64_t number = 0;
    if (!parse_integer(first, number)) {  // the keyword may be missing
        std::string_view keyword = in_.word();
        const bool is_off = keyword.size() >= 3 && keyword.substr(keyword.size() - 3) == "OFF";
        if (!is_off) return in_.expected("the keyword OFF");
        keyword.remove_suffix(3);
        if (keyword.starts_with("ST")) {
            has_texture_ = true;
            keyword.remove_prefix(2);
        }
        if (keyword.starts_with("C")) keyword.remove_prefix(1);  // colours are seen on the lines
        if (keyword.starts_with("N")) {
            has_normals_ = true;
            keyword.remove_prefix(1);
        }
        if (!keyword.empty()) return in_.expected("OFF, COFF, NOFF or STOFF in three dimensions");
        if (same_word(in_.peek(), "BINARY"))
            return in_.expected("OFF as text (binary OFF is not read)");
    }
    if (!in_.read(points_) || points_ < 0) return in_.expected("the number of points");
    if (!in_.read(faces_) || faces_ < 0) return in_.expected("the number of faces");
    if (!in_.line_ended()) {
        std::int64_t edges = 0;  // nobody needs it, and it is often wrong
        if (!in_.read_in_line(edges)) return in_.expected("the number of edges");
    }
    if (!in_.line_ended()) {
        in_.line_word();
        return in_.expected("three counts: points, faces, edges");
    }
    // A point takes six bytes at least ("0 0 0\n"), a face two.
    const std::uint64_t left = in_.bytes_left() + 1;
    if (static_cast<std::uint64_t>(points_) > left / 6 ||
        static_cast<std::uint64_t>(faces_) > (left - 6 * static_cast<std::uint64_t>(points_)) / 2)
        return in_.error("the header promises " + std::to_string(points_) + " points and " +
                         std::to_string(faces_) + " faces, more than the file can hold");
    return Done{};
}

Status OffReader::rest_of_line() {
    rest_.clear();
    whole_.clear();
    while (!in_.line_ended()) {
        const std::string_view word = in_.line_word();
        double number = 0;
        std::int64_t whole = 0;
        if (!parse_real(word, number)) return in_.expected("a number");
        constexpr std::int64_t kExact = std::int64_t{1} << 53;
        whole_.push_back(parse_integer(word, whole) && whole <= kExact && whole >= -kExact &&
                         !std::signbit(number) == (whole >= 0));
        rest_.push_back(number);
    }
    return Done{};
}

Status OffReader::point(Index p) {
    std::array<double, 3> xyz{};
    for (double& x : xyz)
        if (!in_.read(x))
            return in_.expected("a coordinate of point " + std::to_string(p + 1) + " of " +
                                std::to_string(points_));
    positions_.insert(positions_.end(), xyz.begin(), xyz.end());
    if (Status status = rest_of_line(); !status) return status;
    std::span<const double> rest = rest_;
    if (has_normals_) {
        if (rest.size() < 3) return in_.expected("a normal of three numbers");
        normals_.add(p, rest.first(3), false);
        rest = rest.subspan(3);
    }
    if (has_texture_) {
        if (rest.size() < 2) return in_.expected("a texture coordinate of two numbers");
        texture_.add(p, rest.last(2), false);
        rest = rest.first(rest.size() - 2);
    }
    if (!point_colors_.add(p, rest, integers(rest)))
        return in_.error("expected a colour of 1, 3 or 4 numbers after the point, found " +
                         std::to_string(rest.size()));
    return Done{};
}

Status OffReader::face(Index f) {
    std::int64_t degree = 0;
    const auto which = [&] {
        return "face " + std::to_string(f + 1) + " of " + std::to_string(faces_);
    };
    if (!in_.read(degree) || degree < 0) return in_.expected("the number of corners of " + which());
    if (static_cast<std::uint64_t>(degree) > in_.bytes_left() / 2)
        return in_.error(which() + " has more corners than the file can hold");
    for (std::int64_t k = 0; k < degree; ++k) {
        std::int64_t corner = 0;
        if (!in_.read(corner) || corner < 0 || corner >= points_)
            return in_.expected("a corner of " + which() + ", from 0 to " +
                                std::to_string(points_ - 1));
        mesh_.corners.push_back(static_cast<Index>(corner));
    }
    mesh_.corner_begin.push_back(mesh_.corners.size());
    if (Status status = rest_of_line(); !status) return status;
    if (!face_colors_.add(f, rest_, integers(rest_)))
        return in_.error("expected a colour of 1, 3 or 4 numbers after the face, found " +
                         std::to_string(rest_.size()));
    return Done{};
}

Result<Mesh> OffReader::read() {
    if (Status status = header(); !status) return status.error();
    const auto points = static_cast<Index>(points_), faces = static_cast<Index>(faces_);
    positions_.reserve(3 * points);
    mesh_.corner_begin.reserve(faces + 1);
    mesh_.corner_begin.push_back(0);
    for (Index p = 0; p < points; ++p)
        if (Status status = point(p); !status) return status.error();
    for (Index f = 0; f < faces; ++f)
        if (Status status = face(f); !status) return status.error();
    if (!in_.at_end()) {
        in_.word();
        return in_.expected("the end of the file after " + std::to_string(faces_) + " faces");
    }
    mesh_.positions = floats_from_text(positions_, 3);
    normals_.finish(mesh_, Place::point, points);
    point_colors_.finish(mesh_, Place::point, points);
    texture_.finish(mesh_, Place::point, points);
    face_colors_.finish(mesh_, Place::cell, faces);
    return std::move(mesh_);
}

// Floats get a point even when they are whole, for "1" would be read as 1 of 255.
void append_value(std::string& out, const Attribute* attribute, Index element) {
    const Index tuple = attribute ? tuple_of(*attribute, element) : kNoIndex;
    if (tuple == kNoIndex) return;
    const Array& values = attribute->values;
    for (std::uint32_t k = 0; k < values.arity; ++k) {
        out += ' ';
        const std::size_t before = out.size();
        append_number(out, values, tuple * values.arity + k);
        if (is_float(values.scalar) && out.find_first_of(".eni", before) == std::string::npos)
            out += ".0";
    }
}

struct ColorWriter {
    ColorWriter(const Mesh& mesh, Place place, LeftOut& left_out) {
        const auto known = [&](std::string_view name, std::uint32_t arity) {
            const Attribute* attribute = find_attribute(mesh, place, name);
            if (!attribute || attribute->values.arity != arity)
                return static_cast<const Attribute*>(nullptr);
            left_out.take(attribute);
            return attribute;
        };
        rgb = known("off:color", 3);
        alpha = rgb ? known("off:alpha", 1) : nullptr;
        map = known("off:colormap", 1);
    }
    void append(std::string& out, Index element) const {
        const std::size_t before = out.size();
        append_value(out, rgb, element);
        if (out.size() != before) {
            append_value(out, alpha, element);
        } else {
            append_value(out, map, element);
        }
    }
    bool any() const { return rgb || map; }
    const Attribute *rgb = nullptr, *alpha = nullptr, *map = nullptr;
};

// All points must have one: the header can't say otherwise.
const Attribute* for_all_points(const Mesh& mesh, std::string_view name, std::uint32_t arity) {
    const Attribute* attribute = find_attribute(mesh, Place::point, name);
    if (!attribute || attribute->values.arity != arity) return nullptr;
    for (const Index i : attribute->index)
        if (i == kNoIndex) return nullptr;
    return attribute;
}

}  // namespace

Result<Mesh> read_off(const std::string& path) {
    Result<std::string> text = read_file(path);
    if (!text) return text.error();
    return OffReader(*text, path).read();
}

Status write_off(const Mesh& mesh, const std::string& path, const WriteOptions&,
                 Sentences* left_out_sentences) {
    if (mesh.kind != CellKind::polygon && mesh.cell_count() != 0)
        return cannot_hold(path, "OFF holds polygons, not tetrahedra");
    LeftOut left_out(mesh, "OFF");
    const Attribute* normals = for_all_points(mesh, "off:normal", 3);
    const Attribute* texture = for_all_points(mesh, "off:texture", 2);
    left_out.take(normals);
    left_out.take(texture);
    const ColorWriter point_colors(mesh, Place::point, left_out);
    const ColorWriter face_colors(mesh, Place::cell, left_out);

    std::string out;
    if (texture) out += "ST";
    if (point_colors.any()) out += 'C';
    if (normals) out += 'N';
    out += "OFF\n";
    append_number(out, mesh.point_count());
    out += ' ';
    append_number(out, mesh.cell_count());
    out += " 0\n";
    for (Index p = 0; p < mesh.point_count(); ++p) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (k != 0) out += ' ';
            append_number(out, mesh.positions, 3 * p + k);
        }
        append_value(out, normals, p);
        point_colors.append(out, p);
        append_value(out, texture, p);
        out += '\n';
    }
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        append_number(out, mesh.cell(c).size());
        for (const Index corner : mesh.cell(c)) {
            out += ' ';
            append_number(out, corner);
        }
        face_colors.append(out, c);
        out += '\n';
    }
    left_out.report(left_out_sentences);
    return write_file(path, out);
}

}  // namespace ravel::io
