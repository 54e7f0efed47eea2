// What rides along: attributes of every place and type, pools, references, names, notes,
// companions; and positions at the ends of what floats can hold.
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "make/random.h"
#include "support/mesh_from_bytes.h"
#include "support/small_meshes.h"

using namespace ravel;

namespace {

constexpr Place kPlaces[] = {Place::point, Place::corner, Place::cell, Place::companion,
                             Place::mesh};

void fill(Array& array, make::Random& random) {
    for (std::byte& b : array.bytes) b = static_cast<std::byte>(random.next() >> 9);
}

// Edge nodes of a few quadratic tets (the ids need not make sense), lines, and a block without
// nodes.
void add_companions(Mesh& mesh) {
    if (mesh.point_count() == 0) return;
    const Index last = mesh.point_count() - 1;
    if (mesh.kind == CellKind::tet && mesh.cell_count() > 0) {
        CompanionBlock edges{24, 6, 2, std::vector<Index>(12, last), {mesh.cell_count() - 1, 0}};
        edges.nodes[3] = 0;
        mesh.companions.push_back(edges);
    }
    mesh.companions.push_back({3, 2, 3, {0, last, last, 0, 0, 0}, {}});
    mesh.companions.push_back({0, 0, 4, {}, {}});
    mesh.companions.push_back({13, 6, 0, {}, {}});
}

void add_attributes(Mesh& mesh, bool pools) {
    make::Random random{mesh.corners.size()};
    for (const Place place : kPlaces)
        for (unsigned s = 0; s <= static_cast<unsigned>(Scalar::f64); ++s) {
            const auto scalar = static_cast<Scalar>(s);
            const Index elements = element_count(mesh, place);
            Attribute a;
            a.name = std::string(name_of(place)) + "/" + name_of(scalar);
            a.place = place;
            const bool pool = pools && place != Place::mesh;
            a.values = make_array(scalar, 1 + s % 4, pool || place == Place::mesh ? 5 : elements);
            fill(a.values, random);
            for (Index i = 0; pool && i < elements; ++i)
                a.index.push_back(random.one_in(4) ? kNoIndex : random.below(5));
            mesh.attributes.push_back(std::move(a));
        }
}

void add_references(Mesh& mesh) {
    for (const Scalar scalar : {Scalar::i32, Scalar::u32, Scalar::i64, Scalar::u64})
        for (const Place place : {Place::point, Place::cell}) {
            Attribute a;
            a.name = "neighbours";
            a.place = Place::cell;
            a.values = make_array(scalar, 3, mesh.cell_count());
            a.references = {{0, place, 1}, {2, place, 0}};
            make::Random random{7};
            for (std::size_t i = 0; i < 3 * mesh.cell_count(); ++i) {
                const std::uint64_t n = random.below(mesh.point_count() + 3);
                if (size_of(scalar) == 4)
                    a.values.as<std::uint32_t>()[i] = static_cast<std::uint32_t>(n);
                else
                    a.values.as<std::uint64_t>()[i] = n;
            }
            mesh.attributes.push_back(std::move(a));
        }
}

void check(const std::string& name, const Mesh& mesh) {
    for (const bool order : {false, true})
        for (const bool grid : {false, true}) {
            EncodeOptions options;
            options.level = 1;
            options.keep_order = order;
            if (grid) options.position_bits = 9;
            INFO(name << (order ? ", order kept" : "") << (grid ? ", 9 bits" : ""));
            CHECK(test::trouble(mesh, options) == "");
        }
}

Mesh at_places(const std::vector<double>& values, CellKind kind) {
    std::vector<test::Point> points;
    for (std::size_t i = 0; i < 40; ++i)
        points.push_back({values[i % values.size()], values[i * 7 / 3 % values.size()],
                          values[i * i % values.size()]});
    std::vector<std::vector<Index>> polygons;
    std::vector<std::array<Index, 4>> tets;
    for (Index i = 0; i + 4 < 40; ++i)
        polygons.push_back({i, i + 1, i + 3, i + 2}), tets.push_back({i, i + 1, i + 2, i + 3});
    return kind == CellKind::tet ? test::tet_mesh(points, tets)
                                 : test::polygon_mesh(points, polygons);
}

}  // namespace

TEST_CASE("attributes of every place and scalar come back, plain and as pools") {
    for (auto& [name, mesh, clean] : test::small_meshes())
        for (const bool pools : {false, true}) {
            Mesh rich = mesh;
            add_companions(rich);
            add_attributes(rich, pools);
            REQUIRE(check_mesh(rich).ok());
            check(name + (pools ? ", pools" : ""), rich);
        }
}

TEST_CASE("the file is the same however many threads there are") {
    std::vector<test::NamedMesh> meshes = test::small_meshes();
    meshes.push_back({"a large grid", test::quad_grid(90, 80)});
    meshes.push_back({"many parts", test::with_holes(test::quad_grid(60, 50), 30, 1)});
    meshes.push_back({"a box of tets", test::tet_box(12, 11, 10)});
    for (test::NamedMesh& given : meshes)
        for (const bool more : {false, true}) {
            INFO(given.name << (more ? ", with attributes" : ""));
            if (more) {
                add_companions(given.mesh);
                add_attributes(given.mesh, true);
            }
            EncodeOptions options;
            options.level = 1;
            options.position_bits = 12;
            options.keep_order = more;
            const Result<Encoded> alone = encode(given.mesh, options);
            REQUIRE(alone);
            for (const int threads : {0, 3}) {
                options.threads = threads;
                const Result<Encoded> together = encode(given.mesh, options);
                REQUIRE(together);
                CHECK(together->bytes == alone->bytes);
                CHECK(together->order.cell == alone->order.cell);
            }
        }
}

TEST_CASE("numbers of points and cells follow their elements, others stay") {
    for (auto& [name, mesh, clean] : test::small_meshes()) {
        add_references(mesh);
        check(name, mesh);
    }
}

TEST_CASE("numbers that would not fit a reference's type are a bad mesh") {
    Mesh mesh = test::quad_grid(2, 2);
    Attribute a;
    a.place = Place::cell;
    a.values = make_array(Scalar::u32, 1, 4);
    a.references = {{0, Place::point, -1}};
    mesh.attributes.push_back(a);
    const auto packed = encode(mesh);
    REQUIRE_FALSE(packed.ok());
    CHECK(packed.error().code == Code::bad_mesh);
}

TEST_CASE("names and notes come back in order, empty, long and with zeros in them") {
    Mesh mesh = test::quad_grid(2, 2);
    mesh.tag_names = {{"region", -1, -5, "wall"},
                      {"", 3, std::int64_t{1} << 62, ""},
                      {"region", 0, 0, std::string(5000, 'x')}};
    mesh.notes = {{"obj:mtllib", "chair.mtl"},
                  {"", ""},
                  {std::string("a\0b", 3), std::string(3, '\0')},
                  {"", ""}};
    check("names", mesh);
    mesh.tag_names.clear();
    check("notes alone", mesh);
}

TEST_CASE("an empty mesh comes back with everything that can ride along") {
    for (const CellKind kind : {CellKind::polygon, CellKind::tet})
        for (const bool pools : {false, true}) {
            Mesh mesh;
            mesh.kind = kind;
            mesh.companions.push_back({1, 0, 3, {}, {}});
            mesh.companions.push_back({5, 3, 0, {}, {}});
            add_attributes(mesh, pools);
            mesh.notes.push_back({"k", "v"});
            REQUIRE(check_mesh(mesh).ok());
            check("empty", mesh);
        }
}

TEST_CASE("positions at the ends of float64 come back bit for bit, and near on a grid") {
    using L = std::numeric_limits<double>;
    const std::vector<std::vector<double>> sets{{0},
                                                {-0.0, 0.0},
                                                {L::denorm_min(), 0, -L::denorm_min()},
                                                {L::max(), -L::max(), 0},
                                                {L::max()},
                                                {1e308, 1e-308, -1e308},
                                                {L::infinity(), 1, -L::infinity(), 2},
                                                {L::infinity()},
                                                {L::quiet_NaN(), 0.5, L::signaling_NaN(), 3},
                                                {L::quiet_NaN()},
                                                {1e15, 1e15 + 0.125, 1e15 + 1},
                                                {1e-320, 3e-320, 9e-310},
                                                {3e38, -3e38, 1e39},
                                                {0.1, 0.2, 0.30000000000000004, 1.0 / 3}};
    for (std::size_t i = 0; i < sets.size(); ++i)
        for (const CellKind kind : {CellKind::polygon, CellKind::tet}) {
            const Mesh mesh = at_places(sets[i], kind);
            check("set " + std::to_string(i), mesh);
            for (const double error :
                 {1e-323, 1e-310, 1e-20, 1e-9, 1e-3, 1.0, 1e10, 1e290, 9e299}) {
                EncodeOptions options;
                options.level = 1;
                options.max_error = error;
                INFO("set " << i << ", error " << error);
                CHECK(test::trouble(mesh, options) == "");
            }
            for (int bits = 1; bits <= 30; ++bits) {
                EncodeOptions options;
                options.level = 1;
                options.position_bits = bits;
                INFO("set " << i << ", bits " << bits);
                CHECK(test::trouble(mesh, options) == "");
            }
        }
}

TEST_CASE("broken options and broken meshes are refused by name") {
    Mesh mesh = test::quad_grid(2, 2);
    mesh.positions.as<float>()[3] = 0.7182818F;  // on no grid of few digits
    const auto code = [&](auto change) {
        EncodeOptions options;
        change(options);
        const auto packed = encode(mesh, options);
        REQUIRE_FALSE(packed.ok());
        CHECK_FALSE(packed.error().detail.empty());
        return packed.error().code;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(code([](EncodeOptions& o) { o.position_bits = 0; }) == Code::bad_option);
    CHECK(code([](EncodeOptions& o) { o.position_bits = 31; }) == Code::bad_option);
    CHECK(code([](EncodeOptions& o) { o.max_error = 0.0; }) == Code::bad_option);
    CHECK(code([](EncodeOptions& o) { o.max_error = -1.0; }) == Code::bad_option);
    CHECK(code([&](EncodeOptions& o) { o.max_error = nan; }) == Code::bad_option);
    CHECK(code([](EncodeOptions& o) { o.max_error = 1e-18; }) == Code::bad_option);
    CHECK(code([](EncodeOptions& o) { o.max_error = 1.0, o.position_bits = 8; }) ==
          Code::bad_option);
    CHECK(code([](EncodeOptions& o) { o.level = 0; }) == Code::bad_option);
    CHECK(code([](EncodeOptions& o) { o.level = 23; }) == Code::bad_option);
    CHECK(code([](EncodeOptions& o) { o.threads = -1; }) == Code::bad_option);
    CHECK(code([&](EncodeOptions& o) { o.strip_budget = nan; }) == Code::bad_option);
    Mesh broken = mesh;
    broken.corners[3] = broken.point_count();
    CHECK(encode(broken).error().code == Code::bad_mesh);
}
