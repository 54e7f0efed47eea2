// Wavefront OBJ, reading. Texture coordinates and normals stay the pools they are in the file.
#include <array>
#include <limits>
#include <map>

#include "io/attributes.h"
#include "io/decimals.h"
#include "io/file_bytes.h"
#include "io/formats.h"
#include "io/text_reader.h"

namespace ravel::io {

namespace {

// A statement that holds for all faces after it: usemtl, g, o. Names are numbered as they come.
struct NamedState {
    std::string attribute;
    std::map<std::string, std::int32_t, std::less<>> numbers;
    std::vector<std::string> names;
    std::vector<std::int32_t> of_cell;
    std::int32_t now = -1;
    bool seen = false;

    void set(std::string_view name) {
        seen = true;
        if (name.empty()) {
            now = -1;
            return;
        }
        const auto next = static_cast<std::int32_t>(names.size());
        const auto [place, is_new] = numbers.emplace(std::string(name), next);
        if (is_new) names.emplace_back(name);
        now = place->second;
    }
};

// What a face may refer to, with the farthest reference to something not yet read.
struct Pool {
    std::string name;
    std::uint64_t count = 0;
    std::uint64_t farthest = 0;
    std::size_t farthest_at = 0;
    std::vector<Index> of_corner;
};

// Values that only some of the points have.
struct SomePoints {
    std::string attribute;
    std::uint32_t arity = 1;
    std::vector<double> numbers;
    std::vector<Index> index;
};

class ObjReader {
  public:
    ObjReader(std::string_view text, const std::string& path)
        : in_(text, path, {.comment = '#', .continued_lines = true}) {}

    Result<Mesh> read();

  private:
    Status statement(std::string_view keyword);
    Status point();
    Status tuple(std::vector<double>& numbers, std::vector<std::uint8_t>& arities,
                 std::size_t fewest, std::size_t most, const std::string& what);
    Status face();
    Status line_or_points(bool is_line);
    Status smoothing();
    bool corner(std::array<Index, 3>& references);
    bool reference(const char*& at, const char* end, Pool& pool, Index& index);
    Status check_references();
    void finish_states();
    void finish_pool(Pool& pool, std::vector<double>& numbers,
                     const std::vector<std::uint8_t>& arities);

    TextReader in_;
    Mesh mesh_;
    std::vector<double> positions_, texture_, normals_;
    std::vector<std::uint8_t> texture_arity_, normal_arity_;
    SomePoints color_{"obj:color", 3, {}, {}}, alpha_{"obj:alpha", 1, {}, {}},
        weight_{"obj:w", 1, {}, {}};
    Pool points_{"v", 0, 0, 0, {}}, texture_pool_{"vt", 0, 0, 0, {}},
        normal_pool_{"vn", 0, 0, 0, {}};
    NamedState material_{"obj:material", {}, {}, {}, -1, false},
        group_{"obj:group", {}, {}, {}, -1, false}, object_{"obj:object", {}, {}, {}, -1, false};
    std::vector<std::int32_t> smoothing_of_cell_;
    std::int32_t smoothing_ = -1;
    bool smoothing_seen_ = false;
    bool known_statement_ = false;
    std::uint64_t unknown_line_ = 0;
    std::string unknown_word_;
};

Status ObjReader::point() {
    std::array<double, 7> numbers{};
    std::size_t count = 0;
    while (!in_.line_ended()) {
        if (count == numbers.size()) return in_.error("expected 3, 4, 6 or 7 numbers after v");
        if (!in_.read_in_line(numbers[count++])) return in_.expected("a number after v");
    }
    if (count < 3 || count == 5)
        return in_.error("expected 3, 4, 6 or 7 numbers after v, found " + std::to_string(count));
    positions_.insert(positions_.end(), numbers.begin(), numbers.begin() + 3);
    const auto add = [&](SomePoints& some, bool has, std::size_t from) {
        if (!has && some.index.empty() && some.numbers.empty()) return;
        some.index.resize(points_.count, kNoIndex);  // the points before had none
        some.index.push_back(has ? some.numbers.size() / some.arity : kNoIndex);
        if (has) {
            const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(from);
            some.numbers.insert(some.numbers.end(), first, first + some.arity);
        }
    };
    add(weight_, count == 4, 3);
    add(color_, count >= 6, 3);
    add(alpha_, count == 7, 6);
    ++points_.count;
    return Done{};
}

// Shorter tuples than the longest are filled with the zeros they stand for.
Status ObjReader::tuple(std::vector<double>& numbers, std::vector<std::uint8_t>& arities,
                        std::size_t fewest, std::size_t most, const std::string& what) {
    std::size_t count = 0;
    for (; !in_.line_ended(); ++count) {
        double number = 0;
        if (count == most)
            return in_.error("expected at most " + std::to_string(most) + " numbers after " + what);
        if (!in_.read_in_line(number)) return in_.expected("a number after " + what);
        numbers.push_back(number);
    }
    if (count < fewest) return in_.expected("a number after " + what);
    arities.push_back(static_cast<std::uint8_t>(count));
    return Done{};
}

// "7" or "-1" of a corner such as "7/-1/3"; empty means none.
bool ObjReader::reference(const char*& at, const char* end, Pool& pool, Index& index) {
    index = kNoIndex;
    if (at == end || *at == '/') return true;
    std::int64_t number = 0;
    if (*at == '+') ++at;
    const auto [stop, error] = std::from_chars(at, end, number);
    if (error != std::errc{} || number == 0) return false;
    at = stop;
    if (number < 0) {
        const std::uint64_t back = std::uint64_t{0} - static_cast<std::uint64_t>(number);
        if (back > pool.count) return false;
        index = pool.count - back;
        return true;
    }
    index = static_cast<Index>(number) - 1;
    if (index >= pool.farthest) {
        pool.farthest = index + 1;
        pool.farthest_at = in_.offset();
    }
    return true;
}

bool ObjReader::corner(std::array<Index, 3>& references) {
    references.fill(kNoIndex);
    const std::string_view word = in_.line_word();
    const char* at = word.data();
    const char* end = at + word.size();
    if (!reference(at, end, points_, references[0]) || references[0] == kNoIndex) return false;
    if (at == end) return true;
    if (*at++ != '/' || !reference(at, end, texture_pool_, references[1])) return false;
    if (at == end) return true;
    return *at++ == '/' && reference(at, end, normal_pool_, references[2]) && at == end;
}

Status ObjReader::face() {
    const auto keep = [&](Pool& pool, Index index, std::size_t corners_before) {
        if (index == kNoIndex && pool.of_corner.empty()) return;
        pool.of_corner.resize(corners_before, kNoIndex);
        pool.of_corner.push_back(index);
    };
    std::array<Index, 3> references{};
    while (!in_.line_ended()) {
        if (!corner(references))
            return in_.expected("a corner like 1, 1/2, 1//3 or 1/2/3 that names what exists (" +
                                std::to_string(points_.count) + " points so far)");
        const std::size_t before = mesh_.corners.size();
        mesh_.corners.push_back(references[0]);
        keep(texture_pool_, references[1], before);
        keep(normal_pool_, references[2], before);
    }
    mesh_.corner_begin.push_back(mesh_.corners.size());
    for (NamedState* state : {&material_, &group_, &object_}) state->of_cell.push_back(state->now);
    smoothing_of_cell_.push_back(smoothing_);
    return Done{};
}

Status ObjReader::line_or_points(bool is_line) {
    std::vector<Index> nodes;
    std::array<Index, 3> references{};
    while (!in_.line_ended()) {
        if (!corner(references)) return in_.expected("a point's number that exists");
        nodes.push_back(references[0]);
    }
    const auto add = [&](std::uint16_t vtk_type, std::span<const Index> cell) {
        const auto size = static_cast<std::uint32_t>(cell.size());
        if (mesh_.companions.empty() || mesh_.companions.back().vtk_type != vtk_type ||
            mesh_.companions.back().nodes_per_cell != size)
            mesh_.companions.push_back({vtk_type, size, 0, {}, {}});
        CompanionBlock& block = mesh_.companions.back();
        block.nodes.insert(block.nodes.end(), cell.begin(), cell.end());
        ++block.cell_count;
    };
    constexpr std::uint16_t kVertex = 1, kLine = 3, kPolyLine = 4;
    if (is_line) {
        add(nodes.size() == 2 ? kLine : kPolyLine, nodes);
    } else {
        for (const Index& node : nodes) add(kVertex, {&node, 1});
    }
    return Done{};
}

Status ObjReader::smoothing() {
    smoothing_seen_ = true;
    const std::string_view word = in_.rest_of_line();
    if (word.empty()) {
        smoothing_ = -1;
    } else if (same_word(word, "off")) {
        smoothing_ = 0;
    } else if (same_word(word, "on")) {
        smoothing_ = 1;
    } else if (!parse_integer(word, smoothing_)) {
        return in_.error("expected a smoothing group's number or off after s, found '" +
                         std::string(word) + "'");
    }
    return Done{};
}

Status ObjReader::statement(std::string_view keyword) {
    if (keyword == "v") return point();
    if (keyword == "f" || keyword == "fo") return face();
    if (keyword == "vt") {
        ++texture_pool_.count;
        return tuple(texture_, texture_arity_, 1, 3, "vt");
    }
    if (keyword == "vn") {
        ++normal_pool_.count;
        return tuple(normals_, normal_arity_, 3, 3, "vn");
    }
    if (keyword == "usemtl") {
        material_.set(in_.rest_of_line());
    } else if (keyword == "g") {
        group_.set(in_.rest_of_line());
    } else if (keyword == "o") {
        object_.set(in_.rest_of_line());
    } else if (keyword == "s") {
        return smoothing();
    } else if (keyword == "mtllib") {
        mesh_.notes.push_back({"obj:mtllib", std::string(in_.rest_of_line())});
    } else if (keyword == "l") {
        return line_or_points(true);
    } else if (keyword == "p") {
        return line_or_points(false);
    } else {
        if (unknown_line_ == 0) {
            unknown_line_ = in_.line();
            unknown_word_ = keyword.substr(0, 40);
        }
        // Kept as words, so that nothing goes silently; a writer says that it has no place for
        // them.
        std::string words(keyword);
        words += ' ';
        words += in_.rest_of_line();
        mesh_.notes.push_back({"obj:statement", std::move(words)});
        return Done{};
    }
    known_statement_ = true;
    return Done{};
}

Status ObjReader::check_references() {
    for (const Pool* pool : {&points_, &texture_pool_, &normal_pool_})
        if (pool->farthest > pool->count) {
            in_.seek(pool->farthest_at);
            return in_.error("refers to " + pool->name + " " + std::to_string(pool->farthest) +
                             ", but the file has " + std::to_string(pool->count));
        }
    return Done{};
}

void ObjReader::finish_pool(Pool& pool, std::vector<double>& numbers,
                            const std::vector<std::uint8_t>& arities) {
    if (arities.empty()) return;
    std::uint8_t arity = 1;
    bool mixed = false;
    for (const std::uint8_t a : arities) {
        mixed = mixed || a != arities.front();
        arity = std::max(arity, a);
    }
    if (mixed) {
        std::vector<double> filled;
        filled.reserve(arities.size() * arity);
        const double* at = numbers.data();
        for (const std::uint8_t a : arities) {
            for (std::uint8_t k = 0; k < arity; ++k) filled.push_back(k < a ? *at++ : 0.0);
        }
        numbers = std::move(filled);
    }
    // Without corners there is no index that could tell a pool from one value per corner.
    const Place place = mesh_.corners.empty() ? Place::mesh : Place::corner;
    pool.of_corner.resize(mesh_.corners.size(), kNoIndex);
    add_attribute(mesh_, "obj:" + pool.name, place, floats_from_text(numbers, arity),
                  std::move(pool.of_corner));
}

void ObjReader::finish_states() {
    for (NamedState* state : {&material_, &group_, &object_}) {
        if (!state->seen) continue;
        add_attribute(mesh_, state->attribute, Place::cell, array_of(state->of_cell, 1));
        for (std::size_t i = 0; i < state->names.size(); ++i)
            mesh_.tag_names.push_back(
                {state->attribute, -1, static_cast<std::int64_t>(i), state->names[i]});
    }
    if (smoothing_seen_)
        add_attribute(mesh_, "obj:smoothing", Place::cell, array_of(smoothing_of_cell_, 1));
}

Result<Mesh> ObjReader::read() {
    mesh_.corner_begin.push_back(0);
    while (in_.next_filled_line()) {
        const std::string_view keyword = in_.line_word();
        if (Status status = statement(keyword); !status) return status.error();
    }
    if (unknown_line_ != 0 && !known_statement_ && points_.count == 0 && normals_.empty() &&
        texture_.empty() && mesh_.corner_begin.size() == 1)
        return Error{Code::unreadable, unknown_line_,
                     in_.file() + ":" + std::to_string(unknown_line_) +
                         ": expected an OBJ statement such as v or f; the file has none"};
    if (Status status = check_references(); !status) return status.error();

    mesh_.positions = floats_from_text(positions_, 3);
    for (SomePoints* some : {&weight_, &color_, &alpha_}) {
        if (some->numbers.empty()) continue;
        if (some->numbers.size() / some->arity == points_.count) {
            some->index.clear();
        } else {
            some->index.resize(points_.count, kNoIndex);
        }
        add_attribute(mesh_, some->attribute, Place::point,
                      floats_from_text(some->numbers, some->arity), std::move(some->index));
    }
    finish_pool(texture_pool_, texture_, texture_arity_);
    finish_pool(normal_pool_, normals_, normal_arity_);
    finish_states();
    return std::move(mesh_);
}

}  // namespace

Result<Mesh> read_obj(const std::string& path) {
    Result<std::string> text = read_file(path);
    if (!text) return text.error();
    return ObjReader(*text, path).read();
}

}  // namespace ravel::io
