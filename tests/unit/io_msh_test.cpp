#include <catch2/catch.hpp>

#include "io/attributes.h"
#include "support/temp_files.h"

using namespace ravel;
using namespace ravel::test;

namespace {

constexpr const char* kHead2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
constexpr const char* kHead4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
constexpr const char* kFour2 = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 0.1\n$EndNodes\n";
constexpr const char* kFour4 =
    "$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 0.1\n$EndNodes\n";

std::string v2(std::string_view more) {
    return std::string(kHead2) + kFour2 + std::string(more);
}
std::string v4(std::string_view more) {
    return std::string(kHead4) + kFour4 + std::string(more);
}

// Text, and binary made of it, must both come back.
std::string trouble(const std::string& text) {
    const std::string as_text = trouble_reading_again("a.msh", text);
    return as_text.empty() ? trouble_reading_again("a.msh", text, true) : as_text;
}
std::string error(const std::string& text) {
    return error_of("a.msh", text);
}

}  // namespace

TEST_CASE("MSH without nodes or elements comes back", "[io][msh]") {
    CHECK(trouble(std::string(kHead2) + "$Nodes\n0\n$EndNodes\n") == "");
    CHECK(trouble(v2("")) == "");
    CHECK(trouble(v2("$Elements\n0\n$EndElements\n")) == "");
    CHECK(trouble(std::string(kHead4) + "$Nodes\n0 0 0 0\n$EndNodes\n") == "");
    CHECK(trouble(v4("$Elements\n0 0 0 0\n$EndElements\n")) == "");
}

TEST_CASE("MSH 2.2 degenerate and repeated tets come back with NaN, -0 and infinity", "[io][msh]") {
    const std::string text =
        std::string(kHead2) +
        "$Nodes\n3\n1 nan -0 1e300\n2 inf -inf 0.1\n3 0 0 0\n$EndNodes\n"
        "$Elements\n3\n1 4 2 0 1 1 1 1 1\n2 4 2 0 1 1 2 3 3\n3 4 2 0 1 1 2 3 3\n$EndElements\n";
    const Result<Mesh> mesh = read_bytes("a.msh", text);
    REQUIRE(mesh);
    CHECK(mesh->kind == CellKind::tet);
    CHECK(mesh->corners == std::vector<Index>{0, 0, 0, 0, 0, 1, 2, 2, 0, 1, 2, 2});
    CHECK(trouble(text) == "");
}

TEST_CASE("MSH 2.2 elements keep their tags, also where some have more than others", "[io][msh]") {
    const std::string text =
        v2("$Elements\n4\n1 15 0 1\n2 2 2 7 8 1 2 3\n3 4 4 5 6 1 -2 1 2 3 4\n4 4 2 9 6 1 2 4 3\n"
           "$EndElements\n");
    const Result<Mesh> mesh = read_bytes("a.msh", text);
    REQUIRE(mesh);
    const Attribute* physical = io::find_attribute(*mesh, Place::cell, "gmsh:physical");
    REQUIRE(physical);
    CHECK(physical->index.empty());
    CHECK(physical->values.as<std::int32_t>()[1] == 9);
    const Attribute* third = io::find_attribute(*mesh, Place::cell, "gmsh:tag3");
    REQUIRE(third);
    CHECK(third->index == std::vector<Index>{0, kNoIndex});
    CHECK(trouble(text) == "");
}

TEST_CASE("MSH node and element numbers that are not 1, 2, 3 are kept", "[io][msh]") {
    const std::string text =
        std::string(kHead2) +
        "$Nodes\n4\n10 0 0 0\n7 1 0 0\n900 0 1 0\n8 0 0 1\n$EndNodes\n"
        "$Elements\n2\n5 2 2 0 1 10 7 900\n3 4 2 0 1 10 7 900 8\n$EndElements\n";
    const Result<Mesh> mesh = read_bytes("a.msh", text);
    REQUIRE(mesh);
    CHECK(mesh->corners == std::vector<Index>{0, 1, 2, 3});
    CHECK(io::find_attribute(*mesh, Place::point, "gmsh:node")->values.count() == 4);
    CHECK(io::find_attribute(*mesh, Place::companion, "gmsh:element")->values.count() == 1);
    CHECK(trouble(text) == "");
}

TEST_CASE("MSH quadratic tets have their edge nodes in VTK's order", "[io][msh]") {
    std::string text = std::string(kHead2) + "$Nodes\n10\n";
    for (int i = 1; i <= 10; ++i) text += std::to_string(i) + " 0 0 " + std::to_string(i) + "\n";
    text +=
        "$EndNodes\n$Elements\n2\n1 4 2 0 1 1 2 3 4\n2 11 2 0 1 1 2 3 4 5 6 7 8 9 10\n"
        "$EndElements\n";
    const Result<Mesh> mesh = read_bytes("a.msh", text);
    REQUIRE(mesh);
    REQUIRE(mesh->companions.size() == 1);
    CHECK(mesh->companions[0].nodes == std::vector<Index>{4, 5, 6, 7, 9, 8});
    CHECK(mesh->companions[0].hosts == std::vector<Index>{1});
    CHECK(trouble(text) == "");
}

TEST_CASE("MSH 4.1 keeps entities, physical names and the entities of nodes", "[io][msh]") {
    const std::string text =
        std::string(kHead4) +
        "$PhysicalNames\n2\n2 5 \"left wall\"\n3 4 \"a \"quoted\" solid\"\n$EndPhysicalNames\n"
        "$Entities\n1 0 1 1\n1 0 0 0.1 0\n2 0 0 0 1 1 0 2 5 6 0\n3 0 0 0 1 1 1 1 4 1 -2\n"
        "$EndEntities\n"
        "$Nodes\n3 4 1 4\n0 1 0 1\n1\n0 0 0\n2 2 1 2\n2\n3\n1 0 0 0.5 0.25\n0 1 0 0.5 0\n"
        "3 3 0 1\n4\n0 0 1\n$EndNodes\n"
        "$Elements\n2 2 1 2\n2 2 2 1\n1 1 2 3\n3 3 4 1\n2 1 2 3 4\n$EndElements\n";
    const Result<Mesh> mesh = read_bytes("a.msh", text);
    REQUIRE(mesh);
    CHECK(mesh->tag_names.size() == 2);
    CHECK(mesh->tag_names[1].name == "a \"quoted\" solid");
    const Attribute* physical = io::find_attribute(*mesh, Place::cell, "gmsh:physical");
    REQUIRE(physical);
    CHECK(physical->values.as<std::int32_t>()[0] == 4);
    CHECK(io::find_attribute(*mesh, Place::point, "gmsh:parametric")->values.count() == 2);
    CHECK(io::find_attribute(*mesh, Place::point, "gmsh:entity_dim"));
    CHECK(trouble(text) == "");
}

TEST_CASE("MSH data on some nodes and elements only come back, in any order of rows", "[io][msh]") {
    const std::string cells =
        "$Elements\n3\n1 2 2 0 1 1 2 3\n2 4 2 0 1 1 2 3 4\n3 4 2 0 1 1 2 4 3\n$EndElements\n";
    const std::string data =
        "$NodeData\n1\n\"a name\"\n1\n0.5\n4\n3\n1\n2\n0\n4 0.25\n1 1e300\n$EndNodeData\n"
        "$ElementData\n2\n\"rank\"\n\"scheme\"\n1\n0.0\n3\n0\n3\n2\n3 1 2 3\n2 0.1 0 -0\n"
        "$EndElementData\n"
        "$ElementData\n1\n\"none\"\n1\n0.0\n3\n0\n1\n0\n$EndElementData\n";
    const std::string text = v2(cells + data);
    const Result<Mesh> mesh = read_bytes("a.msh", text);
    REQUIRE(mesh);
    CHECK(io::find_attribute(*mesh, Place::point, "a name")->index ==
          std::vector<Index>{0, kNoIndex, kNoIndex, 1});
    const Attribute* rank = io::find_attribute(*mesh, Place::cell, "rank");
    REQUIRE(rank);
    CHECK(rank->index.empty());
    CHECK(rank->values.as<float>()[3] == 1);
    CHECK(io::find_attribute(*mesh, Place::companion, "rank") == nullptr);
    CHECK(trouble(text) == "");
}

TEST_CASE("MSH keeps the types of arrays that its numbers do not tell", "[io][msh]") {
    Mesh mesh;
    mesh.kind = CellKind::tet;
    mesh.positions = io::array_of(std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 3);
    mesh.corners = {0, 1, 2, 3};
    io::add_attribute(mesh, "short", Place::point,
                      io::array_of(std::vector<std::int16_t>{-1, 2, 3, 4}, 1));
    io::add_attribute(mesh, "long", Place::cell, io::array_of(std::vector<std::int64_t>{-9}, 1));
    io::add_attribute(mesh, "float", Place::cell, io::array_of(std::vector<float>{0.1F}, 1));
    CHECK(trouble_coming_back(mesh, "a.msh") == "");
    CHECK(trouble_coming_back(mesh, "a.msh", true) == "");
}

TEST_CASE("MSH sections that are not known are kept as they are", "[io][msh]") {
    const std::string text =
        v4("$Surface\n2\n1 2 3\n 1 2 4\n$EndSurface\n"
           "$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n");
    const Result<Mesh> mesh = read_bytes("a.msh", text);
    REQUIRE(mesh);
    CHECK(io::find_note(*mesh, "gmsh:section:Surface")->text == "2\n1 2 3\n 1 2 4\n");
    CHECK(trouble(text) == "");
    const std::string periodic = v4("$Periodic\n1\n0 2 1\n0\n1\n1 2\n$EndPeriodic\n");
    CHECK(trouble_reading_again("a.msh", periodic) == "");
}

TEST_CASE("MSH notes that would not be sections again are left out", "[io][msh]") {
    const std::string tet = "$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n";
    CHECK(!read_bytes("a.msh", v4(tet + "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n")));
    Result<Mesh> mesh = read_bytes("a.msh", v4(tet));
    REQUIRE(mesh);
    mesh->notes = {{"gmsh:section:MeshFormat", "4.1 0 8\n"},
                   {"gmsh:section:two words", "text\n"},
                   {"gmsh:section:Cut", "text\n$EndCut\n"},
                   {"gmsh:section:Open", "no end of line"},
                   {"gmsh:section:", "text\n"},
                   {"gmsh:section:Kept", "text, not the $EndKept\n"}};
    const TempFolder folder;
    std::vector<std::string> left_out;
    REQUIRE(io::write_mesh(*mesh, folder / "b.msh", {}, &left_out));
    CHECK(!left_out.empty());
    const Result<Mesh> again = io::read_mesh(folder / "b.msh");
    REQUIRE(again);
    REQUIRE(again->notes.size() == 1);
    CHECK(again->notes[0].key == "gmsh:section:Kept");
}

TEST_CASE("MSH sections that name nodes or elements keep their numbers", "[io][msh]") {
    const std::string tet = "$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n";
    const Result<Mesh> periodic =
        read_bytes("a.msh", v4(tet + "$Periodic\n1\n0 2 1\n0\n1\n1 2\n$EndPeriodic\n"));
    REQUIRE(periodic);
    CHECK(io::find_attribute(*periodic, Place::point, "gmsh:node"));
    CHECK(!io::find_attribute(*periodic, Place::cell, "gmsh:element"));
    const std::string data =
        "$ElementNodeData\n1\n\"u\"\n1\n0\n3\n0\n1\n1\n1 4 10 20 30 40\n$EndElementNodeData\n";
    Result<Mesh> mesh = read_bytes("a.msh", v4(tet + data));
    REQUIRE(mesh);
    CHECK(!io::find_attribute(*mesh, Place::point, "gmsh:node"));
    CHECK(io::find_attribute(*mesh, Place::cell, "gmsh:element"));
    CHECK(trouble_reading_again("a.msh", v4(tet + data)) == "");
    // A turned cell is turned back.
    Attribute& corner = mesh->attributes.back();
    REQUIRE(corner.name == "gmsh:corner");
    for (std::size_t k = 0; k < 4; ++k) {
        mesh->corners[k] = 3 - k;
        corner.values.as<std::uint8_t>()[k] = static_cast<std::uint8_t>(3 - k);
    }
    const TempFolder folder;
    REQUIRE(io::write_mesh(*mesh, folder / "b.msh", {}));
    CHECK(io::read_mesh(folder / "b.msh")->corners == std::vector<Index>{0, 1, 2, 3});
}

TEST_CASE("MSH elements of one entity with two physical tags go to version 2.2", "[io][msh]") {
    Mesh mesh;
    mesh.kind = CellKind::tet;
    mesh.positions = make_array(Scalar::f32, 3, 4);
    mesh.corners = {0, 1, 2, 3, 3, 2, 1, 0};
    io::add_attribute(mesh, "gmsh:physical", Place::cell,
                      io::array_of(std::vector<std::int32_t>{4, 5}, 1));
    io::add_attribute(mesh, "gmsh:geometrical", Place::cell,
                      io::array_of(std::vector<std::int32_t>{1, 1}, 1));
    const TempFolder folder;
    REQUIRE(io::write_mesh(mesh, folder / "a.msh", {}));
    CHECK(folder.read("a.msh").starts_with("$MeshFormat\n2.2 0 8\n"));
    const Result<Mesh> again = io::read_mesh(folder / "a.msh");
    REQUIRE(again);
    CHECK(same_array(io::find_attribute(*again, Place::cell, "gmsh:physical")->values,
                     mesh.attributes[0].values));
}

TEST_CASE("MSH 2 is the same whatever digits its version has", "[io][msh]") {
    const std::string file = v2("$Elements\n1\n1 4 0 1 2 3 4\n$EndElements\n");
    for (const char* version : {"2", "2.0", "2.000000", "2.1", "2.20"}) {
        std::string other = file;
        other.replace(other.find("2.2"), 3, version);
        INFO(version);
        CHECK(trouble(other) == "");
    }
}

TEST_CASE("MSH that is wrong gets one line that says where", "[io][msh]") {
    CHECK(error("") == "a.msh:1: this is no MSH file: $MeshFormat is missing");
    CHECK(error("$NOD\n1\n") == "a.msh:1: MSH 1 files are not supported; 2.2 and 4.1 are");
    CHECK(error("$MeshFormat\n4.0 0 8\n") ==
          "a.msh:2: MSH version '4.0' is not supported; 2.2 and 4.1 are");
    CHECK(error(v2("$Elements\n1\n1 4 0 1 2 3 9\n$EndElements\n")) ==
          "a.msh:13: element 1 uses node 9, which is not there");
    CHECK(error(v2("$Elements\n1\n1 99 0 1\n$EndElements\n")) ==
          "a.msh:13: elements of Gmsh type 99 are not supported");
    CHECK(error(v2("$Elements\n99999999999\n")) ==
          "a.msh:12: 99999999999 elements are announced, more than the file can hold");
    CHECK(error(std::string(kHead2) + "$Nodes\n2\n1 0 0 0\n1 0 0 0\n$EndNodes\n") ==
          "a.msh:7: node 1 is there twice");
    CHECK(error(v4("$Elements\n1 5 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n")) ==
          "a.msh:19: the blocks have 1 elements, but 5 are announced");
    CHECK(error(v4("$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 x 4\n$EndElements\n")) ==
          "a.msh:19: expected a node of an element, found 'x'");
    CHECK(error(v4("$Periodic\n0\n")) == "a.msh:17: section $Periodic has no $EndPeriodic");
}
