#include "ravel/result.h"

#include <catch2/catch.hpp>

#include <set>
#include <string>

using namespace ravel;

TEST_CASE("each error code has a name of its own, and no other number has one") {
    std::set<std::string> names;
    int codes = 0;
    while (name_of(static_cast<Code>(codes)) != std::string("unknown"))
        names.insert(name_of(static_cast<Code>(codes++)));
    CHECK(codes == static_cast<int>(Code::unwritable) + 1);
    CHECK(names.size() == static_cast<std::size_t>(codes));
    CHECK(name_of(Code::not_a_ravel_file) == std::string("not_a_ravel_file"));
}
