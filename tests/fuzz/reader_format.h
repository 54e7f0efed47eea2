// Which format a reader's fuzz target is for; CMakeLists.txt makes one definition per target.
#pragma once

namespace ravel::test {

extern const char* const kFormat;

}  // namespace ravel::test
