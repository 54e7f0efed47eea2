// Makes the invalid files out of the valid ones, stored unpacked: each function those of some rows.
#pragma once

#include <functional>
#include <map>
#include <stdexcept>

#include "spec/invalid_files.h"
#include "support/file_parts.h"

namespace ravel::test {

inline std::byte byte(unsigned value) {
    return static_cast<std::byte>(value);
}

class InvalidMaker {
  public:
    InvalidMaker();

    void container();
    void heads();
    void counts();
    void walks();
    void positions();
    void companions();
    void attributes();
    void orders();
    std::vector<InvalidFile> take() { return std::move(made_); }

  private:
    const Bytes& valid(const char* name) const {
        const auto found = valid_.find(name);
        if (found == valid_.end()) throw std::runtime_error(std::string("no valid file ") + name);
        return found->second;
    }
    const Bytes& quads() const { return valid("two-quads"); }
    void add(int row, const char* name, const char* says, Bytes bytes, Code code = Code::corrupt) {
        made_.push_back({row, (row < 10 ? "0" : "") + std::to_string(row) + "-" + name, code, says,
                         std::move(bytes)});
    }
    Bytes raw_changed(const char* name, SectionId id,
                      const std::function<void(Bytes&)>& change) const {
        return with_section(valid(name), id, change);
    }
    template <class Change>
    Bytes head_changed(const char* name, const Change& change) const {
        return with_head(valid(name), change);
    }
    template <class Change>
    Bytes block_changed(const char* name, CellKind kind, const Change& change) const {
        return with_block_head(valid(name), kind, change);
    }

    std::map<std::string, Bytes> valid_;
    std::vector<InvalidFile> made_;
};

}  // namespace ravel::test
