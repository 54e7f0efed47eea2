// Directions that are normals of the surface are guessed from it: they come back bit for bit, and
// cost much less than others.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "make/make_mesh.h"
#include "make/random.h"
#include "ravel/ravel.h"

using namespace ravel;

namespace {

using Vector = std::array<double, 3>;

Vector place(const Mesh& mesh, Index p) {
    const auto x = mesh.positions.as<float>();
    return {x[3 * p], x[3 * p + 1], x[3 * p + 2]};
}
Vector minus(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector normal_of(const Mesh& mesh, Index cell) {
    const auto corners = mesh.cell(cell);
    Vector sum{};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Vector a = place(mesh, corners[0]);
        const Vector n =
            cross(minus(place(mesh, corners[i]), a), minus(place(mesh, corners[i + 1]), a));
        for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
    }
    return sum;
}
double angle_at(const Mesh& mesh, Index cell, std::size_t i) {
    const auto corners = mesh.cell(cell);
    const std::size_t n = corners.size();
    const Vector at = place(mesh, corners[i]);
    const Vector u = minus(place(mesh, corners[(i + 1) % n]), at);
    const Vector v = minus(place(mesh, corners[(i + n - 1) % n]), at);
    return std::acos(std::clamp(dot(u, v) / std::sqrt(dot(u, u) * dot(v, v)), -1.0, 1.0));
}
// Weighed by the areas of cells or by their angles.
std::vector<Vector> normals_of_points(const Mesh& mesh, bool by_angle) {
    std::vector<Vector> sums(mesh.point_count());
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const Vector n = normal_of(mesh, c);
        const auto corners = mesh.cell(c);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const double weight = by_angle ? angle_at(mesh, c, i) / std::sqrt(dot(n, n)) : 1;
            for (std::size_t k = 0; k < 3; ++k) sums[corners[i]][k] += weight * n[k];
        }
    }
    return sums;
}

Attribute of_length_1(Place where, const std::vector<Vector>& sums) {
    Attribute a{"normal", where, make_array(Scalar::f32, 3, sums.size()), {}, {}};
    for (std::size_t i = 0; i < sums.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            a.values.as<float>()[3 * i + k] =
                static_cast<float>(sums[i][k] / std::sqrt(dot(sums[i], sums[i])));
    return a;
}

// Of points; of cells; of corners, each its cell's; of corners that share those of their points.
std::vector<Attribute> normals_of(const Mesh& mesh, bool by_angle) {
    std::vector<Vector> of_cells, of_corners;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        of_cells.push_back(normal_of(mesh, c));
        of_corners.insert(of_corners.end(), mesh.cell(c).size(), of_cells.back());
    }
    const std::vector<Vector> of_points = normals_of_points(mesh, by_angle);
    std::vector<Attribute> all{
        of_length_1(Place::point, of_points), of_length_1(Place::cell, of_cells),
        of_length_1(Place::corner, of_corners), of_length_1(Place::corner, of_points)};
    all.back().index = mesh.corners;
    return all;
}

Mesh made(const char* recipe) {
    Result<Mesh> mesh = make::make_mesh(recipe);
    REQUIRE(mesh.ok());
    mesh->attributes.clear();
    return std::move(*mesh);
}

// Every fifth cell turned round; its normals stay those of the surface.
void flip_some(Mesh& mesh) {
    for (Index c = 0; c < mesh.cell_count(); c += 5)
        std::reverse(mesh.corners.begin() + static_cast<std::ptrdiff_t>(mesh.corner_begin[c]),
                     mesh.corners.begin() + static_cast<std::ptrdiff_t>(mesh.corner_begin[c + 1]));
}

std::size_t size_that_comes_back(const Mesh& mesh, const EncodeOptions& options = {}) {
    const Result<Encoded> packed = encode(mesh, options);
    REQUIRE(packed.ok());
    const Result<Decoded> again = decode(packed->bytes);
    REQUIRE(again.ok());
    const Comparison found = compare_meshes(mesh, again->mesh, packed->order,
                                            packed->position_bound, packed->attribute_bounds);
    INFO(found.difference);
    CHECK(found.equal);
    return packed->bytes.size();
}

}  // namespace

TEST_CASE("normals come back, of points, cells, corners and pools, also on cells turned round") {
    for (const char* recipe :
         {"sphere:subdivide=2,bumps=0.2", "polygons:mixed,size=9x9", "terrain:size=12x9,holes=3"})
        for (const bool flipped : {false, true})
            for (const bool by_angle : {false, true}) {
                Mesh mesh = made(recipe);
                std::vector<Attribute> normals = normals_of(mesh, by_angle);
                if (flipped) flip_some(mesh);
                normals.back().index = mesh.corners;
                for (const bool keep_order : {false, true})
                    for (const Attribute& a : normals) {
                        mesh.attributes = {a};
                        EncodeOptions options;
                        options.keep_order = keep_order;
                        CAPTURE(recipe, flipped, by_angle, keep_order, int(a.place));
                        size_that_comes_back(mesh, options);
                        options.position_bits = 10;
                        options.attributes = {{"normal", {}, {}, {}, 12}};
                        size_that_comes_back(mesh, options);
                    }
            }
}

TEST_CASE("normals of a surface cost less than half of what as many others cost") {
    make::Random random{5};
    for (const char* recipe : {"sphere:subdivide=4,bumps=0.2", "torus:quads=2000,bumps=0.3"})
        for (const bool by_angle : {false, true}) {
            const Mesh bare = made(recipe);
            const std::size_t without = size_that_comes_back(bare);
            for (const Attribute& a : normals_of(bare, by_angle)) {
                Mesh mesh = bare, mixed = bare;
                mesh.attributes = {a};
                mixed.attributes = {a};
                const auto x = mixed.attributes[0].values.as<float>();
                for (std::size_t i = x.size() / 3; i > 1; --i)
                    std::swap_ranges(x.begin() + static_cast<std::ptrdiff_t>(3 * i - 3),
                                     x.begin() + static_cast<std::ptrdiff_t>(3 * i),
                                     x.begin() + static_cast<std::ptrdiff_t>(3 * random.below(i)));
                CAPTURE(recipe, by_angle, int(a.place), a.index.empty());
                CHECK(2 * (size_that_comes_back(mesh) - without) <
                      size_that_comes_back(mixed) - without);
            }
        }
}
