#include <catch2/catch.hpp>

#include "io/attributes.h"
#include "support/temp_files.h"

using namespace ravel;
using namespace ravel::test;

namespace {
std::string trouble(std::string_view text) {
    return trouble_reading_again("a.obj", text);
}
std::string error(std::string_view text) {
    return error_of("a.obj", text);
}
}  // namespace

TEST_CASE("an empty OBJ is an empty mesh and comes back", "[io][obj]") {
    for (const char* text : {"", "# nothing\n", "\n\n"}) {
        const Result<Mesh> mesh = read_bytes("a.obj", text);
        REQUIRE(mesh);
        CHECK(mesh->point_count() == 0);
        CHECK(mesh->cell_count() == 0);
        CHECK(trouble(text) == "");
    }
}

TEST_CASE("OBJ keeps points without faces, of which some are equal or not finite", "[io][obj]") {
    const char* text = "v 0 0 0\nv -0 0 0\nv nan inf -inf\nv 0 0 0\n";
    CHECK(read_bytes("a.obj", text)->point_count() == 4);
    CHECK(trouble(text) == "");
}

TEST_CASE("OBJ keeps faces of any degree, repeated corners and duplicates", "[io][obj]") {
    const char* text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf\nf 1\nf 1 2\nf 1 1 1\nf 1 2 3\nf 1 2 3\nf 3 2 1 2 3\n";
    const Result<Mesh> mesh = read_bytes("a.obj", text);
    REQUIRE(mesh);
    CHECK(mesh->cell_count() == 7);
    CHECK(mesh->corner_begin == std::vector<Index>{0, 0, 1, 3, 6, 9, 12, 17});
    CHECK(trouble(text) == "");
}

TEST_CASE("OBJ texture coordinates and normals stay pools with missing references", "[io][obj]") {
    const char* text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0.5 0.5\nvn 0 0 1\n"
        "f 1 2 3\nf 1/1 2/2 3/1\nf 1//1 2//-1 3\nf 1/2/1 2/1/1 3/2/1\n";
    const Result<Mesh> mesh = read_bytes("a.obj", text);
    REQUIRE(mesh);
    const Attribute* texture = io::find_attribute(*mesh, Place::corner, "obj:vt");
    REQUIRE(texture);
    CHECK(texture->values.count() == 3);
    CHECK(texture->values.arity == 2);
    CHECK(texture->index == std::vector<Index>{kNoIndex, kNoIndex, kNoIndex, 0, 1, 0, kNoIndex,
                                               kNoIndex, kNoIndex, 1, 0, 1});
    CHECK(io::find_attribute(*mesh, Place::corner, "obj:vn")->index[7] == 0);
    CHECK(trouble(text) == "");
}

TEST_CASE("OBJ pools that no face refers to are kept, with and without faces", "[io][obj]") {
    CHECK(trouble("v 0 0 0\nvt 1 2 3\nvn 0 0 1\n") == "");
    CHECK(trouble("v 0 0 0\nvt 1 2 3\nvt 4 5\nvn 0 0 1\nf 1 1 1\n") == "");
}

TEST_CASE("OBJ negative indices count back from the point last read", "[io][obj]") {
    const Result<Mesh> mesh =
        read_bytes("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 -2 -4\n");
    REQUIRE(mesh);
    CHECK(mesh->corners == std::vector<Index>{0, 1, 2, 3, 2, 0});
}

TEST_CASE("OBJ faces may name points that come later", "[io][obj]") {
    CHECK(read_bytes("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").ok());
}

TEST_CASE("OBJ weights and colours are kept where only some points have them", "[io][obj]") {
    CHECK(trouble("v 0 0 0 1\nv 1 0 0\nv 2 0 0 0.5\n") == "");
    CHECK(trouble("v 0 0 0\nv 1 0 0 0.1 0.2 0.3\nv 2 0 0 1 1 1 0.5\n") == "");
    CHECK(trouble("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\n") == "");
}

TEST_CASE("OBJ groups, materials, objects and smoothing come back with their names", "[io][obj]") {
    const char* text =
        "mtllib a b.mtl\nmtllib c.mtl\nv 0 0 0\nf 1 1 1\no Thing one\ng a b\nusemtl red\ns 1\n"
        "f 1 1 1\ng unused\ng c\ns off\nf 1 1 1\nusemtl blue#2\nf 1 1 1\ng a b\nusemtl red\ng\n"
        "f 1 1 1\ng late\n";
    const Result<Mesh> mesh = read_bytes("a.obj", text);
    REQUIRE(mesh);
    const auto values = [&](const char* name) {
        const auto span = io::find_attribute(*mesh, Place::cell, name)->values.as<std::int32_t>();
        return std::vector<std::int32_t>(span.begin(), span.end());
    };
    CHECK(values("obj:group") == std::vector<std::int32_t>{-1, 0, 2, 2, -1});
    CHECK(values("obj:material") == std::vector<std::int32_t>{-1, 0, 0, 1, 0});
    CHECK(values("obj:smoothing") == std::vector<std::int32_t>{-1, 1, 0, 0, 0});
    CHECK(io::find_tag_name(*mesh, "obj:material", 1)->name == "blue#2");
    CHECK(io::find_tag_name(*mesh, "obj:group", 3)->name == "late");
    CHECK(mesh->notes.size() == 2);
    CHECK(trouble(text) == "");
}

TEST_CASE("OBJ states that no cell has are kept", "[io][obj]") {
    CHECK(trouble("v 0 0 0\nusemtl a\ng\ns off\no b\n") == "");
    CHECK(trouble("v 0 0 0\nf 1 1 1\ns\ng\n") == "");
}

TEST_CASE("OBJ lines and points ride along in blocks", "[io][obj]") {
    const char* text = "v 0 0 0\nv 1 0 0\nv 2 0 0\nl 1 2\nl 2 3\nl 1 2 3\np 1 2\np 3\nl 3\n";
    const Result<Mesh> mesh = read_bytes("a.obj", text);
    REQUIRE(mesh);
    REQUIRE(mesh->companions.size() == 4);
    CHECK(mesh->companions[0].vtk_type == 3);
    CHECK(mesh->companions[1].vtk_type == 4);
    CHECK(mesh->companions[2].cell_count == 3);
    CHECK(trouble(text) == "");
}

TEST_CASE("OBJ lines may be joined by backslashes and end in carriage returns", "[io][obj]") {
    const Result<Mesh> mesh =
        read_bytes("a.obj", "v 0 0 0\r\nv 1 \\\r\n0 0\r\nf 1 2 \\\r\n1\r\ncurv2 1\\\r\n2\r\n");
    REQUIRE(mesh);
    CHECK(mesh->corners == std::vector<Index>{0, 1, 0});
}

TEST_CASE("an OBJ with numbers beyond float32 is float64 and comes back", "[io][obj]") {
    const char* text = "v 0.123456789012345 1 1e300\nv 16777217 0 0\n";
    CHECK(read_bytes("a.obj", text)->positions.scalar == Scalar::f64);
    CHECK(trouble(text) == "");
}

TEST_CASE("wrong OBJ files get one line that says where and what", "[io][obj]") {
    CHECK(error("v 0 0\n") == "a.obj:1: expected 3, 4, 6 or 7 numbers after v, found 2");
    CHECK(error("v 0 0 x\n") == "a.obj:1: expected a number after v, found 'x'");
    CHECK(error("v 0 0 0\nf 1 0 1\n").find("a.obj:2: expected a corner") == 0);
    CHECK(error("v 0 0 0\nf 1 -2 1\n").find("a.obj:2: expected a corner") == 0);
    CHECK(error("v 0 0 0\nf 1 1/1/1/1 1\n").find("a.obj:2: expected a corner") == 0);
    CHECK(error("v 0 0 0\n\nf 1 9 1\nv 0 0 0\n") == "a.obj:3: refers to v 9, but the file has 2");
    CHECK(error("v 0 0 0\nf 1/1 1/1 1/2\nvt 0\n") == "a.obj:2: refers to vt 2, but the file has 1");
    CHECK(error("v 0 0 0\nf 1 99999999999999999999 1\n").find("a.obj:2: ") == 0);
    CHECK(error("v 0 0 0\ns x\n").find("a.obj:2: expected a smoothing") == 0);
    CHECK(error("hello\nworld\n") ==
          "a.obj:1: expected an OBJ statement such as v or f; the file has none");
}

TEST_CASE("OBJ refuses tets and reports what has no place", "[io][obj]") {
    const TempFolder folder;
    Mesh tets;
    tets.kind = CellKind::tet;
    tets.positions = make_array(Scalar::f32, 3, 4);
    tets.corners = {0, 1, 2, 3};
    CHECK(io::write_mesh(tets, folder / "a.obj", {}).error().code == Code::unwritable);
    Mesh mesh;
    mesh.corner_begin = {0};
    mesh.notes.push_back({"other", "words"});
    io::add_attribute(mesh, "medit:ref", Place::point, make_array(Scalar::i32, 1, 0));
    std::vector<std::string> left_out;
    CHECK(io::write_mesh(mesh, folder / "a.obj", {}, &left_out).ok());
    CHECK(left_out.size() == 2);
}

TEST_CASE("an OBJ with a byte order mark keeps its first vertex") {
    const auto mesh = read_bytes("bom.obj", "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    REQUIRE(mesh.ok());
    CHECK(mesh->point_count() == 3);
}
