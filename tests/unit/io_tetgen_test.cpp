#include <catch2/catch.hpp>

#include "io/attributes.h"
#include "support/temp_files.h"

using namespace ravel;
using namespace ravel::test;

namespace {

struct Files {
    std::string node, ele = {}, face = {}, edge = {};
};

constexpr const char* kFour = "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n# Generated\n";

Result<Mesh> read(const Files& files, std::string_view asked = "a.ele") {
    const TempFolder folder;
    if (!files.node.empty()) folder.write("a.node", files.node);
    if (!files.ele.empty()) folder.write("a.ele", files.ele);
    if (!files.face.empty()) folder.write("a.face", files.face);
    if (!files.edge.empty()) folder.write("a.edge", files.edge);
    Result<Mesh> mesh = io::read_mesh(folder / asked);
    if (!mesh) {
        std::string& detail = mesh.error().detail;
        detail.erase(0, (folder / "").size());
    }
    return mesh;
}

std::string trouble(const Files& files, std::string_view asked = "a.ele") {
    const Result<Mesh> mesh = read(files, asked);
    return mesh ? trouble_coming_back(*mesh, asked) : mesh.error().detail;
}

std::string error(const Files& files) {
    const Result<Mesh> mesh = read(files);
    return mesh ? "no error" : mesh.error().detail;
}

}  // namespace

TEST_CASE("TetGen nodes without tets are a tet mesh without cells", "[io][tetgen]") {
    CHECK(trouble({.node = "0 3\n"}, "a.node") == "");
    CHECK(trouble({.node = kFour}, "a.node") == "");
    CHECK(read({.node = kFour}, "a.node")->cell_count() == 0);
    CHECK(error({.node = kFour}).find("No such file") != std::string::npos);
}

TEST_CASE("TetGen tets come back, whichever of the files is named", "[io][tetgen]") {
    const Files files{.node = kFour, .ele = "2 4 0\n0 0 1 2 3\n1 3 3 3 3\n"};
    CHECK(read(files)->corners == std::vector<Index>{0, 1, 2, 3, 3, 3, 3, 3});
    CHECK(trouble(files) == "");
    CHECK(trouble(files, "a.node") == "");
}

TEST_CASE("TetGen numbers from one stay numbers from one", "[io][tetgen]") {
    const Files files{.node = "# c\n2 3 0 0\n1 0 0 0\n\n2 -0 nan 0.1\n", .ele = "1 4\n1 1 2 1 2\n"};
    const Result<Mesh> mesh = read(files);
    REQUIRE(mesh);
    CHECK(mesh->corners == std::vector<Index>{0, 1, 0, 1});
    CHECK(io::find_note(*mesh, "tetgen:first")->text == "1");
    CHECK(trouble(files) == "");
}

TEST_CASE("TetGen attributes, markers and regions come back", "[io][tetgen]") {
    const Files files{.node = "2 3 2 1\n0 0 0 0 1.5 2 -7\n1 1 0 0 0.1 3 8\n",
                      .ele = "2 4 1\n0 0 1 0 1 5\n1 1 1 1 1 -1\n"};
    const Result<Mesh> mesh = read(files);
    REQUIRE(mesh);
    CHECK(io::find_attribute(*mesh, Place::point, "tetgen:attribute")->values.arity == 2);
    CHECK(io::find_attribute(*mesh, Place::cell, "tetgen:region")->values.scalar == Scalar::i32);
    CHECK(trouble(files) == "");
    CHECK(trouble({.node = kFour, .ele = "1 4 2\n0 0 1 2 3 0.5 2\n"}) == "");
}

TEST_CASE("TetGen accepts promised markers that no row has", "[io][tetgen]") {
    const Files files{.node = "1 3 0 1\n0 0 0 0\n", .ele = "0 4 0\n"};
    CHECK(read(files)->attributes.empty());
    CHECK(trouble(files) == "");
}

TEST_CASE("TetGen faces and edges ride along, with markers on both, one or none", "[io][tetgen]") {
    const std::string ele = "1 4 0\n0 0 1 2 3\n";
    for (const char* face : {"", "1 1\n0 0 1 2 4\n", "1 0\n0 0 1 2\n", "0 1\n"})
        for (const char* edge : {"", "2 1\n0 0 1 4\n1 2 3 -1\n", "1 0\n0 3 1\n"})
            CHECK(trouble({.node = kFour, .ele = ele, .face = face, .edge = edge}) == "");
}

TEST_CASE("TetGen neighbours of faces are kept, and refer to tets", "[io][tetgen]") {
    const Files files{.node = kFour, .ele = "1 4 0\n0 0 1 2 3\n", .face = "1 1\n0 0 1 2 4 0 -1\n"};
    const Result<Mesh> mesh = read(files);
    REQUIRE(mesh);
    const Attribute* neighbours = io::find_attribute(*mesh, Place::mesh, "tetgen:neighbours:face");
    REQUIRE(neighbours);
    REQUIRE(neighbours->references.size() == 2);
    CHECK(same_reference(neighbours->references[1], {1, Place::cell, 0}));
    CHECK(trouble(files) == "");
}

TEST_CASE("TetGen edge nodes of quadratic tets are put in VTK's order and back", "[io][tetgen]") {
    std::string node = "10 3 0 0\n";
    for (int i = 0; i < 10; ++i) node += std::to_string(i) + " 0 0 " + std::to_string(i) + "\n";
    // After the corners 0 1 2 3, TetGen's order is the edges 23 03 01 12 13 02.
    const Files files{.node = node,
                      .ele = "1 10 0\n0 0 1 2 3 9 7 4 5 8 6\n",
                      .face = "1 1\n0 0 1 2 4 5 6 -1\n",
                      .edge = "1 0\n0 0 1 4\n"};
    const Result<Mesh> mesh = read(files);
    REQUIRE(mesh);
    REQUIRE(mesh->companions.size() == 3);
    CHECK(mesh->companions[0].nodes == std::vector<Index>{4, 5, 6, 7, 8, 9});
    CHECK(mesh->companions[1].vtk_type == 22);
    CHECK(mesh->companions[2].vtk_type == 21);
    CHECK(trouble(files) == "");
}

TEST_CASE("wrong TetGen files get one line that says where and what", "[io][tetgen]") {
    const std::string ele = "1 4 0\n0 0 1 2 3\n";
    CHECK(error({.node = "1 2 0 0\n0 0 0\n", .ele = ele}) ==
          "a.node:1: the nodes have dimension 2; only three dimensions are read");
    CHECK(error({.node = "9999999999 3 0 0\n0 0 0 0\n", .ele = ele})
              .find("more than the file can hold") != std::string::npos);
    CHECK(
        error({.node = "1 3 18446744073709551615 0\n0 0 0 0\n", .ele = ele}).find("more columns") !=
        std::string::npos);
    CHECK(error({.node = "1 3 0 0\n2 0 0 0\n", .ele = ele}).find("number 0 or 1, found 2") !=
          std::string::npos);
    CHECK(error({.node = "2 3 0 0\n0 0 0 0\n2 0 0 0\n", .ele = ele}).find("expected node 1") !=
          std::string::npos);
    CHECK(error({.node = "2 3 0 0\n0 0 0 0\n1 0 0\n", .ele = ele}) ==
          "a.node:3: expected a coordinate in row 2 of 2 nodes, but the line ends");
    CHECK(error({.node = kFour, .ele = "1 4 0\n0 0 1 2 4\n"}) ==
          "a.ele:2: expected a node's number from 0 to 3 in row 1 of 1 tetrahedra, found '4'");
    CHECK(error({.node = kFour, .ele = "1 4 0\n0 0 1 2 -1\n"}).find("a.ele:2: ") == 0);
    CHECK(error({.node = kFour, .ele = "1 8 0\n"}).find("4 or 10 nodes, found 8") !=
          std::string::npos);
    CHECK(error({.node = kFour, .ele = "1 4 0\n0 0 1 2 3 4\n"}).find("expected the end of row 1") !=
          std::string::npos);
    CHECK(error({.node = kFour, .ele = "1 4 0\n0 0 1 2 3\n1 0 1 2 3\n"})
              .find("a.ele:3: expected the end of the file") == 0);
    CHECK(error({.node = kFour, .ele = "2 4 0\n0 0 1 2 3\n"}).find("a.ele:") == 0);
    CHECK(error({.node = kFour, .ele = ele, .face = "1 1\n0 0 1 9 1\n"}).find("a.face:2: ") == 0);
}
