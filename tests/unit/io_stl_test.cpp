#include <catch2/catch.hpp>
#include <cstring>

#include "io/attributes.h"
#include "support/temp_files.h"

using namespace ravel;
using namespace ravel::test;

namespace {

constexpr const char* kTwo =
    "solid two words\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
    "endloop\nendfacet\n  facet normal 0 0 1\n outer loop\nvertex 0 1 0\nvertex 1 0 0\n"
    "vertex -0 nan 0.5\nendloop\nendfacet\nendsolid two words\n";

std::string binary_stl(std::string header, std::uint32_t count, std::vector<float> numbers,
                       std::uint16_t extra) {
    header.resize(80);
    header.append(reinterpret_cast<const char*>(&count), 4);
    for (std::size_t c = 0; 12 * c < numbers.size(); ++c) {
        header.append(reinterpret_cast<const char*>(numbers.data() + 12 * c), 48);
        header.append(reinterpret_cast<const char*>(&extra), 2);
    }
    return header;
}

std::string error(std::string_view bytes) {
    return error_of("a.stl", bytes);
}

}  // namespace

TEST_CASE("STL without triangles comes back, as text and as binary", "[io][stl]") {
    CHECK(trouble_reading_again("a.stl", "solid\nendsolid\n") == "");
    CHECK(trouble_reading_again("a.stl", binary_stl("", 0, {}, 0), true) == "");
}

TEST_CASE("STL joins points of equal bits in order of first use, and no others", "[io][stl]") {
    const Result<Mesh> mesh = read_bytes("a.stl", kTwo);
    REQUIRE(mesh);
    CHECK(mesh->corners == std::vector<Index>{0, 1, 2, 2, 1, 3});
    CHECK(mesh->notes.at(0).text == "two words");
    CHECK(trouble_reading_again("a.stl", kTwo) == "");
    const Result<Mesh> zeros =
        read_bytes("a.stl", binary_stl("", 1, {0, 0, 0, 0, 0, 0, -0.0f, 0, 0, 0, 0, 0}, 0));
    REQUIRE(zeros);
    CHECK(zeros->corners == std::vector<Index>{0, 1, 0});
}

TEST_CASE("binary STL is known by its size even when it begins with solid", "[io][stl]") {
    const std::string bytes =
        binary_stl("solid not text", 1, {0, 0, 2, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 7);
    const Result<Mesh> mesh = read_bytes("a.stl", bytes);
    REQUIRE(mesh);
    CHECK(mesh->cell_count() == 1);
    CHECK(mesh->notes.at(0).text == "solid not text");
    CHECK(io::find_attribute(*mesh, Place::cell, "stl:attribute")->values.as<std::uint16_t>()[0] ==
          7);
    CHECK(trouble_coming_back(*mesh, "a.stl", true) == "");
    const TempFolder folder;
    REQUIRE(io::write_mesh(*mesh, folder / "b.stl", {.binary = true}));
    CHECK(folder.read("b.stl") == bytes);
}

TEST_CASE("STL with several solids keeps them apart, also those without triangles", "[io][stl]") {
    const char* facet =
        "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
        "endfacet\n";
    const std::string text = std::string("solid a\n") + facet + "endsolid a\nsolid b\nendsolid\n" +
                             "solid c\n" + facet + facet + "endsolid\nsolid d\nendsolid\n";
    const Result<Mesh> mesh = read_bytes("a.stl", text);
    REQUIRE(mesh);
    CHECK(mesh->tag_names.size() == 4);
    CHECK_FALSE(io::find_attribute(*mesh, Place::cell, "stl:normal"));
    CHECK(trouble_reading_again("a.stl", text) == "");
}

TEST_CASE("STL text has no zeros, and its names no line ends", "[io][stl]") {
    std::string text = "solid a\n" + std::string(2000, ' ') + "\nendsolid a\n";
    CHECK(read_bytes("a.stl", text));
    text.replace(1500, 1, 1, '\0');
    CHECK(!read_bytes("a.stl", text));
    Result<Mesh> mesh =
        read_bytes("a.stl",
                   "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                   "vertex 0 1 0\nendloop\nendfacet\nendsolid\n");
    REQUIRE(mesh);
    for (const std::string& name : {std::string("a\0b", 3), std::string("a\nfacet")}) {
        mesh->notes = {{"stl:name", name}};
        const TempFolder folder;
        std::vector<std::string> left_out;
        REQUIRE(io::write_mesh(*mesh, folder / "a.stl", {}, &left_out));
        CHECK(!left_out.empty());
        const Result<Mesh> again = io::read_mesh(folder / "a.stl");
        REQUIRE(again);
        CHECK(again->cell_count() == 1);
    }
}

TEST_CASE("STL text keeps float64 coordinates and binary STL refuses them", "[io][stl]") {
    std::string text = kTwo;
    text.replace(text.find("1 0 0"), 5, "0.123456789012345 0 0");
    const Result<Mesh> mesh = read_bytes("a.stl", text);
    REQUIRE(mesh);
    CHECK(mesh->positions.scalar == Scalar::f64);
    CHECK(trouble_coming_back(*mesh, "a.stl") == "");
    const TempFolder folder;
    CHECK(io::write_mesh(*mesh, folder / "b.stl", {.binary = true}).error().code ==
          Code::unwritable);
}

TEST_CASE("STL refuses quads and reports unused points", "[io][stl]") {
    const TempFolder folder;
    Mesh quad;
    quad.positions = make_array(Scalar::f32, 3, 5);
    quad.corner_begin = {0, 4};
    quad.corners = {0, 1, 2, 3};
    CHECK(io::write_mesh(quad, folder / "a.stl", {}).error().detail.find("cell 0 has 4 corners") !=
          std::string::npos);
    quad.corner_begin = {0, 3};
    quad.corners.pop_back();
    std::vector<std::string> left_out;
    CHECK(io::write_mesh(quad, folder / "a.stl", {}, &left_out).ok());
    CHECK(left_out.size() == 1);
}

TEST_CASE("wrong STL files get one line that says where and what", "[io][stl]") {
    CHECK(error("") == "a.stl: byte 0: the file ends inside the STL header, expected 84 bytes");
    CHECK(error(binary_stl("x", 2, std::vector<float>(12), 0)) ==
          "a.stl: byte 134: the file ends early: 2 triangles take 184 bytes, the file has 134");
    CHECK(error(binary_stl("x", 4294967295u, {}, 0)).find("ends early") != std::string::npos);
    CHECK(error(binary_stl("solid", 0, {}, 0) + "x").find("byte 84: the file goes on") !=
          std::string::npos);
    CHECK(error("solid\nfacet normal 0 0\nouter loop\n") ==
          "a.stl:3: expected a number of the facet's normal, found 'outer'");
    CHECK(error("solid\n") == "a.stl:2: expected facet or endsolid, but the file ends");
    CHECK(error("solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nendloop\n")
              .find("a.stl:5: expected vertex") == 0);
}
