#include <catch2/catch.hpp>

#include "io/attributes.h"
#include "support/temp_files.h"

using namespace ravel;
using namespace ravel::test;

namespace {
std::string trouble(std::string_view text) {
    return trouble_reading_again("a.off", text);
}
std::string error(std::string_view text) {
    return error_of("a.off", text);
}
}  // namespace

TEST_CASE("OFF without points or faces comes back", "[io][off]") {
    CHECK(trouble("OFF\n0 0 0\n") == "");
    CHECK(trouble("OFF 2 0 0\n0 0 0\n-0 nan 1e300\n") == "");
}

TEST_CASE("OFF comments may start right behind a number", "[io][off]") {
    const std::string text =
        "COFF # colours\n3 1 0#edges\n0 0 0 1 0 0#red\n1 0 0 0 0 1 #blue\n0 1 0 0 0 1#\n3 0 1 "
        "2#f\n";
    const Result<Mesh> mesh = read_bytes("a.off", text);
    REQUIRE(mesh);
    CHECK(io::find_attribute(*mesh, Place::point, "off:color")->values.count() == 3);
    CHECK(trouble(text) == "");
}

TEST_CASE("OFF counts stand on the header line or the next, with or without the keyword",
          "[io][off]") {
    for (const char* text : {"OFF 1 1 0\n0 0 0\n1 0\n", "OFF\n# words\n1 1 0\n\n0 0 0\n1 0\n",
                             "1 1 0\n0 0 0\n1 0\n", "OFF\n1 1\n0 0 0 # here too\n1 0\n"}) {
        CHECK(read_bytes("a.off", text)->corners == std::vector<Index>{0});
        CHECK(trouble(text) == "");
    }
}

TEST_CASE("OFF keeps faces of any degree, repeated corners and duplicates", "[io][off]") {
    const char* text =
        "OFF\n3 6 0\n0 0 0\n1 0 0\n0 1 0\n0\n1 2\n2 0 1\n3 0 0 0\n3 0 1 2\n3 0 1 2\n";
    CHECK(read_bytes("a.off", text)->cell_count() == 6);
    CHECK(trouble(text) == "");
}

TEST_CASE("three quads on one edge load with all eight points", "[io][off]") {
    const char* text =
        "OFF\n8 3 0\n0 0 0\n0 0 1\n1 0 0\n1 0 1\n0 1 0\n0 1 1\n-1 0 0\n-1 0 1\n"
        "4 0 1 3 2\n4 0 1 5 4\n4 0 1 7 6\n";
    CHECK(read_bytes("a.off", text)->point_count() == 8);
    CHECK(trouble(text) == "");
}

TEST_CASE("OFF colours of points and faces come back, where all or some have one", "[io][off]") {
    CHECK(trouble("COFF\n2 1 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 128\n2 0 1 10 20 30\n") == "");
    CHECK(trouble("OFF\n1 3 0\n0 0 0\n1 0 1 0 0\n1 0\n1 0 255 255 0 7\n") == "");
    CHECK(trouble("OFF\n1 2 0\n0 0 0\n1 0 3\n1 0 4\n") == "");
}

TEST_CASE("OFF colours written with a point stay floats", "[io][off]") {
    const char* text = "OFF\n1 1 0\n0 0 0\n1 0 1.0 0.0 1.0\n";
    const Result<Mesh> mesh = read_bytes("a.off", text);
    REQUIRE(mesh);
    CHECK(io::find_attribute(*mesh, Place::cell, "off:color")->values.scalar == Scalar::f32);
    CHECK(trouble(text) == "");
}

TEST_CASE("OFF normals and texture coordinates of points come back", "[io][off]") {
    CHECK(trouble("STCNOFF\n1 0 0\n0 0 0 0 0 1 9 8 7 0.5 0.25\n") == "");
    CHECK(trouble("NOFF\n1 0 0\n0 0 0 0 0 1\n") == "");
    CHECK(trouble("STOFF\n1 0 0\n0 0 0 0.5 1\n") == "");
}

TEST_CASE("wrong OFF files get one line that says where and what", "[io][off]") {
    CHECK(error("") == "a.off:1: expected the keyword OFF, but the file ends");
    CHECK(error("PLY\n") == "a.off:1: expected the keyword OFF, found 'PLY'");
    CHECK(error("4OFF\n0 0 0\n").find("in three dimensions, found '4OFF'") != std::string::npos);
    CHECK(error("OFF BINARY\n").find("as text") != std::string::npos);
    CHECK(error("OFF\n-1 0 0\n").find("a.off:2: expected the number of points") == 0);
    CHECK(error("OFF\n99999999999 1 0\n").find("more than the file can hold") != std::string::npos);
    CHECK(error("OFF\n1 18446744073709551615 0\n").find("a.off:2: ") == 0);
    CHECK(error("OFF\n1 1 0\n0 0 0\n3 0 0 1\n") ==
          "a.off:4: expected a corner of face 1 of 1, from 0 to 0, found '1'");
    CHECK(error("OFF\n1 1 0\n0 0 0\n3 0     0\n").find("but the file ends") != std::string::npos);
    CHECK(error("OFF\n2 0 0\n0 0 0\n1 2 x\n").find("a.off:4: expected a coordinate") == 0);
    CHECK(error("OFF\n1 0 0\n0 0 0\n1 0\n").find("a.off:4: expected the end of the file") == 0);
    CHECK(error("OFF\n1 1 0\n0 0 0\n1 0 1 2\n").find("a.off:4: expected a colour") == 0);
    CHECK(error("OFF\n1 1 0\n0 0 0\n999999999 0\n").find("more corners than the file") !=
          std::string::npos);
}
