// Numbers of MSH files, as text or binary by the same calls.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <vector>

#include "io/decimals.h"
#include "io/file_bytes.h"
#include "io/msh_file.h"
#include "io/text_reader.h"

namespace ravel::io {

class MshInput {
  public:
    explicit MshInput(TextReader reader) : text(reader) {}

    TextReader text;
    bool binary = false;
    bool swapped = false;  // the other byte order

    // The next number; false where there is none, see `missing`. Binary ones are of type Stored.
    template <class Stored, class T>
    bool get_as(T& value) {
        if (!binary) return text.read(value);
        const std::string_view raw = text.take(sizeof(Stored));
        if (raw.size() != sizeof(Stored)) return false;
        std::array<char, sizeof(Stored)> bytes{};
        std::copy(raw.begin(), raw.end(), bytes.begin());
        if (swapped) std::reverse(bytes.begin(), bytes.end());
        value = static_cast<T>(std::bit_cast<Stored>(bytes));
        return true;
    }
    template <class T>
    bool get(T& value) {
        return get_as<T>(value);
    }

    // Can `count` items of this many binary bytes, or as many numbers of text, still come?
    bool has_room(std::uint64_t count, std::uint64_t bytes_each, std::uint64_t numbers_each) const {
        return binary ? count <= text.bytes_left() / bytes_each
                      : count <= (text.bytes_left() + 1) / (2 * numbers_each);
    }

    Error missing(const std::string& what) const {
        if (!binary) return text.expected(what);
        return byte_error(text.file(), text.offset(), "the file ends, expected " + what);
    }
    Error fault(const std::string& sentence) const {
        return binary ? byte_error(text.file(), text.offset(), sentence) : text.error(sentence);
    }
};

class MshOutput {
  public:
    explicit MshOutput(bool is_binary) : binary(is_binary) {}

    std::string out;
    bool binary;

    template <class T>
    void put(T value) {
        if (binary) {
            char bytes[sizeof(T)];
            std::memcpy(bytes, &value, sizeof(T));
            out.append(bytes, sizeof(T));
            return;
        }
        if (!out.empty() && out.back() != '\n') out += ' ';
        append_number(out, value);
    }
    void end_line() {
        if (!binary) out += '\n';
    }
    // Sections begin and end with lines in binary files, too.
    void line(std::string_view words) {
        out += words;
        out += '\n';
    }
    void end_section(std::string_view name) {
        if (binary) out += '\n';
        out += "$End";
        line(name);
    }
};

// Finds the place of a tag. Tags are mostly 1, 2, 3 and so on, but need not be.
class TagLookup {
  public:
    // False, with the tag, where one is there twice.
    bool fill(const std::vector<Index>& tags, Index& twice);
    Index find(Index tag) const;  // kNoIndex where there is none

  private:
    Index counted_ = 0;  // tags 1 to this are at their own place
    std::vector<std::pair<Index, Index>> sorted_;
};

Status read_physical_names(MshInput& in, std::vector<TagName>& names);
Status read_entities(MshInput& in, MshEntities& entities);
Status read_data_section(MshInput& in, Place place, MshData& data);
Status read_raw_section(MshInput& in, const std::string& name, MshSection& section);
Status read_types_section(MshInput& in, std::vector<MshType>& types);

Status read_nodes_v2(MshInput& in, MshFile& file);
Status read_elements_v2(MshInput& in, const TagLookup& nodes, MshFile& file);
Status read_nodes_v4(MshInput& in, MshFile& file);
Status read_elements_v4(MshInput& in, const TagLookup& nodes, MshFile& file);

void put_entities(MshOutput& out, const MshEntities& entities);
Status put_nodes_and_elements_v2(MshOutput& out, const MshFile& file, const std::string& path);
Status put_nodes_and_elements_v4(MshOutput& out, const MshFile& file, const std::string& path);

}  // namespace ravel::io
