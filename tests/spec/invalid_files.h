// The invalid files of spec/vectors: one fault each, by the rows of chapter 14 of spec/format.md.
#pragma once

#include <string>
#include <vector>

#include "base/bytes.h"
#include "ravel/result.h"

namespace ravel::test {

struct InvalidFile {
    int row = 0;
    std::string name;
    Code code = Code::corrupt;
    std::string says;
    Bytes bytes;
};

std::vector<InvalidFile> invalid_files();

}  // namespace ravel::test
