// Files whose numbers name points or cells, through the codec, which changes the order of these:
// the numbers still name what they named, told by coordinates.
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

#include "io/attributes.h"
#include "make/make_mesh.h"
#include "ravel/ravel.h"
#include "support/temp_files.h"

using namespace ravel;
using namespace ravel::test;

namespace {

std::string place_of(const Mesh& mesh, Index point) {
    std::string text;
    for (std::size_t k = 0; k < 3; ++k)
        text += std::to_string(io::real_at(mesh.positions, 3 * point + k)) + " ";
    return text;
}

std::string cell_of(const Mesh& mesh, Index cell) {
    std::vector<std::string> places;
    for (const Index point : mesh.cell(cell)) places.push_back(place_of(mesh, point));
    std::sort(places.begin(), places.end());
    std::string text;
    for (const std::string& place : places) text += place + ", ";
    return text;
}

// What the numbers of an attribute name, in words; other numbers as they are.
std::vector<std::string> named(const Mesh& mesh, Place place, const std::string& name) {
    const Attribute* attribute = io::find_attribute(mesh, place, name);
    REQUIRE(attribute);
    const Array& values = attribute->values;
    std::vector<std::string> words;
    for (std::size_t i = 0; i < values.count() * values.arity; ++i) {
        std::int64_t number = 0;
        REQUIRE(io::integer_at(values, i, number));
        words.push_back(std::to_string(number));
        for (const Reference& r : attribute->references) {
            const Index n = static_cast<Index>(number) - static_cast<Index>(r.base);
            if (r.component != i % values.arity || n >= element_count(mesh, r.place)) continue;
            words.back() = r.place == Place::point ? place_of(mesh, n) : cell_of(mesh, n);
        }
    }
    return words;
}

// The points at corners with a value, and the value.
std::multimap<std::string, double> at_corners(const Mesh& mesh, const std::string& name) {
    const Attribute* attribute = io::find_attribute(mesh, Place::corner, name);
    REQUIRE(attribute);
    std::multimap<std::string, double> found;
    for (Index c = 0; c < mesh.cell_count(); ++c)
        for (std::size_t k = 0; k < mesh.cell(c).size(); ++k) {
            const Index tuple = io::tuple_of(*attribute, mesh.corner_begin[c] + k);
            if (tuple != kNoIndex)
                found.emplace(cell_of(mesh, c) + "at " + place_of(mesh, mesh.cell(c)[k]),
                              io::real_at(attribute->values, tuple));
        }
    return found;
}

Mesh through_codec(const Mesh& mesh) {
    const auto packed = encode(mesh);
    REQUIRE(packed.ok());
    const auto again = decode(packed->bytes);
    REQUIRE(again.ok());
    CHECK(again->mesh.positions.bytes != mesh.positions.bytes);
    CHECK(compare_meshes(mesh, again->mesh, packed->order, 0).equal);
    return again->mesh;
}

Mesh through_file(const Mesh& mesh, std::string_view name) {
    const TempFolder folder;
    REQUIRE(io::write_mesh(mesh, folder / name, {}).ok());
    const Result<Mesh> again = io::read_mesh(folder / name);
    REQUIRE(again.ok());
    return *again;
}

Mesh made(const std::string& recipe) {
    const auto mesh = make::make_mesh(recipe);
    REQUIRE(mesh.ok());
    return *mesh;
}

// A made mesh as the text of a file, with more before the last line.
std::string text_of(const std::string& recipe, std::string_view name, std::string_view more,
                    std::string_view last) {
    const TempFolder folder;
    REQUIRE(io::write_mesh(made(recipe), folder / name, {}).ok());
    std::string text = folder.read(name);
    const std::size_t end = text.rfind(last);
    REQUIRE(end != std::string::npos);
    return text.insert(end, more);
}

void check_same_names(const Mesh& mesh, const std::vector<std::string>& names,
                      std::string_view file) {
    const Mesh decoded = through_codec(mesh);
    const Mesh again = through_file(decoded, file);
    for (const std::string& name : names) {
        INFO(name);
        CHECK(named(decoded, Place::mesh, name) == named(mesh, Place::mesh, name));
        CHECK(named(again, Place::mesh, name) == named(mesh, Place::mesh, name));
    }
}

}  // namespace

TEST_CASE("MEDIT sections name the same vertices and tets after the codec", "[roundtrip][io]") {
    const Result<Mesh> mesh = read_bytes(
        "a.mesh", text_of("tets:box=4,jitter=0.2,shuffle", "a.mesh",
                          "Corners 4\n1\n25\n77\n125\nRequiredVertices 2\n3\n9999\n"
                          "NormalAtVertices 3\n7 1\n8 2\n100 3\nVertexOnGeometricEdge 2\n"
                          "12 4 0.5\n99 4 0.25\nRequiredTetrahedra 3\n1\n200\n384\n",
                          "End"));
    REQUIRE(mesh.ok());
    check_same_names(*mesh,
                     {"medit:Corners", "medit:RequiredVertices", "medit:NormalAtVertices",
                      "medit:VertexOnGeometricEdge", "medit:RequiredTetrahedra"},
                     "b.mesh");
}

TEST_CASE("MEDIT sections name the same triangles, quadrilaterals and corners after the codec",
          "[roundtrip][io]") {
    // A strip of quadrilaterals, each beside two triangles.
    constexpr int kLength = 20;
    std::string points = "Vertices " + std::to_string(3 * kLength) + "\n";
    std::string quads = "Quadrilaterals " + std::to_string(kLength - 1) + "\n";
    std::string triangles = "Triangles " + std::to_string(2 * (kLength - 1)) + "\n";
    for (int i = 0; i < kLength; ++i) {
        for (const int y : {0, 1, 2})
            points += std::to_string(i * (y + 3)) + " " + std::to_string(y) + " 0 0\n";
        if (i + 1 == kLength) break;
        const auto at = [&](int column, int row) {
            return std::to_string(3 * (i + column) + row + 1) + " ";
        };
        quads += at(0, 0) + at(1, 0) + at(1, 1) + at(0, 1) + "0\n";
        triangles +=
            at(0, 1) + at(1, 1) + at(1, 2) + "0\n" + at(0, 1) + at(1, 2) + at(0, 2) + "0\n";
    }
    const std::string more =
        "Normals 1\n0 0 1\nRequiredTriangles 3\n1\n30\n38\nRequiredQuadrilaterals 2\n1\n19\n"
        "NormalAtTriangleVertices 3\n38 3 7\n1 1 8\n20 2 9\n";
    for (const std::string& cells : {quads + triangles, triangles + quads}) {
        const Result<Mesh> mesh =
            read_bytes("a.mesh", "MeshVersionFormatted 1\nDimension 3\n" + points + cells + more);
        REQUIRE(mesh.ok());
        check_same_names(*mesh, {"medit:RequiredTriangles", "medit:RequiredQuadrilaterals"},
                         "b.mesh");
        const Mesh decoded = through_codec(*mesh);
        const std::string name = "medit:NormalAtTriangleVertices";
        CHECK(at_corners(decoded, name) == at_corners(*mesh, name));
        CHECK(at_corners(through_file(decoded, "b.mesh"), name) == at_corners(*mesh, name));
    }
}

TEST_CASE("TetGen neighbours name the same tets after the codec", "[roundtrip][io]") {
    const Mesh box = made("tets:box=3,shuffle");
    for (const Index first : {Index{0}, Index{1}}) {
        Mesh numbered = box;
        numbered.notes.push_back({"tetgen:first", std::to_string(first)});
        const TempFolder folder;
        REQUIRE(io::write_mesh(numbered, folder / "a.ele", {}).ok());
        std::string faces = std::to_string(box.cell_count()) + " 0\n";
        for (Index c = 0; c < box.cell_count(); ++c) {
            faces += std::to_string(c + first) + " ";
            for (std::size_t k = 1; k < 4; ++k)
                faces += std::to_string(box.cell(c)[k] + first) + " ";
            faces += std::to_string(c + first) + " ";
            faces +=
                (c % 3 == 0 ? "-1" : std::to_string((c * 7) % box.cell_count() + first)) + "\n";
        }
        folder.write("a.face", faces);
        const Result<Mesh> mesh = io::read_mesh(folder / "a.ele");
        REQUIRE(mesh.ok());
        check_same_names(*mesh, {"tetgen:neighbours:face"}, "b.ele");
    }
}

TEST_CASE("Gmsh sections kept as text name the same nodes, elements and corners after the codec",
          "[roundtrip][io]") {
    const Result<Mesh> mesh = read_bytes(
        "a.msh", text_of("tets:box=3,shuffle", "a.msh",
                         "$ElementNodeData\n1\n\"u\"\n1\n0\n3\n0\n1\n1\n5 4 10 20 30 40\n"
                         "$EndElementNodeData\n$Periodic\n1\n0 2 1\n0\n1\n1 2\n$EndPeriodic\n",
                         "$Elements"));
    REQUIRE(mesh.ok());
    const Mesh again = through_file(through_codec(*mesh), "b.msh");
    REQUIRE(io::find_note(again, "gmsh:section:Periodic"));
    REQUIRE(io::find_note(again, "gmsh:section:ElementNodeData"));
    // Each numbered node and element is where it was, with the corners in the order of the data.
    const auto by_number = [](const Mesh& m, Place place, const char* name) {
        const Attribute* numbers = io::find_attribute(m, place, name);
        REQUIRE(numbers);
        std::map<std::int64_t, std::string> found;
        for (Index i = 0; i < numbers->values.count(); ++i) {
            std::string& words = found[numbers->values.as<std::int64_t>()[i]];
            if (place == Place::point)
                words = place_of(m, i);
            else
                for (const Index p : m.cell(i)) words += place_of(m, p) + ", ";
        }
        return found;
    };
    CHECK(by_number(again, Place::point, "gmsh:node") ==
          by_number(*mesh, Place::point, "gmsh:node"));
    CHECK(by_number(again, Place::cell, "gmsh:element") ==
          by_number(*mesh, Place::cell, "gmsh:element"));
}
