#include <catch2/catch.hpp>

#include "io/attributes.h"
#include "support/temp_files.h"

using namespace ravel;
using namespace ravel::test;

namespace {

std::string head(std::string_view elements, std::string_view format = "ascii") {
    return "ply\nformat " + std::string(format) + " 1.0\n" + std::string(elements) + "end_header\n";
}

constexpr const char* kXyz = "property float x\nproperty float y\nproperty float z\n";
constexpr const char* kCorners = "property list uchar int vertex_indices\n";

std::string vertices(int count, std::string_view more = "") {
    return "element vertex " + std::to_string(count) + "\n" + kXyz + std::string(more);
}
std::string faces(int count, std::string_view more = "") {
    return "element face " + std::to_string(count) + "\n" + kCorners + std::string(more);
}

std::string trouble(const std::string& text) {
    const std::string as_text = trouble_reading_again("a.ply", text);
    return as_text.empty() ? trouble_reading_again("a.ply", text, true) : as_text;
}
std::string error(const std::string& text) {
    return error_of("a.ply", text);
}

}  // namespace

TEST_CASE("PLY without points or faces comes back", "[io][ply]") {
    CHECK(trouble(head(vertices(0))) == "");
    CHECK(trouble(head(vertices(1) + faces(0)) + "1 2 3\n") == "");
}

TEST_CASE("PLY keeps faces of any degree, repeated corners and values that are no numbers",
          "[io][ply]") {
    const std::string text = head(vertices(3) + faces(6)) +
                             "-0 nan inf\n1 0 -inf\n1e-42 3e38 0.1\n0\n1 2\n2 0 1\n3 0 0 0\n"
                             "3 0 1 2\n3 0 1 2\n";
    CHECK(read_bytes("a.ply", text)->cell_count() == 6);
    CHECK(trouble(text) == "");
}

TEST_CASE("PLY keeps the declared types of positions and of all other properties", "[io][ply]") {
    const std::string text =
        head(
            "comment made by hand\nobj_info scanned\nelement vertex 1\nproperty double x\n"
            "property double y\nproperty double z\nproperty uchar red\nproperty char a\n"
            "property short b\nproperty ushort c\nproperty uint d\nproperty double e\n" +
            faces(1, "property float quality\nproperty int flags\n")) +
        "1 2 3 255 -128 -32768 65535 4294967295 0.1\n1 0 0.25 -7\n";
    const Result<Mesh> mesh = read_bytes("a.ply", text);
    REQUIRE(mesh);
    CHECK(mesh->positions.scalar == Scalar::f64);
    CHECK(io::find_attribute(*mesh, Place::point, "red")->values.scalar == Scalar::u8);
    CHECK(io::find_attribute(*mesh, Place::point, "d")->values.scalar == Scalar::u32);
    CHECK(io::find_attribute(*mesh, Place::cell, "flags")->values.scalar == Scalar::i32);
    CHECK(mesh->notes.size() == 2);
    CHECK(trouble(text) == "");
}

TEST_CASE("binary PLY of either byte order is the same mesh as its text", "[io][ply]") {
    const std::string text = head(vertices(3, "property ushort q\n") + faces(1)) +
                             "0 1 2 258\n3 4 5 1\n6 7 8 2\n3 0 1 2\n";
    const Result<Mesh> mesh = read_bytes("a.ply", text);
    REQUIRE(mesh);
    std::string big = head(vertices(3, "property ushort q\n") + faces(1), "binary_big_endian");
    const auto number = [&](auto value) {
        const char* raw = reinterpret_cast<const char*>(&value);
        for (std::size_t i = sizeof value; i > 0; --i) big += raw[i - 1];
    };
    const std::uint16_t q[3] = {258, 1, 2};
    for (int p = 0; p < 3; ++p) {
        for (int k = 0; k < 3; ++k) number(static_cast<float>(3 * p + k));
        number(q[p]);
    }
    big += '\3';
    for (const std::int32_t i : {0, 1, 2}) number(i);
    const Result<Mesh> other = read_bytes("a.ply", big);
    REQUIRE(other);
    CHECK(difference(*mesh, *other) == "");
}

TEST_CASE("PLY texture coordinates of corners come back, where all or some faces have them",
          "[io][ply]") {
    const std::string header =
        head(vertices(3) + faces(2, "property list uchar float texcoord\n")) +
        "0 0 0\n1 0 0\n0 1 0\n";
    const std::string some = header + "3 0 1 2 6 0 0 1 0 0 1\n3 0 1 2 0\n";
    const Result<Mesh> mesh = read_bytes("a.ply", some);
    REQUIRE(mesh);
    const Attribute* texture = io::find_attribute(*mesh, Place::corner, "ply:texcoord");
    REQUIRE(texture);
    CHECK(texture->values.arity == 2);
    CHECK(texture->index.size() == 6);
    CHECK(trouble(some) == "");
    CHECK(trouble(header + "3 0 1 2 6 0 0 1 0 0 1\n2 0 1 4 9 9 9 9\n") == "");
}

TEST_CASE("PLY edges ride along, and unknown elements and lists are kept", "[io][ply]") {
    const std::string text =
        head(vertices(2, "property list uchar int near\n") +
             faces(2, "property list uchar int odd\n") +
             "element edge 2\nproperty int vertex1\nproperty int vertex2\nproperty uchar kind\n"
             "element material 1\nproperty float shine\nproperty list uchar uchar name\n") +
        "0 0 0 2 5 6\n1 0 0 0\n2 0 1 3 1 2 3\n1 0 0\n0 1 9\n1 0 8\n0.5 2 65 66\n";
    const Result<Mesh> mesh = read_bytes("a.ply", text);
    REQUIRE(mesh);
    REQUIRE(mesh->companions.size() == 1);
    CHECK(mesh->companions[0].nodes == std::vector<Index>{0, 1, 1, 0});
    CHECK(io::find_attribute(*mesh, Place::mesh, "ply:material:shine"));
    CHECK(trouble(text) == "");
}

TEST_CASE("a face of more than 255 corners comes back from PLY", "[io][ply]") {
    Mesh mesh;
    mesh.positions = make_array(Scalar::f32, 3, 1);
    mesh.corner_begin = {0, 300};
    mesh.corners.assign(300, 0);
    CHECK(trouble_coming_back(mesh, "a.ply") == "");
    CHECK(trouble_coming_back(mesh, "a.ply", true) == "");
}

TEST_CASE("wrong PLY files get one line that says where and what", "[io][ply]") {
    CHECK(error("") == "a.ply:1: expected the word ply, but the file ends");
    CHECK(error("ply\nformat ascii 1.0\n").find("expected end_header") != std::string::npos);
    CHECK(error("ply\nformat middle_endian 1.0\n").find("a.ply:2: ") == 0);
    CHECK(error("ply\nend_header\n").find("no format line") != std::string::npos);
    CHECK(error(head("element vertex x\n")).find("a.ply:3: expected the element's count") == 0);
    CHECK(error(head("property float x\n")).find("a.ply:3: a property before") == 0);
    CHECK(error(head("element vertex 0\nproperty quad x\n")).find("a.ply:4: expected a type") == 0);
    CHECK(error(head("element face 0\n" + std::string(kCorners))).find("no element vertex") !=
          std::string::npos);
    CHECK(error(head("element vertex 0\nproperty float x\n")).find("no property y") !=
          std::string::npos);
    CHECK(error(head(vertices(0) + "element tristrips 0\nproperty list int int vertex_indices\n"))
              .find("strips") != std::string::npos);
    CHECK(error(head(vertices(1) + faces(1)) + "0 0 0\n3 0 0 1\n") ==
          "a.ply:11: face 0 names vertex 1, but the file has 1");
    CHECK(error(head(vertices(1) + faces(1)) + "0 0 0\n3 0 0 -1\n").find("names vertex -1") !=
          std::string::npos);
    CHECK(error(head(vertices(1)) + "0 0 0 0\n").find("a.ply:8: expected the end of the line") ==
          0);
    CHECK(error(head(vertices(2)) + "0 0 0\n0.5 0.5\n").find("but the file ends") !=
          std::string::npos);
    CHECK(error(head(vertices(1, "property uchar red\n")) + "0 0 0 256\n")
              .find("expected a number of type uint8, found '256'") != std::string::npos);
    CHECK(error(head("element vertex 18446744073709551615\n" + std::string(kXyz)) + "0 0 0\n")
              .find("more than the file can hold") != std::string::npos);
    CHECK(error(head(vertices(1), "binary_little_endian") + "0123456789")
              .find("more than the file can hold") != std::string::npos);
    CHECK(error(head(vertices(0) + faces(1), "binary_little_endian") + "\xff" + "1234")
              .find("the file ends inside element face") != std::string::npos);
    CHECK(error(head(vertices(0), "binary_little_endian") + "x").find("goes on") !=
          std::string::npos);
}

TEST_CASE("PLY takes attributes of other formats as columns", "[io][ply]") {
    Mesh mesh;
    mesh.positions = make_array(Scalar::f32, 3, 2);
    mesh.corner_begin = {0};
    io::add_attribute(mesh, "obj:color", Place::point, make_array(Scalar::f32, 3, 2));
    const TempFolder folder;
    std::vector<std::string> left_out;
    REQUIRE(io::write_mesh(mesh, folder / "a.ply", {}, &left_out));
    CHECK(left_out.empty());
    CHECK(folder.read("a.ply").find("property float obj:color.2\n") != std::string::npos);
}
