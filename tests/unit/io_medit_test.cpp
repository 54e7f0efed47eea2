#include <catch2/catch.hpp>

#include "io/attributes.h"
#include "support/temp_files.h"

using namespace ravel;
using namespace ravel::test;

namespace {

constexpr const char* kHead = "MeshVersionFormatted 2\nDimension 3\n";
constexpr const char* kFour = "Vertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";

std::string file(std::string_view more) {
    return std::string(kHead) + kFour + std::string(more);
}
std::string trouble(const std::string& text) {
    return trouble_reading_again("a.mesh", text);
}
std::string error(const std::string& text) {
    return error_of("a.mesh", text);
}

}  // namespace

TEST_CASE("MEDIT without points or cells comes back", "[io][medit]") {
    CHECK(trouble(std::string(kHead) + "Vertices 0\nEnd\n") == "");
    CHECK(trouble(file("")) == "");
    CHECK(trouble(file("Tetrahedra 0\n")) == "");
}

TEST_CASE("MEDIT tets with references, and all other cells as companions, come back",
          "[io][medit]") {
    const std::string text =
        "MeshVersionFormatted 1\nDimension\n3\n# words\nvertices\n4\n0 0 0 -1\n1 0 0 0\n0 1 0 3\n"
        "nan -0 1e300 5000000000\nTriangles\n2\n1 2 3 7\n1 1 1 8\nEDGES 1 1 2 0\nTetrahedra 2\n"
        "1 2 3 4 10\n4 3 2 1 0\nQuadrilaterals 1\n1 2 3 4 1\nPrisms 1 1 2 3 4 1 2 0\n"
        "Pyramids 1\n1 2 3 4 1 9\nHexaedra 1\n1 2 3 4 1 2 3 4 2\nEnd\n";
    const Result<Mesh> mesh = read_bytes("a.mesh", text);
    REQUIRE(mesh);
    CHECK(mesh->kind == CellKind::tet);
    CHECK(mesh->cell_count() == 2);
    CHECK(mesh->companions.size() == 6);
    CHECK(io::find_attribute(*mesh, Place::point, "medit:ref")->values.scalar == Scalar::i64);
    CHECK(io::find_attribute(*mesh, Place::companion, "medit:ref")->values.count() == 7);
    CHECK(trouble(text) == "");
}

TEST_CASE("MEDIT triangles and quadrilaterals are cells where there are no tets", "[io][medit]") {
    const std::string text = file(
        "Quadrilaterals\n1\n1 2 3 4 5\nTriangles\n2\n1 2 3 0\n2 3 4 0\nEdges\n1\n1 2 6\nEnd\n");
    const Result<Mesh> mesh = read_bytes("a.mesh", text);
    REQUIRE(mesh);
    CHECK(mesh->kind == CellKind::polygon);
    CHECK(mesh->corner_begin == std::vector<Index>{0, 4, 7, 10});
    CHECK(mesh->companions.size() == 1);
    CHECK(trouble(text) == "");
}

TEST_CASE("a MEDIT mesh of two dimensions lies in the plane z = 0, and is written as it came",
          "[io][medit]") {
    const std::string text =
        "MeshVersionFormatted 1\nDimension 2\nVertices\n4\n0 0 1\n1 0 0\n1 -0 0\n0 1 2\n"
        "Quadrilaterals\n1\n1 2 3 4 5\nEdges\n1\n1 2 6\nEnd\n";
    Result<Mesh> mesh = read_bytes("a.mesh", text);
    REQUIRE(mesh);
    CHECK(mesh->point_count() == 4);
    CHECK(mesh->positions.as<float>()[3 * 3 + 1] == 1);
    CHECK(mesh->positions.as<float>()[3 * 3 + 2] == 0);
    CHECK(trouble(text) == "");
    CHECK(read_bytes("a.mesh", "Dimension 2\n" + file(""))->notes.empty());
    mesh->positions.as<float>()[2] = 1;
    CHECK(trouble_coming_back(*mesh, "a.mesh").find("\"medit:dimension\" has no place") !=
          std::string::npos);
}

TEST_CASE("MEDIT references of zero are no attribute", "[io][medit]") {
    CHECK(read_bytes("a.mesh", file("Tetrahedra 1\n1 2 3 4 0\n"))->attributes.empty());
}

TEST_CASE("MEDIT quadratic tets keep their edge nodes and hosts", "[io][medit]") {
    const std::string text = file(
        "Triangles 1 1 2 3 4\nTetrahedraP2\n1\n1 2 3 4 1 2 3 4 1 2 9\nTetrahedra 1\n4 3 2 1 8\n");
    const Result<Mesh> mesh = read_bytes("a.mesh", text);
    REQUIRE(mesh);
    CHECK(mesh->cell_count() == 2);
    REQUIRE(mesh->companions.size() == 2);
    CHECK(mesh->companions[0].vtk_type == 24);
    CHECK(mesh->companions[0].hosts == std::vector<Index>{1});
    CHECK(trouble(text) == "");
    CHECK(trouble(file("TetrahedraP2\n1\n1 2 3 4 1 2 3 4 1 2 9\n")) == "");
}

TEST_CASE("MEDIT sections about the mesh are kept as their numbers", "[io][medit]") {
    const std::string text = file(
        "Corners 2\n1\n3\nNormals\n1\n0 0.5 1\nNormalAtVertices 1\n2 1\nRidges 0\n"
        "AngleOfCornerBound 10.5\nTetrahedra 1\n1 2 3 4 1\nRequiredVertices\n3 1 2 3\nEnd\n");
    const Result<Mesh> mesh = read_bytes("a.mesh", text);
    REQUIRE(mesh);
    CHECK(io::find_attribute(*mesh, Place::mesh, "medit:Normals")->values.arity == 3);
    CHECK(io::find_attribute(*mesh, Place::mesh, "medit:Corners")->values.scalar == Scalar::i32);
    CHECK(trouble(text) == "");
}

TEST_CASE("MEDIT sections that name vertices refer to them", "[io][medit]") {
    const std::string text = file(
        "RequiredVertices 2\n1\n3\nNormals 1\n0 0 1\nNormalAtVertices 1\n2 1\n"
        "VertexOnGeometricEdge 2\n1 7 0.5\n2 8 1\nQuadrilateralsQ2 1\n1 2 3 4 1 2 3 4 1 5\n"
        "RequiredTriangles 1\n2\nTriangles 2\n1 2 3 0\n1 2 4 0\nTetrahedra 1\n1 2 3 4 1\n"
        "Corners 0\nRequiredTetrahedra 1\n1\nEnd\n");
    const Result<Mesh> mesh = read_bytes("a.mesh", text);
    REQUIRE(mesh);
    const auto references = [&](const char* name) {
        const Attribute* found = io::find_attribute(*mesh, Place::mesh, name);
        REQUIRE(found);
        return found->references;
    };
    for (const char* name :
         {"medit:RequiredVertices", "medit:NormalAtVertices", "medit:VertexOnGeometricEdge"}) {
        REQUIRE(references(name).size() == 1);
        CHECK(same_reference(references(name)[0], {0, Place::point, 1}));
    }
    CHECK(references("medit:QuadrilateralsQ2").size() == 9);
    CHECK(references("medit:RequiredTriangles").empty());  // companions, which stay
    CHECK(references("medit:Normals").empty());
    CHECK(same_reference(references("medit:RequiredTetrahedra").at(0), {0, Place::cell, 1}));
    CHECK(io::find_attribute(*mesh, Place::mesh, "medit:VertexOnGeometricEdge")->values.scalar ==
          Scalar::i32);
    CHECK(check_mesh(*mesh).ok());
    CHECK(trouble(text) == "");
}

TEST_CASE("MEDIT numbers of triangles among quadrilaterals refer to cells", "[io][medit]") {
    const std::string cells = "Quadrilaterals 1\n1 2 3 4 0\nTriangles 2\n1 2 3 0\n1 2 4 0\n";
    const std::string text =
        file(cells +
             "RequiredTriangles 1\n2\nRequiredQuadrilaterals 1\n1\nNormals 1\n0 0 1\n"
             "NormalAtTriangleVertices 2\n2 3 1\n1 1 1\n");
    const Result<Mesh> mesh = read_bytes("a.mesh", text);
    REQUIRE(mesh);
    const Attribute* triangles = io::find_attribute(*mesh, Place::mesh, "medit:RequiredTriangles");
    REQUIRE(triangles);
    CHECK(same_reference(triangles->references.at(0), {0, Place::cell, 0}));
    const Attribute* normals =
        io::find_attribute(*mesh, Place::corner, "medit:NormalAtTriangleVertices");
    REQUIRE(normals);
    CHECK(normals->index[9] == 0);
    CHECK(normals->index[4] == 1);
    CHECK(trouble(text) == "");
    CHECK(error(file(cells + "RequiredTriangles 1\n3\n")) ==
          "a.mesh:14: section RequiredTriangles names number 3 of 2 Triangles");
    CHECK(error(file(cells + "NormalAtTriangleVertices 1\n1 4 1\n")).find("names corner 4") !=
          std::string::npos);
}

TEST_CASE("MEDIT refuses cells it cannot hold and reports an order it cannot keep", "[io][medit]") {
    const TempFolder folder;
    Mesh mesh;
    mesh.positions = make_array(Scalar::f32, 3, 5);
    mesh.corner_begin = {0, 3, 7, 10};
    mesh.corners = {0, 1, 2, 0, 1, 2, 3, 1, 2, 3};
    std::vector<std::string> left_out;
    CHECK(io::write_mesh(mesh, folder / "a.mesh", {}, &left_out).ok());
    CHECK(left_out.size() == 1);
    mesh.corner_begin = {0, 5, 10};
    CHECK(io::write_mesh(mesh, folder / "a.mesh", {}).error().code == Code::unwritable);
}

TEST_CASE("wrong MEDIT files get one line that says where and what", "[io][medit]") {
    CHECK(error("").find("without a section Vertices") != std::string::npos);
    CHECK(error("MeshVersionFormatted 2\nDimension 1\n").find("a.mesh:2: expected the dim") == 0);
    CHECK(error("Vertices 1\n0 0 0 0\nDimension 2\n").find("comes after the vertices") !=
          std::string::npos);
    CHECK(error("12 13\n") == "a.mesh:1: expected a keyword of a MEDIT mesh, found '12'");
    CHECK(error(file("Tetrahedra 1\n1 2 3 5 0\n")) ==
          "a.mesh:10: names vertex 5, but the file has 4");
    CHECK(error(file("Tetrahedra 1\n1 2 3 0 0\n")).find("a.mesh:10: expected a vertex number") ==
          0);
    CHECK(error(file("Tetrahedra 2\n1 2 3 4 0\n")).find("more than the file can hold") !=
          std::string::npos);
    CHECK(error(file("Triangles 2\n1 2 3 0\nTetrahedra 0\nEnd\n"))
              .find("a.mesh:11: expected a vertex") == 0);
    CHECK(error(file("Tetrahedra 99999999999999\n")).find("more than the file can hold") !=
          std::string::npos);
    CHECK(error(file("Corners 2\n1\n2\n3\n")).find("promises 2 rows, and has 3 numbers") !=
          std::string::npos);
    CHECK(error(file("hello\n")).find("expected a known keyword") != std::string::npos);
    CHECK(error(std::string(kHead) + "Vertices 1\n0 0 0\n").find("expected the reference") !=
          std::string::npos);
}
