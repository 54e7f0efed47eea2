#include "spec/valid_files.h"

#include <bit>
#include <cmath>
#include <stdexcept>

#include "make/make_mesh.h"
#include "ravel/ravel.h"
#include "support/quadratic_tets.h"

namespace ravel::test {
namespace {

Mesh made(const std::string& recipe) {
    Result<Mesh> mesh = make::make_mesh(recipe);
    if (!mesh) throw std::runtime_error(mesh.error().detail);
    return std::move(*mesh);
}

// Coordinates become change(number of the coordinate, coordinate), as float64.
template <class Change>
Mesh with_coordinates(Mesh mesh, const Change& change) {
    Array wide = make_array(Scalar::f64, 3, mesh.point_count());
    for (std::size_t i = 0; i < 3 * mesh.point_count(); ++i)
        wide.as<double>()[i] = change(i, mesh.positions.scalar == Scalar::f32
                                             ? static_cast<double>(mesh.positions.as<float>()[i])
                                             : mesh.positions.as<double>()[i]);
    mesh.positions = std::move(wide);
    return mesh;
}

// A rod of so many cubes along the first axis, bent round; its ends meet.
Mesh ring_of(std::size_t cubes) {
    Mesh mesh = with_coordinates(made("tets:box=" + std::to_string(cubes) + "x1x1"),
                                 [](std::size_t, double x) { return x; });
    const auto x = mesh.positions.as<double>();
    for (std::size_t p = 0; p < mesh.point_count(); ++p) {
        // Round a square, so that no machine's sine matters.
        const double turn = 4 * x[3 * p] / double(cubes), far = 8 + x[3 * p + 1];
        const double along = far * (2 * (turn - std::floor(turn)) - 1);
        const int side = static_cast<int>(turn) % 4;
        x[3 * p] = side == 0 ? along : side == 1 ? far : side == 2 ? -along : -far;
        x[3 * p + 1] = side == 0 ? -far : side == 1 ? along : side == 2 ? far : -along;
        // Rough, so that no cube leads another.
        for (std::size_t k = 0; k < 3; ++k)
            x[3 * p + k] += double((3 * p + k) * 7919 * 104729 % 997) / 2000;
    }
    // Points are in the order of their first use: 0, 2, 4, 6 are at the start, the last four at the
    // end.
    const Index end = mesh.point_count() - 4;
    for (Index& p : mesh.corners) p = p < end ? p : 2 * (p - end);
    return mesh;
}

Mesh polygon_of(std::size_t corners) {
    Mesh mesh;
    mesh.positions = make_array(Scalar::f32, 3, corners);
    mesh.corner_begin = {0, corners};
    for (std::size_t i = 0; i < corners; ++i) {
        const auto k = static_cast<float>(i);
        mesh.corners.push_back(i);
        mesh.positions.as<float>()[3 * i] = k;
        mesh.positions.as<float>()[3 * i + 1] = k * (static_cast<float>(corners) - k) / 2;
    }
    return mesh;
}

EncodeOptions bits(int count) {
    EncodeOptions options;
    options.position_bits = count;
    return options;
}

}  // namespace

std::vector<ValidFile> valid_files() {
    std::vector<ValidFile> all;
    const auto add = [&](const char* name, const char* shows, const Mesh& mesh,
                         const EncodeOptions& options = {}) {
        Result<Encoded> packed = encode(mesh, options);
        if (!packed) throw std::runtime_error(std::string(name) + ": " + packed.error().detail);
        all.push_back({name, shows, std::move(packed->bytes)});
    };
    const auto add_made = [&](const char* name, const char* shows, const char* recipe,
                              const EncodeOptions& options = {}) {
        add(name, shows, made(recipe), options);
    };
    EncodeOptions ordered = bits(8), lattice;
    ordered.keep_order = true;
    lattice.lattice = 0x1p-4;

    add_made("empty", "no cells, no points", "tiny:empty");
    add_made("empty-tets", "no cells, five points that no cell uses", "tiny:tet-points");
    add_made("quad", "one cell, lossless", "tiny:quad");
    add("two-quads", "the worked example of chapter 17",
        with_coordinates(made("tiny:two-quads"),
                         [](std::size_t i, double) {
                             constexpr double kPoints[18] = {0, 0, 0, 1, 0, 0, 1, 1, 0,
                                                             0, 1, 0, 3, 0, 0, 3, 1, 0};
                             return kPoints[i];
                         }),
        [] {
            EncodeOptions options;
            options.lattice = 1;
            options.float32 = true;
            options.fast = true;  // Rice codes, no levels
            return options;
        }());
    add("polygon-of-11", "kDegreeRest is not asked for where all degrees are equal",
        polygon_of(11));
    add_made("degrees", "polygons of 0, 1, 2 and 4 corners", "tiny:degrees-0-1-2");
    add_made("mixed", "quads with triangles, pentagons and hexagons among them, on a grid",
             "polygons:mixed,size=5x4,seed=2", bits(9));
    add_made("triangles", "a sheet of triangles", "grid:size=3x3,triangles,jitter=0.2", bits(10));
    add_made("torus", "a closed surface, on a grid", "torus:size=6x4", bits(10));
    add_made("moebius", "a one-sided band: copies", "moebius:size=6x1", bits(7));
    add_made("fan-of-three", "three quads at one edge: copies and flips", "tiny:fan-of-three");
    add_made("flipped", "neighbours of opposite orientation: a flip", "tiny:flipped");
    add_made("bow-tie", "a corner twice in one polygon", "tiny:bow-tie");
    add_made("soup", "random polygons with every kind of dirt", "soup:polygons=14,seed=3", bits(8));
    add_made("two-apart", "two components", "tiny:two-apart");
    add_made("nine-apart", "nine components alike", "grid:size=1x1,copies=9", bits(8));
    add_made("precedents", "six alike: answers by precedents", "polygons:mixed,size=4x3,copies=6",
             bits(8));
    add_made("soup-four", "the soup four times: copies, flips and degrees by precedents",
             "soup:polygons=14,seed=3,copies=4", bits(8));
    add_made("hexagons", "a honeycomb: old corners, links", "polygons:hex,size=4x4", bits(9));
    add_made("holes", "quads with holes, lossless float64", "terrain:size=4x4,holes=5,double");
    add("decimals", "decimals of three places, a zero that is negative",
        with_coordinates(made("grid:size=3x2"), [](std::size_t i, double x) {
            return i == 5 ? -0.0 : std::nearbyint(1000 * x + 7 * double(i % 5)) / 1000;
        }));
    add("digits", "decimals of three significant digits",
        with_coordinates(made("grid:size=3x2"), [](std::size_t i, double) {
            const double d = 100 + double(i * i % 900);
            return i % 7 == 2 ? d / 1e6 : i % 7 == 4 ? -d / 100 : d * (i % 2 == 0 ? 1 : 10);
        }));
    add("binary", "float64 of all 53 bits",
        with_coordinates(made("tiny:quad"),
                         [](std::size_t i, double x) { return x + std::sqrt(double(i + 2)); }));
    add("escapes", "a grid, and coordinates that are not a number, and at infinity",
        with_coordinates(made("grid:size=3x2"),
                         [](std::size_t i, double x) {
                             return i == 4    ? std::bit_cast<double>(0x7FF8000000001234)
                                    : i == 18 ? HUGE_VAL
                                              : x;
                         }),
        bits(6));
    add("escapes-exact", "decimals, and some that are far smaller",
        with_coordinates(made("grid:size=5x4,double"), [](std::size_t i, double x) {
            return i % 7 == 3 ? 6.123233995736766e-17 : std::nearbyint(1000 * x) / 1000 + 0.125;
        }));
    add("levels", "places that are known from elsewhere",
        with_coordinates(made("grid:size=9x8"), [](std::size_t i, double x) {
            const std::size_t p = i / 3;
            return i % 3 == 2 ? double(p * p * 31 % 7 * 37) : std::nearbyint(x * 8) * 41;
        }));
    add_made("lattice", "multiples of a sixteenth", "terrain:size=4x3,double", lattice);
    // One side of the sheet is `off` on the second axis at every third point.
    const auto mirrored = [](double off) {
        return with_coordinates(made("grid:size=16x3"), [off](std::size_t i, double x) {
            // Column c of 17, mirrored at the ninth.
            const std::size_t p = i / 3, c = p % 17, d = c < 8 ? 16 - c : c;
            const std::size_t rough = (p / 17 * 17 + d) * 7919 * 104729 % 100003;
            if (i % 3 == 1)
                return std::floor(1000 * x) + double(rough % 997) + (c < 8 && p % 3 == 0 ? off : 0);
            if (i % 3 == 2) return double(rough);
            const double side = d == 8 ? 0 : double((d - 8) * 1000 + rough % 499);
            return c < 8 ? -side : side;
        });
    };
    add("mirrored", "a sheet and its mirror image: echoes", mirrored(0));
    add("nearly-mirrored", "a sheet and nearly its mirror image: echoes with an axis off",
        mirrored(3));
    add("parts", "a rough sheet six times: followers",
        with_coordinates(made("grid:size=4x3,copies=3"), [](std::size_t i, double) {
            const std::size_t p = i / 3, part = p / 20, q = p % 20;
            const std::size_t rough = (q * 3 + i % 3) * 7919 % 41;
            return double(i % 3 == 0   ? q % 5 * 50 + part * 400
                          : i % 3 == 1 ? q / 5 * 50 + part * 11
                                       : 0) +
                   double(rough);
        }));
    add("turns", "two rough sheets in turns, four times: the last but one leads",
        with_coordinates(made("grid:size=4x3,copies=8"), [](std::size_t i, double) {
            const std::size_t p = i / 3, part = p / 20, q = p % 20;
            const std::size_t rough = ((q * 3 + i % 3) * 7919 + part % 2 * 104729) % 41;
            return double(i % 3 == 0   ? q % 5 * 50 + part * 400
                          : i % 3 == 1 ? q / 5 * 50 + part * 11
                                       : 0) +
                   double(rough * (1 + part % 2 * 3));
        }));
    add_made("sphere", "fitted weights", "sphere:subdivide=4,bumps=0.2", bits(14));
    add_made("attributes", "attributes on points, cells and corners, names",
             "polygons:mixed,size=3x2,attributes", bits(6));
    add_made("order", "a kept order of points, cells and corners", "torus:size=5x4,shuffle",
             ordered);
    add_made("tet", "one tet, lossless", "tiny:tet");
    EncodeOptions fast = bits(9);
    fast.fast = true;
    add_made("folds", "tets by folds, residuals as Rice codes", "tets:ball=2,jitter=0.3", fast);
    add_made("folds-apart", "tets by folds, with flips and several components",
             "soup:tets=14,seed=4", fast);
    add("folds-ring", "by folds, a ring whose ends meet: an apex by its age", ring_of(60), fast);
    add_made("rice", "a rough sheet whose residuals are Rice codes", "grid:size=9x8,jitter=0.3",
             fast);
    add_made("two-tets", "two tets", "tiny:two-tets");
    add_made("tets-on-one-face", "three tets at one facet: copies, flips", "tiny:tets-on-one-face");
    Mesh turned = made("tiny:two-tets");
    std::swap(turned.corners[6], turned.corners[7]);
    add("tet-flipped", "a tet turned inside out: a flip", turned);
    add_made("flat-tet", "tets that repeat a corner", "tiny:flat-tet");
    add_made("box", "tets of a box, on a grid", "tets:box=2x1x1", bits(9));
    add_made("cubes", "cubes that are cut alike: gates of one shape", "tets:box=4x3x3", bits(9));
    add_made("bent", "cubes that are cut alike, bent: what leaders tell is carried over",
             "tets:box=7x3x3,bend=60,twist=20", bits(12));
    add_made("swept", "the same, bent alone: pairs of levels", "tets:box=7x3x3,bend=60", bits(12));
    add_made("astray", "cubes that are cut alike, a little astray: what leaders tell is moved",
             "tets:box=6x5x5,jitter=0.1", bits(12));
    add_made("ball", "tets of a ball, lossless", "tets:ball=2,jitter=0.1");
    add_made("shell", "tets with a hole, on a grid", "tets:shell=3,jitter=0.1", bits(10));
    add_made("many-tets", "fitted weights", "tets:ball=6,jitter=0.2,seed=3", bits(14));
    add_made("round-ball", "a border on a sphere", "tets:ball=3,slide=0.5", bits(12));
    add_made("round-rod", "a border on a cylinder", "tets:box=8x3x3,round,slide=0.5", bits(12));
    add_made("round-bend", "a border on a torus", "tets:box=12x4x4,round,bend=120,slide=0.5",
             bits(12));
    add_made("round-exact", "a border near a sphere, lossless", "tets:ball=3,slide=0.5");
    add_made("tet-soup", "random tets with every kind of dirt", "soup:tets=10,seed=4", bits(9));
    add_made("companions", "triangles, lines and attributes beside tets",
             "tets:box=1x1x2,companions,attributes", bits(6));
    add("edge-points", "quadratic tets, and a point that no cell has",
        with_edge_nodes(made("tets:box=1x1x2,jitter=0.2"), 0), bits(9));
    add("edge-points-exact", "quadratic tets, lossless, whose nodes are not all in the middle",
        with_edge_nodes(made("tets:ball=2,jitter=0.1"), 5));
    add("edge-points-order", "quadratic tets of a kept order",
        with_edge_nodes(made("tets:box=1,shuffle"), 3), ordered);
    add_made("tet-order", "a kept order of tets", "tets:box=1,shuffle", ordered);
    return all;
}

}  // namespace ravel::test
