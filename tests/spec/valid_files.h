// The valid files of spec/vectors: small meshes that between them use every part of the format.
#pragma once

#include <string>
#include <vector>

#include "base/bytes.h"

namespace ravel::test {

struct ValidFile {
    std::string name;   // of the files in spec/vectors/valid
    std::string shows;  // what for
    Bytes bytes;
};

// As `encode` packs them. Throws a std::runtime_error where a mesh does not pack.
std::vector<ValidFile> valid_files();

}  // namespace ravel::test
