// Polygon file format, from bytes to columns.
#include <algorithm>
#include <bit>
#include <cstring>

#include "io/attributes.h"
#include "io/file_bytes.h"
#include "io/ply_file.h"
#include "io/text_reader.h"

namespace ravel::io {

const PlyProperty* PlyElement::find(std::string_view property, bool is_list) const {
    for (const PlyProperty& p : properties)
        if (p.name == property && p.is_list == is_list) return &p;
    return nullptr;
}

const PlyElement* PlyFile::find(std::string_view element) const {
    for (const PlyElement& e : elements)
        if (e.name == element) return &e;
    return nullptr;
}

bool ply_names_points(std::string_view element, const PlyProperty& property) {
    if (is_float(property.type)) return false;
    if (element == "face")
        return property.is_list &&
               (property.name == "vertex_indices" || property.name == "vertex_index");
    return element == "edge" && !property.is_list &&
           (property.name == "vertex1" || property.name == "vertex2");
}

namespace {

enum class Encoding { text, little, big };

bool scalar_named(std::string_view word, Scalar& scalar) {
    struct Name {
        std::string_view word;
        Scalar scalar;
    };
    static constexpr Name kNames[] = {
        {"char", Scalar::i8},     {"int8", Scalar::i8},     {"uchar", Scalar::u8},
        {"uint8", Scalar::u8},    {"short", Scalar::i16},   {"int16", Scalar::i16},
        {"ushort", Scalar::u16},  {"uint16", Scalar::u16},  {"int", Scalar::i32},
        {"int32", Scalar::i32},   {"uint", Scalar::u32},    {"uint32", Scalar::u32},
        {"float", Scalar::f32},   {"float32", Scalar::f32}, {"double", Scalar::f64},
        {"float64", Scalar::f64}, {"int64", Scalar::i64},   {"uint64", Scalar::u64}};
    for (const Name& name : kNames)
        if (name.word == word) {
            scalar = name.scalar;
            return true;
        }
    return false;
}

class PlyReader {
  public:
    PlyReader(std::string_view bytes, const std::string& path)
        : bytes_(bytes), in_(bytes, path, {.comment = '\0'}) {}

    Result<PlyFile> read() {
        if (Status status = header(); !status) return status.error();
        for (PlyElement& element : file_.elements)
            if (Status status = rows(element); !status) return status.error();
        const std::size_t end = in_.offset();
        if (!in_.at_end())
            return encoding_ == Encoding::text
                       ? in_.expected("the end of the file after the last element")
                       : byte_error(in_.file(), end, "the file goes on after the last element");
        return std::move(file_);
    }

  private:
    Status header();
    Status property();
    Status rows(PlyElement& element);
    Status text_row(PlyElement& element);
    Status binary_row(PlyElement& element);
    Status check_points(const PlyElement& element) const;
    Status text_number(Array& values);
    bool binary_numbers(Array& values, std::size_t count);
    Error row_error(const std::string& sentence) const {
        return encoding_ == Encoding::text ? in_.error(sentence)
                                           : byte_error(in_.file(), in_.offset(), sentence);
    }

    std::string_view bytes_;
    TextReader in_;
    PlyFile file_;
    Encoding encoding_ = Encoding::text;
    std::vector<std::size_t> row_at_;  // offsets of the rows of an element that names points
};

Status PlyReader::property() {
    if (file_.elements.empty()) return in_.error("a property before the first element");
    PlyProperty property;
    std::string_view word = in_.line_word();
    if (word == "list") {
        property.is_list = true;
        property.begin = {0};
        if (!scalar_named(in_.line_word(), property.count_type) || is_float(property.count_type))
            return in_.expected("the type of the list's length, an integer type");
        word = in_.line_word();
    }
    if (!scalar_named(word, property.type)) return in_.expected("a type such as float or uchar");
    property.name = in_.line_word();
    if (property.name.empty()) return in_.expected("the property's name");
    property.values = {property.type, 1, {}};
    property.names_points = ply_names_points(file_.elements.back().name, property);
    file_.elements.back().properties.push_back(std::move(property));
    return Done{};
}

Status PlyReader::header() {
    if (in_.line_word() != "ply") return in_.expected("the word ply");
    bool has_format = false;
    while (true) {
        in_.next_line();
        if (!in_.next_filled_line()) return in_.expected("end_header");
        const std::string_view word = in_.line_word();
        if (word == "end_header") break;
        if (word == "format") {
            const std::string_view name = in_.line_word();
            if (name == "ascii")
                encoding_ = Encoding::text;
            else if (name == "binary_little_endian")
                encoding_ = Encoding::little;
            else if (name == "binary_big_endian")
                encoding_ = Encoding::big;
            else
                return in_.expected("ascii, binary_little_endian or binary_big_endian");
            has_format = true;
        } else if (word == "comment" || word == "obj_info") {
            const std::string key = "ply:" + std::string(word);
            file_.notes.push_back({key, std::string(in_.rest_of_line())});
        } else if (word == "element") {
            PlyElement element;
            element.name = in_.line_word();
            if (!in_.read_in_line(element.count)) return in_.expected("the element's count");
            file_.elements.push_back(std::move(element));
        } else if (word == "property") {
            if (Status status = property(); !status) return status;
        } else {
            return in_.expected("format, element, property, comment or end_header");
        }
    }
    in_.next_line();
    if (!has_format) return in_.error("the header has no format line");
    return Done{};
}

Status PlyReader::text_number(Array& values) {
    const std::size_t size = size_of(values.scalar);
    values.bytes.resize(values.bytes.size() + size);
    const bool good = with_values(values, [&](auto numbers) {
        auto number = numbers.back();
        if (!in_.read(number)) return false;
        std::memcpy(values.bytes.data() + values.bytes.size() - size, &number, size);
        return true;
    });
    if (!good) return in_.expected(std::string("a number of type ") + name_of(values.scalar));
    return Done{};
}

Status PlyReader::text_row(PlyElement& element) {
    for (PlyProperty& property : element.properties) {
        std::uint64_t count = 1;
        if (property.is_list) {
            if (!in_.read(count)) return in_.expected("the length of a list");
            if (count > in_.bytes_left() / 2 + 1)
                return in_.error("a list of " + std::to_string(count) +
                                 " numbers is longer than the file");
            property.begin.push_back(property.begin.back() + count);
        }
        for (; count > 0; --count)
            if (Status status = text_number(property.values); !status) return status;
    }
    if (in_.line_ended()) return Done{};
    in_.line_word();
    return in_.expected("the end of the line after a row of " + element.name);
}

bool PlyReader::binary_numbers(Array& values, std::size_t count) {
    const std::size_t size = size_of(values.scalar);
    if (count > in_.bytes_left() / size) return false;
    const std::string_view raw = in_.take(count * size);
    const std::size_t before = values.bytes.size();
    values.bytes.resize(before + raw.size());
    std::memcpy(values.bytes.data() + before, raw.data(), raw.size());
    if (encoding_ == Encoding::big)
        for (std::size_t i = before; i < values.bytes.size(); i += size)
            std::reverse(values.bytes.begin() + static_cast<std::ptrdiff_t>(i),
                         values.bytes.begin() + static_cast<std::ptrdiff_t>(i + size));
    return true;
}

Status PlyReader::binary_row(PlyElement& element) {
    for (PlyProperty& property : element.properties) {
        std::int64_t count = 1;
        if (property.is_list) {
            Array length{property.count_type, 1, {}};
            if (!binary_numbers(length, 1))
                return row_error("the file ends inside element " + element.name);
            if (!integer_at(length, 0, count) || count < 0)
                return row_error("a list of element " + element.name + " has a negative length");
            property.begin.push_back(property.begin.back() + static_cast<Index>(count));
        }
        if (!binary_numbers(property.values, static_cast<std::size_t>(count)))
            return row_error("the file ends inside element " + element.name +
                             ", whose header promises " + std::to_string(element.count) + " rows");
    }
    return Done{};
}

Status PlyReader::rows(PlyElement& element) {
    std::size_t smallest = 0;  // bytes of a row: two per number of text, but for the last
    bool names_points = false;
    for (const PlyProperty& property : element.properties) {
        names_points = names_points || property.names_points;
        smallest += encoding_ == Encoding::text ? 2
                    : property.is_list          ? size_of(property.count_type)
                                                : size_of(property.type);
    }
    if (element.properties.empty()) {
        if (element.count == 0) return Done{};
        return row_error("element " + element.name + " has rows, but no properties");
    }
    if (element.count > (in_.bytes_left() + 1) / smallest)
        return row_error("element " + element.name + " promises " + std::to_string(element.count) +
                         " rows, more than the file can hold");
    for (PlyProperty& property : element.properties) {
        if (property.is_list) property.begin.reserve(element.count + 1);
        property.values.bytes.reserve(element.count * size_of(property.type));
    }
    row_at_.clear();
    for (Index r = 0; r < element.count; ++r) {
        if (names_points) {
            if (encoding_ == Encoding::text) in_.at_end();  // to the first number of the row
            row_at_.push_back(in_.offset());
        }
        Status status = encoding_ == Encoding::text ? text_row(element) : binary_row(element);
        if (!status) return status;
    }
    return check_points(element);
}

Status PlyReader::check_points(const PlyElement& element) const {
    const PlyElement* vertices = file_.find("vertex");
    const Index points = vertices ? vertices->count : 0;
    for (const PlyProperty& property : element.properties) {
        if (!property.names_points) continue;
        const std::size_t bad = with_values(property.values, [&](auto numbers) {
            const auto place = std::find_if(numbers.begin(), numbers.end(), [&](auto number) {
                if constexpr (std::is_integral_v<decltype(number)>)
                    return number < 0 || static_cast<std::uint64_t>(number) >= points;
                else
                    return true;
            });
            return static_cast<std::size_t>(place - numbers.begin());
        });
        if (bad == property.values.count()) continue;
        std::size_t row = bad;
        if (property.is_list)
            row = static_cast<std::size_t>(
                      std::upper_bound(property.begin.begin(), property.begin.end(), bad) -
                      property.begin.begin()) -
                  1;
        std::int64_t number = 0;
        integer_at(property.values, bad, number);
        const std::string sentence = element.name + " " + std::to_string(row) + " names vertex " +
                                     std::to_string(number) + ", but the file has " +
                                     std::to_string(points);
        if (encoding_ != Encoding::text) return byte_error(in_.file(), row_at_[row], sentence);
        TextReader at_row = in_;
        at_row.seek(row_at_[row]);
        return at_row.error(sentence);
    }
    return Done{};
}

}  // namespace

Result<PlyFile> read_ply_file(const std::string& path) {
    Result<std::string> bytes = read_file(path);
    if (!bytes) return bytes.error();
    return PlyReader(*bytes, path).read();
}

}  // namespace ravel::io
