#include <catch2/catch.hpp>

#include "io/attributes.h"
#include "io/vtu_types.h"
#include "support/temp_files.h"

using namespace ravel;
using namespace ravel::test;

namespace {

std::string vtu(std::string_view pieces, std::string_view more = "") {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" " +
           std::string(more) + ">\n<UnstructuredGrid>\n" + std::string(pieces) +
           "</UnstructuredGrid>\n</VTKFile>\n";
}

// A piece of one tet whose points are at x.
std::string tet(const std::string& x, const std::string& type = "10",
                const std::string& nodes = "0 1 2 3") {
    return "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n<PointData>\n"
           "<DataArray type=\"Int8\" Name=\"a &amp; b\" format=\"ascii\">1 2 3 -4</DataArray>\n"
           "</PointData>\n<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\">\n" +
           x +
           " 0 0  1 0 0  0 1 0  0 0 1\n</DataArray></Points>\n<Cells>\n"
           "<DataArray type=\"Int32\" Name=\"connectivity\">" +
           nodes +
           "</DataArray>\n"
           "<DataArray type=\"Int32\" Name=\"offsets\">4</DataArray>\n"
           "<DataArray type=\"UInt8\" Name=\"types\">" +
           type +
           "</DataArray>\n"
           "</Cells>\n</Piece>\n";
}

std::string error(const std::string& text) {
    return error_of("a.vtu", text);
}

// Everything that a VTU file can hold; long enough for several compressed blocks.
Mesh rich_mesh() {
    Mesh mesh;
    mesh.kind = CellKind::tet;
    std::vector<double> xyz;
    for (int i = 0; i < 30000; ++i) xyz.push_back(i % 7 == 0 ? -0.0 : 1.0 / i);
    mesh.positions = io::array_of(xyz, 3);
    for (Index c = 0; c < 9000; ++c) {
        for (const Index node : {c, c + 1, c + 2, c * 7 % 10000}) mesh.corners.push_back(node);
    }
    mesh.companions.push_back({5, 3, 2, {0, 1, 2, 3, 3, 3}, {}});
    mesh.companions.push_back({24, 6, 1, {4, 5, 6, 7, 8, 9}, {8999}});
    io::add_attribute(mesh, "<\"&'>", Place::point, make_array(Scalar::u16, 2, 10000));
    io::add_attribute(mesh, "none", Place::mesh, make_array(Scalar::f32, 1, 0));
    io::add_attribute(mesh, "time", Place::mesh, io::array_of(std::vector<double>{0.1}, 1));
    return mesh;
}

}  // namespace

TEST_CASE("VTU without points or cells comes back", "[io][vtu]") {
    CHECK(trouble_reading_again("a.vtu", vtu("")) == "");
    CHECK(trouble_reading_again("a.vtu", vtu("<Piece/>"), true) == "");
    Mesh empty;
    empty.corner_begin = {0};
    CHECK(trouble_coming_back(empty, "a.vtu", true) == "");
}

TEST_CASE("VTU in every encoding, compressor and header comes back", "[io][vtu]") {
    const Mesh mesh = rich_mesh();
    const TempFolder folder;
    for (const auto encoding : {io::VtuEncoding::text, io::VtuEncoding::inline_base64,
                                io::VtuEncoding::appended_raw, io::VtuEncoding::appended_base64}) {
        for (const auto compressor : {io::VtuCompressor::none, io::VtuCompressor::zlib,
                                      io::VtuCompressor::lz4, io::VtuCompressor::lzma}) {
            for (const bool wide : {false, true}) {
                const io::VtuOptions options{encoding, {compressor, wide, false}};
                std::vector<std::string> left_out;
                REQUIRE(io::write_vtu_as(mesh, folder / "a.vtu", options, &left_out));
                CHECK(left_out.empty());
                const Result<Mesh> again = io::read_mesh(folder / "a.vtu");
                if (!again) FAIL(again.error().detail);
                CHECK(difference(mesh, *again) == "");
            }
        }
    }
}

TEST_CASE("VTU pieces are put one behind the other", "[io][vtu]") {
    const Result<Mesh> mesh = read_bytes("a.vtu", vtu(tet("0.5") + tet("7")));
    if (!mesh) FAIL(mesh.error().detail);
    CHECK(mesh->point_count() == 8);
    CHECK(mesh->corners == std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7});
    CHECK(io::find_attribute(*mesh, Place::point, "a & b")->values.as<std::int8_t>()[7] == -4);
}

TEST_CASE("VTU base64 of either byte order, its header padded by itself, is read", "[io][vtu]") {
    const auto piece = [](const std::string& base64) {
        return "<Piece NumberOfPoints=\"1\"><Points><DataArray type=\"Float32\" "
               "NumberOfComponents=\"3\" format=\"binary\">" +
               base64 + "</DataArray></Points></Piece>";
    };
    // 12 bytes: 1, 0, -0.
    const Result<Mesh> little = read_bytes("a.vtu", vtu(piece("DAAAAA==AACAPwAAAAAAAACA")));
    if (!little) FAIL(little.error().detail);
    const Result<Mesh> big =
        read_bytes("a.vtu", vtu(piece("AAAADA==P4AAAAAAAACAAAAA"), "byte_order=\"BigEndian\""));
    if (!big) FAIL(big.error().detail);
    CHECK(little->positions.as<float>()[0] == 1);
    CHECK(same_array(little->positions, big->positions));
}

TEST_CASE("VTU that is wrong gets one line that says where", "[io][vtu]") {
    CHECK(error("") == "a.vtu:1: the XML is broken: No document element found");
    CHECK(error("<a/>") == "a.vtu:1: this is no VTK XML file");
    CHECK(error(vtu(tet("0"), "compressor=\"vtkZip\"")) ==
          "a.vtu:2: compressor \"vtkZip\" is unknown");
    CHECK(error(vtu(tet("0", "42"))) ==
          "a.vtu:11: polyhedra (VTK cell type 42) are not supported (cell 0)");
    CHECK(error(vtu(tet("0", "10", "0 1 2 4"))) ==
          "a.vtu:11: a cell uses point 4, but the piece has only 4");
    CHECK(error(vtu(tet("zero"))) == "a.vtu:9: expected a number of '', found 'zero'");
    CHECK(error(vtu(tet("0")).substr(0, 300)).starts_with("a.vtu:"));
}
