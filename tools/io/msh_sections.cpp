// Sections that both versions of MSH files have: names, entities, data, and those kept as they are.
#include <algorithm>
#include <array>

#include "io/attributes.h"
#include "io/msh_stream.h"
#include "io/typed_values.h"

namespace ravel::io {

namespace {

// What stands between the first and the last quote; the word as it is where there are none.
std::string unquoted(std::string_view text) {
    const std::size_t first = text.find('"');
    const std::size_t last = text.rfind('"');
    if (first == std::string_view::npos || last == first) return std::string(text);
    return std::string(text.substr(first + 1, last - first - 1));
}

// The tags above data are text in binary files, too.
bool read_text_count(TextReader& text, Index& count) {
    return text.read(count) && count <= text.bytes_left() / 2 + 1;
}

bool read_entity(MshInput& in, std::size_t dimension, MshEntity& entity) {
    if (!in.get(entity.tag)) return false;
    for (std::size_t i = 0; i < (dimension == 0 ? 3U : 6U); ++i) {
        if (!in.get(entity.box[i])) return false;
    }
    for (auto* tags : {&entity.physical, &entity.bounds}) {
        if (tags == &entity.bounds && dimension == 0) return true;
        std::uint64_t count = 0;
        if (!in.get(count) || !in.has_room(count, 4, 1)) return false;
        tags->resize(count);
        for (std::int32_t& tag : *tags) {
            if (!in.get(tag)) return false;
        }
    }
    return true;
}

// Where the end of a section begins; in text it stands at the beginning of a line.
std::size_t find_end(std::string_view text, const std::string& end, bool binary) {
    std::size_t at = text.find(end);
    while (!binary && at != std::string_view::npos && at != 0 && text[at - 1] != '\n')
        at = text.find(end, at + 1);
    return at;
}

// Reads the rows "tag value value ...", integer and doubles in binary files.
Status read_rows(MshInput& in, Index rows, std::uint32_t arity, MshData& data) {
    if (arity == 0 || !in.has_room(rows, 4 + 8 * Index{arity}, 1 + Index{arity})) {
        return in.fault(std::to_string(rows) + " rows of " + std::to_string(arity) +
                        " values are announced for '" + data.name +
                        "', more than the file can hold");
    }
    std::vector<double> numbers;
    numbers.reserve(rows * arity);
    data.tags.reserve(rows);
    for (Index r = 0; r < rows; ++r) {
        std::int64_t tag = 0;
        if (!in.get_as<std::int32_t>(tag)) return in.missing("a tag of '" + data.name + "'");
        if (tag < 0) return in.fault("a tag of '" + data.name + "' is negative");
        data.tags.push_back(static_cast<Index>(tag));
        for (std::uint32_t k = 0; k < arity; ++k) {
            double value = 0;
            if (!in.get(value)) return in.missing("a value of '" + data.name + "'");
            numbers.push_back(value);
        }
    }
    data.values = array_of(numbers, arity);
    return Done{};
}

}  // namespace

bool TagLookup::fill(const std::vector<Index>& tags, Index& twice) {
    counted_ = 0;
    sorted_.clear();
    while (counted_ < tags.size() && tags[counted_] == counted_ + 1) ++counted_;
    for (Index i = counted_; i < tags.size(); ++i) sorted_.emplace_back(tags[i], i);
    std::sort(sorted_.begin(), sorted_.end());
    for (std::size_t i = 0; i < sorted_.size(); ++i) {
        twice = sorted_[i].first;
        if (twice >= 1 && twice <= counted_) return false;
        if (i > 0 && sorted_[i - 1].first == twice) return false;
    }
    return true;
}

Index TagLookup::find(Index tag) const {
    if (tag >= 1 && tag <= counted_) return tag - 1;
    const auto found =
        std::lower_bound(sorted_.begin(), sorted_.end(), std::pair<Index, Index>(tag, 0));
    return found != sorted_.end() && found->first == tag ? found->second : kNoIndex;
}

Status read_physical_names(MshInput& in, std::vector<TagName>& names) {
    Index count = 0;
    if (!read_text_count(in.text, count)) return in.text.expected("the number of physical names");
    for (Index i = 0; i < count; ++i) {
        TagName name{kGmshPhysical, 0, 0, {}};
        if (!in.text.read(name.dimension) || !in.text.read(name.value)) {
            return in.text.expected("dimension and tag of a physical name");
        }
        if (name.dimension < 0 || name.dimension > 3) {
            return in.text.error("a physical name has a dimension from 0 to 3");
        }
        name.name = unquoted(in.text.rest_of_line());
        names.push_back(std::move(name));
    }
    return Done{};
}

Status read_entities(MshInput& in, MshEntities& entities) {
    std::array<std::uint64_t, 4> counts{};
    for (std::uint64_t& count : counts) {
        if (!in.get(count)) return in.missing("the number of entities");
    }
    for (std::size_t dimension = 0; dimension < 4; ++dimension) {
        if (!in.has_room(counts[dimension], 36, 5)) {
            return in.fault(std::to_string(counts[dimension]) +
                            " entities are announced, more than the file can hold");
        }
        for (std::uint64_t i = 0; i < counts[dimension]; ++i) {
            MshEntity entity;
            if (!read_entity(in, dimension, entity)) {
                return in.missing("an entity of dimension " + std::to_string(dimension));
            }
            entities[dimension].push_back(std::move(entity));
        }
    }
    return Done{};
}

void put_entities(MshOutput& out, const MshEntities& entities) {
    for (const auto& of_dimension : entities) {
        out.put(static_cast<std::uint64_t>(of_dimension.size()));
    }
    out.end_line();
    for (std::size_t dimension = 0; dimension < 4; ++dimension) {
        for (const MshEntity& entity : entities[dimension]) {
            out.put(entity.tag);
            for (std::size_t i = 0; i < (dimension == 0 ? 3U : 6U); ++i) out.put(entity.box[i]);
            for (const auto* tags : {&entity.physical, &entity.bounds}) {
                if (tags == &entity.bounds && dimension == 0) break;
                out.put(static_cast<std::uint64_t>(tags->size()));
                for (const std::int32_t tag : *tags) out.put(tag);
            }
            out.end_line();
        }
    }
}

Status read_data_section(MshInput& in, Place place, MshData& data) {
    TextReader& text = in.text;
    data.place = place;
    Index strings = 0, reals = 0, integers = 0;
    if (!read_text_count(text, strings)) return text.expected("the number of string tags");
    std::string extra_strings, real_words, integer_words;
    for (Index i = 0; i < strings; ++i) {
        text.next_line();
        const std::string string = unquoted(text.rest_of_line());
        if (i == 0)
            data.name = string;
        else
            extra_strings += "string " + string + '\n';
    }
    if (!read_text_count(text, reals)) return text.expected("the number of real tags");
    bool default_real = reals == 1;
    for (Index i = 0; i < reals; ++i) {
        const std::string_view word = text.word();
        double value = 0;
        if (!parse_real(word, value)) return text.expected("a real tag");
        default_real = default_real && value == 0;
        real_words += ' ' + std::string(word);
    }
    if (!read_text_count(text, integers)) return text.expected("the number of integer tags");
    if (integers < 3) return text.error("data need at least three integer tags");
    std::int64_t arity = 0, rows = 0;
    for (Index i = 0; i < integers; ++i) {
        std::int64_t value = 0;
        if (!text.read(value)) return text.expected("an integer tag");
        if (i == 1)
            arity = value;
        else if (i == 2)
            rows = value;
        else
            integer_words += ' ' + std::to_string(value);
    }
    if (!(strings == 1 && default_real && integer_words == " 0")) {
        data.header = extra_strings + "reals" + real_words + "\nintegers" + integer_words;
    }
    if (arity < 1 || arity > 1 << 20 || rows < 0) {
        return text.error("data of " + std::to_string(arity) + " components and " +
                          std::to_string(rows) + " rows can't be");
    }
    if (in.binary) text.next_line();
    return read_rows(in, static_cast<Index>(rows), static_cast<std::uint32_t>(arity), data);
}

bool has_binary_form(const std::string& section) {
    for (const char* name : {"Periodic", "PartitionedEntities", "GhostElements", "Parametrizations",
                             "ElementNodeData", "Entities"}) {
        if (section == name) return true;
    }
    return false;
}

bool can_be_section(const std::string& name, const std::string& text, bool binary) {
    constexpr std::array<std::string_view, 6> kWritten{"MeshFormat",    "Nodes",    "Elements",
                                                       "PhysicalNames", "NodeData", "ElementData"};
    return !name.empty() && name.find_first_of(" \t\r\n\v\f") == std::string::npos &&
           !name.starts_with("End") && name != kTypesSection &&
           std::find(kWritten.begin(), kWritten.end(), name) == kWritten.end() &&
           find_end(text + "$End" + name, "$End" + name, binary) == text.size();
}

Status read_raw_section(MshInput& in, const std::string& name, MshSection& section) {
    const std::size_t start = in.text.offset();
    const std::string end = "$End" + name;
    const std::string_view rest = in.text.take(in.text.bytes_left());
    in.text.seek(start);
    const std::size_t at = find_end(rest, end, in.binary);
    if (at == std::string_view::npos) return in.fault("section $" + name + " has no " + end);
    section = {name, std::string(rest.substr(0, at)), in.binary && has_binary_form(name)};
    in.text.take(at);
    return Done{};
}

Status read_types_section(MshInput& in, std::vector<MshType>& types) {
    MshSection section;
    if (Status status = read_raw_section(in, kTypesSection, section); !status) return status;
    TextReader lines(section.text, in.text.file(), {'\0', false});
    while (true) {
        MshType type{std::string(lines.word()), Scalar::f64, {}};
        if (type.section.empty()) return Done{};
        const std::string_view scalar = lines.line_word();
        for (int s = 0; s <= static_cast<int>(Scalar::f64); ++s) {
            if (scalar == name_of(static_cast<Scalar>(s))) type.scalar = static_cast<Scalar>(s);
        }
        type.name = unquoted(lines.rest_of_line());
        types.push_back(std::move(type));
    }
}

}  // namespace ravel::io
