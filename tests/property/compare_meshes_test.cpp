// The judge of all round trips must be able to say no: every tampering with a decoded mesh is seen.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "make/make_mesh.h"
#include "ravel/ravel.h"

using namespace ravel;

namespace {

struct Trip {
    Mesh mesh;
    Encoded packed;
    Mesh decoded;
    bool equal(const Mesh& other, double bound) const {
        return compare_meshes(mesh, other, packed.order, bound).equal;
    }
};

Trip trip(const char* recipe, const EncodeOptions& options = {}) {
    Result<Mesh> mesh = make::make_mesh(recipe);
    REQUIRE(mesh.ok());
    mesh->notes.push_back({"key", "text"});
    mesh->tag_names.push_back({"region", 2, 1, "wall"});
    Result<Encoded> packed = encode(*mesh, options);
    REQUIRE(packed.ok());
    Result<Decoded> decoded = decode(packed->bytes);
    REQUIRE(decoded.ok());
    return {std::move(*mesh), std::move(*packed), std::move(decoded->mesh)};
}

const char* const kRecipes[] = {"polygons:mixed,size=6x6,attributes,shuffle",
                                "tets:box=3,attributes,companions,shuffle"};

}  // namespace

TEST_CASE("an untouched mesh is equal and has no difference in words") {
    for (const char* recipe : kRecipes) {
        const Trip t = trip(recipe);
        const Comparison found = compare_meshes(t.mesh, t.decoded, t.packed.order, 0);
        CHECK(found.equal);
        CHECK(found.difference.empty());
        CHECK_FALSE(found.order_kept);
    }
}

TEST_CASE("every change of one part is a difference") {
    for (const char* recipe : kRecipes) {
        const Trip t = trip(recipe);
        const auto differs = [&](auto change) {
            Mesh other = t.decoded;
            change(other);
            const Comparison found = compare_meshes(t.mesh, other, t.packed.order, 0);
            return !found.equal && !found.difference.empty();
        };
        INFO(recipe);
        CHECK(differs([](Mesh& m) { std::swap(m.corners[0], m.corners[1]); }));
        CHECK(differs([](Mesh& m) { m.corners[5] = (m.corners[5] + 1) % m.point_count(); }));
        CHECK(differs([](Mesh& m) { m.positions.bytes[7] ^= std::byte{1}; }));
        CHECK(differs([](Mesh& m) { m.positions.bytes.resize(m.positions.bytes.size() - 12); }));
        CHECK(differs([](Mesh& m) {
            m.kind = m.kind == CellKind::tet ? CellKind::polygon : CellKind::tet, m.corners.clear(),
            m.corner_begin.clear();
        }));
        CHECK(differs([](Mesh& m) { m.notes.clear(); }));
        CHECK(differs([](Mesh& m) { m.notes[0].text += ' '; }));
        CHECK(differs([](Mesh& m) { m.tag_names.back().name = "roof"; }));
        CHECK(differs([](Mesh& m) { m.tag_names.back().value = 2; }));
        CHECK(differs([](Mesh& m) { m.attributes.pop_back(); }));
        for (std::size_t a = 0; a < t.decoded.attributes.size(); ++a) {
            CHECK(differs([&](Mesh& m) { m.attributes[a].name += 'x'; }));
            CHECK(
                differs([&](Mesh& m) { m.attributes[a].values.bytes.back() ^= std::byte{0x80}; }));
            CHECK(differs([&](Mesh& m) { m.attributes[a].place = Place::mesh; }));
            if (!t.decoded.attributes[a].index.empty())
                CHECK(differs([&](Mesh& m) { m.attributes[a].index[3] = kNoIndex; }));
        }
        for (std::size_t b = 0; b < t.decoded.companions.size(); ++b) {
            CHECK(differs(
                [&](Mesh& m) { std::swap(m.companions[b].nodes[0], m.companions[b].nodes[1]); }));
            CHECK(differs([&](Mesh& m) { m.companions[b].vtk_type = 1; }));
        }
    }
}

TEST_CASE("a cell that starts with another corner is a difference") {
    const Trip t = trip("grid:size=4x4");
    Mesh other = t.decoded;
    std::rotate(other.corners.begin(), other.corners.begin() + 1, other.corners.begin() + 4);
    CHECK_FALSE(t.equal(other, 0));
    const Trip tets = trip("tets:box=2");
    other = tets.decoded;
    std::rotate(other.corners.begin(), other.corners.begin() + 1,
                other.corners.begin() + 3);  // an even permutation
    CHECK_FALSE(tets.equal(other, 0));
}

TEST_CASE("order maps that are no permutations are a difference") {
    const Trip t = trip("grid:size=4x4");
    OrderMaps order = t.packed.order;
    order.point[0] = order.point[1];
    CHECK_FALSE(compare_meshes(t.mesh, t.decoded, order, 0).equal);
    order = t.packed.order;
    order.cell.pop_back();
    CHECK_FALSE(compare_meshes(t.mesh, t.decoded, order, 0).equal);
    order = t.packed.order;
    order.turn[2] = 4;
    CHECK_FALSE(compare_meshes(t.mesh, t.decoded, order, 0).equal);
}

TEST_CASE("a point farther away than the bound is a difference, a nearer one is not") {
    EncodeOptions options;
    options.max_error = 0.01;
    const Trip t = trip("torus:size=12x8,double", options);
    const Comparison found = compare_meshes(t.mesh, t.decoded, t.packed.order, 0.01);
    CHECK(found.equal);
    CHECK(found.max_error > 0);
    CHECK(found.max_error <= 0.01);
    CHECK_FALSE(t.equal(t.decoded, found.max_error * 0.99));
    CHECK_FALSE(t.equal(t.decoded, 0));
    Mesh other = t.decoded;
    other.positions.as<double>()[10] += 0.03;
    CHECK_FALSE(t.equal(other, 0.01));
    other.positions.as<double>()[10] = std::nan("");
    CHECK_FALSE(t.equal(other, 0.01));
}

TEST_CASE("the sign of zero is a difference where positions are exact") {
    const Trip t = trip("grid:size=3x3,double");
    Mesh other = t.decoded;
    for (double& x : other.positions.as<double>())
        if (x == 0) {
            x = -x;
            break;
        }
    CHECK_FALSE(t.equal(other, 0));
}
