// What a writer had no place for. A writer takes what it writes; the rest is reported, one sentence
// each, so that nothing is dropped silently.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ravel/mesh.h"

namespace ravel::io {

class LeftOut {
  public:
    LeftOut(const Mesh& mesh, std::string format);

    void take(const Attribute* attribute);  // nullptr is nothing to take
    void take_block(std::size_t companion_block);
    void take_tag_names(std::string_view attribute);
    void take_notes(std::string_view key);
    void say(std::string sentence);  // anything else that the file won't hold

    // Everything that was not taken, appended to `sentences` (which may be nullptr).
    void report(std::vector<std::string>* sentences) const;

  private:
    const Mesh& mesh_;
    std::string format_;
    std::vector<bool> attributes_, blocks_, tag_names_, notes_;
    std::vector<std::string> said_;
};

// The error of a writer whose format can't hold the mesh's cells or points.
Error cannot_hold(const std::string& path, const std::string& sentence);

}  // namespace ravel::io
