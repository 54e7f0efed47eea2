// Stereolithography, text and binary. The soup of triangles is joined where points have the same
// bits, in order of first use, so that writing the triangles again gives the same file.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

#include "io/attributes.h"
#include "io/decimals.h"
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/left_out.h"
#include "io/text_reader.h"

namespace ravel::io {

namespace {

constexpr std::size_t kHeader = 80, kPrefix = 84, kFacet = 50;

// Numbers points by their bits, in order of first use: an open-addressing hash table.
template <class T>
class PointNumbers {
  public:
    explicit PointNumbers(std::size_t expected)
        : slots_(std::bit_ceil(2 * expected + 16), kNoIndex) {}

    Index number_of(const std::array<T, 3>& point) {
        if (2 * (points_.size() + 1) > slots_.size()) grow();
        std::size_t slot = hash(point) & (slots_.size() - 1);
        while (slots_[slot] != kNoIndex) {
            // Bits and not values: 0 and -0 are two points, a NaN equals itself.
            if (std::memcmp(&points_[slots_[slot]], &point, sizeof point) == 0) return slots_[slot];
            slot = (slot + 1) & (slots_.size() - 1);
        }
        slots_[slot] = points_.size();
        points_.push_back(point);
        return points_.size() - 1;
    }
    const std::vector<std::array<T, 3>>& points() const { return points_; }

  private:
    static std::size_t hash(const std::array<T, 3>& point) {
        std::uint64_t h = 0;
        for (const T x : point) {
            const double wide = static_cast<double>(x);
            h = (h ^ std::bit_cast<std::uint64_t>(wide)) * 0x9E3779B97F4A7C15u;
            h ^= h >> 29;
        }
        return static_cast<std::size_t>(h);
    }
    void grow() {
        std::vector<Index> bigger(slots_.size() * 2, kNoIndex);
        for (const Index i : slots_) {
            if (i == kNoIndex) continue;
            std::size_t slot = hash(points_[i]) & (bigger.size() - 1);
            while (bigger[slot] != kNoIndex) slot = (slot + 1) & (bigger.size() - 1);
            bigger[slot] = i;
        }
        slots_ = std::move(bigger);
    }

    std::vector<Index> slots_;
    std::vector<std::array<T, 3>> points_;
};

// All bits zero: what is written where there are none.
bool all_zero(std::span<const std::byte> bytes) {
    return std::all_of(bytes.begin(), bytes.end(), [](std::byte b) { return b == std::byte{0}; });
}

void triangles(Mesh& mesh, std::size_t count) {
    mesh.corner_begin.resize(count + 1);
    for (std::size_t c = 0; c <= count; ++c) mesh.corner_begin[c] = 3 * c;
}

template <class T>
std::span<const T> flat(const std::vector<std::array<T, 3>>& tuples) {
    return {reinterpret_cast<const T*>(tuples.data()), 3 * tuples.size()};
}

// The header without the zeros that fill it; empty when it is not plain words.
std::string header_words(std::string_view header) {
    const std::string_view words = header.substr(0, header.find('\0'));
    if (header.find_first_not_of('\0', words.size()) != std::string_view::npos) return {};
    for (const char c : words)
        if (c < ' ' || c > '~') return {};
    return std::string(words);
}

Result<Mesh> read_binary(std::string_view bytes, const std::string& path) {
    if (bytes.size() < kPrefix)
        return byte_error(path, bytes.size(),
                          "the file ends inside the STL header, expected 84 bytes");
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kHeader, sizeof count);
    const std::size_t needed = kPrefix + kFacet * std::size_t{count};
    if (bytes.size() != needed)
        return byte_error(path, bytes.size() < needed ? bytes.size() : needed,
                          std::string("the file ") +
                              (bytes.size() < needed ? "ends early" : "goes on") + ": " +
                              std::to_string(count) + " triangles take " + std::to_string(needed) +
                              " bytes, the file has " + std::to_string(bytes.size()));
    Mesh mesh;
    PointNumbers<float> numbers(count / 2 + 1);
    Array normals = make_array(Scalar::f32, 3, count);
    Array extra = make_array(Scalar::u16, 1, count);
    mesh.corners.reserve(3 * std::size_t{count});
    for (std::size_t c = 0; c < count; ++c) {
        const char* facet = bytes.data() + kPrefix + kFacet * c;
        std::memcpy(normals.bytes.data() + 12 * c, facet, 12);
        for (std::size_t k = 0; k < 3; ++k) {
            std::array<float, 3> point{};
            std::memcpy(&point, facet + 12 + 12 * k, sizeof point);
            mesh.corners.push_back(numbers.number_of(point));
        }
        std::memcpy(extra.bytes.data() + 2 * c, facet + 48, 2);
    }
    triangles(mesh, count);
    mesh.positions = array_of(flat(numbers.points()), 3);
    if (!all_zero(normals.bytes))
        add_attribute(mesh, "stl:normal", Place::cell, std::move(normals));
    if (!all_zero(extra.bytes)) add_attribute(mesh, "stl:attribute", Place::cell, std::move(extra));
    if (std::string words = header_words(bytes.substr(0, kHeader)); !words.empty())
        mesh.notes.push_back({"stl:header", std::move(words)});
    return mesh;
}

class TextStlReader {
  public:
    TextStlReader(std::string_view text, const std::string& path)
        : in_(text, path, {.comment = '\0'}) {}

    Result<Mesh> read() {
        while (!in_.at_end())
            if (Status status = solid(); !status) return status.error();
        Mesh mesh;
        triangles(mesh, corners_.size() / 3);
        mesh.corners = std::move(corners_);
        mesh.positions = floats_from_text(flat(numbers_.points()), 3);
        Array normals = floats_from_text(flat(normals_), 3);
        if (!all_zero(normals.bytes))
            add_attribute(mesh, "stl:normal", Place::cell, std::move(normals));
        if (names_.size() > 1) {
            add_attribute(mesh, "stl:solid", Place::cell, array_of(solid_of_, 1));
            for (std::size_t i = 0; i < names_.size(); ++i)
                mesh.tag_names.push_back(
                    {"stl:solid", -1, static_cast<std::int64_t>(i), names_[i]});
        } else if (!names_.empty() && !names_.front().empty()) {
            mesh.notes.push_back({"stl:name", names_.front()});
        }
        return mesh;
    }

  private:
    bool keyword(std::string_view wanted) { return same_word(in_.word(), wanted); }

    Status solid() {
        if (!keyword("solid")) return in_.expected("solid");
        names_.emplace_back(in_.rest_of_line());
        while (same_word(in_.peek(), "facet")) {
            in_.word();
            if (Status status = facet(); !status) return status;
        }
        if (!keyword("endsolid")) return in_.expected("facet or endsolid");
        in_.rest_of_line();
        return Done{};
    }

    Status facet() {
        std::array<double, 3> numbers{};
        if (!keyword("normal")) return in_.expected("normal");
        for (double& x : numbers)
            if (!in_.read(x)) return in_.expected("a number of the facet's normal");
        normals_.push_back(numbers);
        if (!keyword("outer")) return in_.expected("outer loop");
        if (!keyword("loop")) return in_.expected("loop");
        for (int k = 0; k < 3; ++k) {
            if (!keyword("vertex")) return in_.expected("vertex (three of them)");
            for (double& x : numbers)
                if (!in_.read(x)) return in_.expected("a coordinate");
            corners_.push_back(numbers_.number_of(numbers));
        }
        if (!keyword("endloop")) return in_.expected("endloop after three vertices");
        if (!keyword("endfacet")) return in_.expected("endfacet");
        solid_of_.push_back(static_cast<std::int32_t>(names_.size() - 1));
        return Done{};
    }

    TextReader in_;
    PointNumbers<double> numbers_{64};
    std::vector<Index> corners_;
    std::vector<std::array<double, 3>> normals_;
    std::vector<std::int32_t> solid_of_;
    std::vector<std::string> names_;
};

// Binary files may begin with "solid" too; their size gives them away, and so do zero bytes.
bool is_text(std::string_view bytes) {
    if (bytes.size() >= kPrefix) {
        std::uint32_t count = 0;
        std::memcpy(&count, bytes.data() + kHeader, sizeof count);
        if (bytes.size() == kPrefix + kFacet * std::size_t{count}) return false;
    }
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return false;
    return same_word(bytes.substr(first, 5), "solid") && bytes.find('\0') == std::string_view::npos;
}

Status check_triangles(const Mesh& mesh, const std::string& path) {
    if (mesh.kind != CellKind::polygon && mesh.cell_count() != 0)
        return cannot_hold(path, "STL holds triangles, not tetrahedra");
    for (Index c = 0; c < mesh.cell_count(); ++c)
        if (mesh.cell(c).size() != 3)
            return cannot_hold(path, "STL holds triangles only, and cell " + std::to_string(c) +
                                         " has " + std::to_string(mesh.cell(c).size()) +
                                         " corners");
    return Done{};
}

const Attribute* facet_attribute(const Mesh& mesh, std::string_view name, std::uint32_t arity) {
    const Attribute* attribute = find_attribute(mesh, Place::cell, name);
    const bool fits = attribute && attribute->values.arity == arity && attribute->index.empty();
    return fits ? attribute : nullptr;
}

// STL has no list of points: those that no triangle uses, or that are equal, don't come back.
void tell_points(const Mesh& mesh, LeftOut& left_out) {
    std::vector<bool> used(mesh.point_count());
    for (const Index p : mesh.corners) used[p] = true;
    const auto unused = std::count(used.begin(), used.end(), false);
    if (unused != 0)
        left_out.say(std::to_string(unused) +
                     " points are corners of no triangle and have no place in STL");
}

Status write_text(const Mesh& mesh, const std::string& path, LeftOut& left_out) {
    const Attribute* normals = facet_attribute(mesh, "stl:normal", 3);
    const Attribute* solids = facet_attribute(mesh, "stl:solid", 1);
    if (solids && is_float(solids->values.scalar)) solids = nullptr;
    left_out.take(normals);
    left_out.take(solids);
    if (solids) left_out.take_tag_names("stl:solid");
    const Note* name = find_note(mesh, "stl:name");
    left_out.take_notes("stl:name");

    // A name ends with its line, and a zero would make the file a binary one.
    bool odd_name = false;
    const auto of_a_line = [&](const std::string& text) {
        const bool odd = text.find_first_of(std::string_view("\0\r\n", 3)) != std::string::npos;
        odd_name = odd_name || odd;
        return odd ? std::string() : text;
    };
    std::string out, solid_name = name ? of_a_line(name->text) : "";
    const auto tuple = [&](std::string_view before, const Array* array, Index i) {
        out += before;
        for (std::size_t k = 0; k < 3; ++k) {
            out += ' ';
            if (array)
                append_number(out, *array, 3 * i + k);
            else
                out += '0';
        }
        out += '\n';
    };
    const auto begin = [&] {
        out += solid_name.empty() ? "solid\n" : "solid " + solid_name + "\n";
    };
    const auto end = [&] {
        out += solid_name.empty() ? "endsolid\n" : "endsolid " + solid_name + "\n";
    };
    std::int64_t now = 0;
    const auto named = [&](std::int64_t number) {
        const TagName* tag = find_tag_name(mesh, "stl:solid", number);
        return tag ? of_a_line(tag->name) : std::string();
    };
    if (solids) solid_name = named(0);
    begin();
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        std::int64_t solid = now;
        if (solids) integer_at(solids->values, c, solid);
        // Solids without triangles keep the numbers of those that follow.
        while (now != solid) {
            end();
            now = now < solid ? now + 1 : solid;
            solid_name = named(now);
            begin();
        }
        tuple("facet normal", normals ? &normals->values : nullptr, c);
        out += "outer loop\n";
        for (const Index p : mesh.cell(c)) tuple("vertex", &mesh.positions, p);
        out += "endloop\nendfacet\n";
    }
    while (solids && find_tag_name(mesh, "stl:solid", now + 1)) {
        end();
        solid_name = named(++now);
        begin();
    }
    end();
    if (odd_name) left_out.say("names of solids that hold line ends or zeros have no place in STL");
    return write_file(path, out);
}

Status write_binary(const Mesh& mesh, const std::string& path, LeftOut& left_out) {
    if (mesh.cell_count() > std::numeric_limits<std::uint32_t>::max())
        return cannot_hold(path, "binary STL holds at most 4294967295 triangles");
    const auto as_float = [](const Array& array, std::size_t i, float& value) {
        if (array.scalar == Scalar::f32) {
            value = array.as<float>()[i];
            return true;
        }
        const double wide = real_at(array, i);
        value = static_cast<float>(wide);
        return wide != wide || static_cast<double>(value) == wide;
    };
    const Attribute* normals = facet_attribute(mesh, "stl:normal", 3);
    if (normals && normals->values.scalar != Scalar::f32) normals = nullptr;
    const Attribute* extra = facet_attribute(mesh, "stl:attribute", 1);
    if (extra && extra->values.scalar != Scalar::u16) extra = nullptr;
    left_out.take(normals);
    left_out.take(extra);
    left_out.take_notes("stl:header");

    std::string out(kHeader, '\0');
    if (const Note* header = find_note(mesh, "stl:header"))
        std::copy_n(header->text.begin(), std::min(header->text.size(), kHeader), out.begin());
    const auto count = static_cast<std::uint32_t>(mesh.cell_count());
    out.append(reinterpret_cast<const char*>(&count), sizeof count);
    out.reserve(kPrefix + kFacet * mesh.cell_count());
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        std::array<char, kFacet> facet{};
        if (normals) std::memcpy(facet.data(), normals->values.bytes.data() + 12 * c, 12);
        std::size_t at = 12;
        for (const Index p : mesh.cell(c))
            for (std::size_t k = 0; k < 3; ++k, at += 4) {
                float value = 0;
                if (!as_float(mesh.positions, 3 * p + k, value))
                    return cannot_hold(path,
                                       "binary STL holds float32, and a coordinate of point " +
                                           std::to_string(p) + " is not one; STL as text holds it");
                std::memcpy(facet.data() + at, &value, 4);
            }
        if (extra) std::memcpy(facet.data() + 48, extra->values.bytes.data() + 2 * c, 2);
        out.append(facet.data(), facet.size());
    }
    return write_file(path, out);
}

}  // namespace

Result<Mesh> read_stl(const std::string& path) {
    Result<std::string> bytes = read_file(path);
    if (!bytes) return bytes.error();
    if (is_text(*bytes)) return TextStlReader(*bytes, path).read();
    return read_binary(*bytes, path);
}

Status write_stl(const Mesh& mesh, const std::string& path, const WriteOptions& options,
                 Sentences* left_out_sentences) {
    if (Status status = check_triangles(mesh, path); !status) return status;
    LeftOut left_out(mesh, "STL");
    tell_points(mesh, left_out);
    Status status =
        options.binary ? write_binary(mesh, path, left_out) : write_text(mesh, path, left_out);
    left_out.report(left_out_sentences);
    return status;
}

}  // namespace ravel::io
