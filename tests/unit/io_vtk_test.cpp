#include <catch2/catch.hpp>

#include "io/attributes.h"
#include "support/temp_files.h"

using namespace ravel;
using namespace ravel::test;

namespace {

std::string head(std::string_view version = "3.0", std::string_view dataset = "UNSTRUCTURED_GRID") {
    return "# vtk DataFile Version " + std::string(version) + "\na title\nASCII\nDATASET " +
           std::string(dataset) + "\n";
}
constexpr const char* kFour = "POINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\n";
std::string grid(std::string_view more) {
    return head() + kFour + std::string(more);
}

std::string trouble(const std::string& text) {
    const std::string as_text = trouble_reading_again("a.vtk", text);
    return as_text.empty() ? trouble_reading_again("a.vtk", text, true) : as_text;
}
std::string error(const std::string& text) {
    return error_of("a.vtk", text);
}

}  // namespace

TEST_CASE("VTK without points or cells comes back", "[io][vtk]") {
    CHECK(trouble(head()) == "");
    CHECK(trouble(head() + "POINTS 0 float\nCELLS 0 0\nCELL_TYPES 0\n") == "");
    CHECK(trouble(grid("")) == "");
    CHECK(trouble(head("5.1") + "POINTS 0 float\nCELLS 0 0\nOFFSETS vtktypeint64\n"
                                "CONNECTIVITY vtktypeint64\nCELL_TYPES 0\n") == "");
    CHECK(trouble(head("3.0", "POLYDATA") + "POINTS 0 float\n") == "");
}

TEST_CASE("VTK degenerate, repeated and mixed cells come back", "[io][vtk]") {
    const std::string text = grid(
        "CELLS 7 30\n4 0 0 0 0\n3 0 1 2\n4 0 1 2 3\n4 0 1 2 3\n1 3\n6 0 1 2 3 0 1\n1 2\n"
        "CELL_TYPES 7\n10 5 10 10 1 13 2\n"
        "CELL_DATA 7\nSCALARS rank int\nLOOKUP_TABLE default\n1 2 3 4 5 6 7\n");
    const Result<Mesh> mesh = read_bytes("a.vtk", text);
    if (!mesh) FAIL(mesh.error().detail);
    CHECK(mesh->kind == CellKind::tet);
    CHECK(mesh->cell_count() == 3);
    CHECK(mesh->companions.size() == 4);
    CHECK(io::find_attribute(*mesh, Place::companion, "rank")->values.as<std::int32_t>()[3] == 7);
    CHECK(trouble(text) == "");
}

TEST_CASE("VTK pixels become quads, and polygons are cells where there are no tets", "[io][vtk]") {
    const std::string text = grid(
        "CELLS 4 18\n4 0 1 2 3\n3 0 1 2\n5 0 1 2 3 0\n2 0 1\n"
        "CELL_TYPES 4\n8 5 7 3\n");
    const Result<Mesh> mesh = read_bytes("a.vtk", text);
    if (!mesh) FAIL(mesh.error().detail);
    CHECK(mesh->kind == CellKind::polygon);
    CHECK(mesh->corners == std::vector<Index>{0, 1, 3, 2, 0, 1, 2, 0, 1, 2, 3, 0});
    CHECK(trouble(text) == "");
}

TEST_CASE("VTK polygonal data come back as such, their data in VTK's order", "[io][vtk]") {
    const std::string text =
        head("3.0", "POLYDATA") + kFour +
        "POLYGONS 2 7\n3 0 1 2\n2 3 0\nLINES 2 7\n2 0 1\n3 1 2 3\nVERTICES 1 2\n1 3\n"
        "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n"
        "CELL_DATA 6\nSCALARS n unsigned_char\n10 20 21 30 31 40\n";
    const Result<Mesh> mesh = read_bytes("a.vtk", text);
    if (!mesh) FAIL(mesh.error().detail);
    CHECK(mesh->cell_count() == 2);
    CHECK(mesh->companions.size() == 4);
    CHECK(io::find_attribute(*mesh, Place::cell, "n")->values.as<std::uint8_t>()[0] == 30);
    CHECK(trouble(text) == "");
    const TempFolder folder;
    REQUIRE(io::write_mesh(*mesh, folder / "a.vtk", {}));
    CHECK(folder.read("a.vtk").find("DATASET POLYDATA") != std::string::npos);
}

TEST_CASE("VTK arrays keep their exact types, and names their blanks", "[io][vtk]") {
    std::string text = grid("METADATA\nINFORMATION 0\n\nPOINT_DATA 4\nFIELD FieldData 10\n");
    const std::pair<const char*, Scalar> types[] = {
        {"unsigned_char", Scalar::u8}, {"char", Scalar::i8},
        {"short", Scalar::i16},        {"unsigned_short", Scalar::u16},
        {"int", Scalar::i32},          {"unsigned_int", Scalar::u32},
        {"long", Scalar::i64},         {"vtktypeuint64", Scalar::u64},
        {"float", Scalar::f32},        {"double", Scalar::f64}};
    for (const auto& [name, scalar] : types) {
        text += std::string("a%20") + name + " 1 4 " + name + "\n1 2 3 4\n";
    }
    text += "VECTORS v double\n0 0 0 1 nan inf -inf -0 0 0 0 0\nTENSORS t float\n";
    for (int i = 0; i < 36; ++i) text += "0.1 ";
    text +=
        "\nTEXTURE_COORDINATES uv 2 float\n0 0 1 1 2 2 3 3\nCOLOR_SCALARS c 2\n"
        "0 1 0 1 0 1 0 1\nLOOKUP_TABLE table 1\n0 0 0 1\n";
    const Result<Mesh> mesh = read_bytes("a.vtk", text);
    if (!mesh) FAIL(mesh.error().detail);
    for (const auto& [name, scalar] : types) {
        const Attribute* a = io::find_attribute(*mesh, Place::point, std::string("a ") + name);
        REQUIRE(a);
        CHECK(a->values.scalar == scalar);
    }
    CHECK(trouble(text) == "");
}

TEST_CASE("VTK floats in text are float32 if the decimals were printed from them", "[io][vtk]") {
    const auto scalar_of = [](const std::string& number) {
        return read_bytes("a.vtk", head() + "POINTS 1 float\n" + number + " 0 0\n")
            ->positions.scalar;
    };
    CHECK(scalar_of("0.1") == Scalar::f32);
    CHECK(scalar_of("1.00000001490e-01") == Scalar::f32);
    CHECK(scalar_of("0.10000000012") == Scalar::f64);
}

TEST_CASE("VTK attributes on one side only come back there only", "[io][vtk]") {
    Mesh mesh;
    mesh.kind = CellKind::tet;
    mesh.positions = make_array(Scalar::f32, 3, 4);
    mesh.corners = {0, 1, 2, 3, 3, 2, 1, 0};
    mesh.companions.push_back({5, 3, 1, {0, 1, 2}, {}});
    io::add_attribute(mesh, "some", Place::point, make_array(Scalar::i16, 1, 1),
                      {kNoIndex, 0, kNoIndex, kNoIndex});
    io::add_attribute(mesh, "on cells", Place::cell, make_array(Scalar::f32, 2, 2));
    mesh.tag_names.push_back({"gmsh:physical", 2, -7, "wall"});
    mesh.notes.push_back({"words", "two\nlines"});
    for (const bool binary : {false, true}) {
        CHECK(trouble_coming_back(mesh, "a.vtk", binary) == "");
        CHECK(trouble_coming_back(mesh, "a.vtu", binary) == "");
    }
}

TEST_CASE("VTK that is wrong gets one line that says where", "[io][vtk]") {
    CHECK(error("") == "a.vtk:1: this is no legacy VTK file");
    CHECK(error("# vtk DataFile Version 9.0\n") ==
          "a.vtk:1: VTK file version '9.0' is not supported; 2.0 to 5.1 are");
    CHECK(error(head("3.0", "STRUCTURED_GRID")) ==
          "a.vtk:4: DATASET STRUCTURED_GRID is not supported; UNSTRUCTURED_GRID and POLYDATA are");
    CHECK(error(grid("CELLS 1 5\n4 0 1 2 4\nCELL_TYPES 1\n10\n")) ==
          "a.vtk:8: a cell uses point 4, but there are only 4");
    CHECK(error(grid("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n42\n")) ==
          "a.vtk:10: polyhedra (VTK cell type 42) are not supported");
    CHECK(error(grid("CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n10\n")) ==
          "a.vtk:10: a cell of VTK type 10 has 4 nodes, not 3");
    CHECK(error(grid("CELLS 1 99999999999\n")) ==
          "a.vtk:7: 99999999999 values of the cells are announced, more than the file can hold");
    CHECK(error(grid("POINT_DATA 4\nSCALARS a bit\nLOOKUP_TABLE default\n0 1 0 1\n")) ==
          "a.vtk:9: the values of 'a' are of type 'bit', which is not supported");
    CHECK(error(grid("POINT_DATA 3\n")) == "a.vtk:7: POINT_DATA is for 3 of them, but there are 4");
}
