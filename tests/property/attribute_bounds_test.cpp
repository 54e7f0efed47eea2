// Attributes that may lose precision stay within their bound, as the file says and measured afresh;
// what no grid holds comes back bit for bit.
#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <limits>

#include "make/make_mesh.h"
#include "make/random.h"
#include "ravel/ravel.h"

using namespace ravel;

namespace {

Mesh made(const char* recipe) {
    Result<Mesh> mesh = make::make_mesh(recipe);
    REQUIRE(mesh.ok());
    return std::move(*mesh);
}

double unit(make::Random& random) {
    return static_cast<double>(random.below(1u << 30)) / (1u << 29) - 1;
}

// Smooth and rough, with values that no grid holds.
Attribute field_of(const Mesh& mesh, Place place, Scalar scalar, std::uint32_t arity, bool wild,
                   make::Random& random) {
    Attribute a{"field", place, make_array(scalar, arity, element_count(mesh, place)), {}, {}};
    for (std::size_t i = 0; i < a.values.count() * arity; ++i) {
        double x = 100 * std::sin(static_cast<double>(i) / 50) + unit(random);
        if (wild) {
            const double odd[] = {
                std::numeric_limits<double>::quiet_NaN(), INFINITY, -INFINITY, -0.0, 1e30, 5e-324};
            if (random.below(10) == 0) x = odd[random.below(6)];
        }
        if (scalar == Scalar::f32)
            a.values.as<float>()[i] = static_cast<float>(x);
        else
            a.values.as<double>()[i] = x;
    }
    return a;
}

// Unit vectors, and some that are none.
Attribute directions_of(const Mesh& mesh, Scalar scalar, bool wild, make::Random& random) {
    Attribute a{"field", Place::point, make_array(scalar, 3, mesh.point_count()), {}, {}};
    for (std::size_t p = 0; p < a.values.count(); ++p) {
        double v[3] = {unit(random), unit(random), unit(random)};
        if (random.below(4) == 0) v[0] = v[1] = 0, v[2] = -1;
        const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = wild && random.below(20) == 0 ? 7 * unit(random) : v[k] / length;
            if (scalar == Scalar::f32)
                a.values.as<float>()[3 * p + k] = static_cast<float>(x);
            else
                a.values.as<double>()[3 * p + k] = x;
        }
    }
    return a;
}

// Turns values per element into a pool with an index; some elements have none.
void make_pool(Attribute& a, make::Random& random) {
    for (Index e = 0; e < a.values.count(); ++e)
        a.index.push_back(random.below(9) == 0 ? kNoIndex : random.below(a.values.count()));
}

void check_bounds(const Mesh& mesh, const EncodeOptions& options) {
    const Result<Encoded> packed = encode(mesh, options);
    REQUIRE(packed.ok());
    const Result<Decoded> again = decode(packed->bytes);
    REQUIRE(again.ok());
    const Comparison found = compare_meshes(mesh, again->mesh, packed->order,
                                            packed->position_bound, packed->attribute_bounds);
    INFO(found.difference);
    CHECK(found.equal);
    const Result<FileInfo> info = inspect(packed->bytes);
    REQUIRE(info.ok());
    REQUIRE(info->attributes.size() == mesh.attributes.size());
    for (std::size_t i = 0; i < info->attributes.size(); ++i) {
        CHECK(info->attributes[i].bound == packed->attribute_bounds[i]);
        CHECK(found.attribute_errors[i] <= info->attributes[i].error);
        CHECK(info->attributes[i].error <= info->attributes[i].bound);
    }
    if (options.attributes[0].max_error)
        CHECK(packed->attribute_bounds.back() <= *options.attributes[0].max_error);
}

}  // namespace

TEST_CASE("rounded attributes stay within their bound") {
    make::Random random{7};
    for (const char* recipe :
         {"grid:size=9x7", "tets:box=3x3x3,jitter=0.2", "soup:polygons=60", "soup:tets=60",
          "tiny:empty", "tiny:points", "tiny:quad", "polygons:mixed,size=8x8,attributes"}) {
        const Mesh bare = made(recipe);
        for (const Place place : {Place::point, Place::cell, Place::corner, Place::mesh})
            for (const Scalar scalar : {Scalar::f32, Scalar::f64})
                for (const bool wild : {false, true})
                    for (int how = 0; how < 3; ++how) {
                        Mesh mesh = bare;
                        const auto arity = static_cast<std::uint32_t>(1 + random.below(4));
                        mesh.attributes.push_back(
                            field_of(mesh, place, scalar, arity, wild, random));
                        if (place != Place::mesh && random.below(3) == 0)
                            make_pool(mesh.attributes.back(), random);
                        EncodeOptions options;
                        options.keep_order = random.below(2) == 0;
                        AttributeOptions rounded{"field", {}, {}, {}, {}};
                        if (how == 0) rounded.bits = static_cast<int>(1 + random.below(30));
                        if (how == 1) rounded.max_error = std::pow(10, -double(random.below(9)));
                        if (how == 2) rounded.max_error_relative = 1e-4;
                        options.attributes = {rounded};
                        CAPTURE(recipe, int(place), int(scalar), wild, how);
                        check_bounds(mesh, options);
                    }
    }
}

TEST_CASE("directions stay within the bound of their bits") {
    make::Random random{8};
    for (const char* recipe : {"sphere:subdivide=3", "tets:ball=3", "soup:polygons=60"})
        for (const Scalar scalar : {Scalar::f32, Scalar::f64})
            for (const bool wild : {false, true})
                for (const int bits : {3, 8, 10, 16, 24}) {
                    Mesh mesh = made(recipe);
                    mesh.attributes.push_back(directions_of(mesh, scalar, wild, random));
                    EncodeOptions options;
                    options.attributes = {{"field", {}, {}, {}, bits}};
                    CAPTURE(recipe, int(scalar), wild, bits);
                    check_bounds(mesh, options);
                }
}

TEST_CASE("fewer bits make fewer bytes, and decoding what was rounded rounds no further") {
    make::Random random{9};
    Mesh mesh = made("terrain:size=40x40");
    mesh.attributes.push_back(field_of(mesh, Place::point, Scalar::f64, 1, false, random));
    std::size_t last = encode(mesh)->bytes.size();
    for (const int bits : {24, 16, 12, 8}) {
        EncodeOptions options;
        options.attributes = {{"field", bits, {}, {}, {}}};
        const Result<Encoded> packed = encode(mesh, options);
        REQUIRE(packed.ok());
        CHECK(packed->bytes.size() < last);
        last = packed->bytes.size();
        const Result<Decoded> again = decode(packed->bytes);
        REQUIRE(again.ok());
        EncodeOptions once_more;
        once_more.attributes = {{"field", {}, packed->attribute_bounds.back(), {}, {}}};
        const Result<Encoded> twice = encode(again->mesh, once_more);
        REQUIRE(twice.ok());
        CHECK(inspect(twice->bytes)->attributes.back().error <= packed->attribute_bounds.back());
    }
}

TEST_CASE("bounds that can't be are refused") {
    const Mesh mesh = made("tets:box=2x2x2,attributes");
    const auto refused = [&](AttributeOptions rounded) {
        EncodeOptions options;
        options.attributes = {std::move(rounded)};
        const Result<Encoded> packed = encode(mesh, options);
        return !packed && packed.error().code == Code::bad_option;
    };
    for (const Attribute& a : mesh.attributes) {
        CHECK(refused({a.name, 8, {}, {}, {}}) == !is_float(a.values.scalar));
        CHECK(refused({a.name, {}, {}, {}, {}}));
        CHECK(refused({a.name, 8, 0.1, {}, {}}));
        CHECK(refused({a.name, {}, 0.0, {}, {}}));
        CHECK(refused({a.name, {}, {}, std::nan(""), {}}));
        CHECK(refused({a.name, {}, {}, {}, 2}));
        CHECK(refused({a.name, {}, {}, {}, 10}) ==
              (!is_float(a.values.scalar) || a.values.arity != 3));
    }
    CHECK(refused({"no such name", 8, {}, {}, {}}));
}
