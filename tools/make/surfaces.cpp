// Smooth surfaces of quads: sheets, tori, spheres, bands and hills.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "make/circle.h"
#include "make/families.h"
#include "make/random.h"

namespace ravel::make {
namespace {

std::uint64_t seed_of(Recipe& recipe) {
    return recipe.integer("seed", 1, 0, ~std::uint64_t{0});
}

double unit_noise(std::uint64_t a, std::uint64_t b, std::uint64_t seed) {
    return static_cast<double>(hash_of(a, b, seed) >> 11) * 0x1p-53;
}

// Value noise on an integer lattice, smooth between its points.
double smooth_noise(double x, double y, std::uint64_t seed) {
    const double fx = std::floor(x), fy = std::floor(y);
    const auto ix = static_cast<std::uint64_t>(fx), iy = static_cast<std::uint64_t>(fy);
    const double u = x - fx, v = y - fy;
    const double su = u * u * (3 - 2 * u), sv = v * v * (3 - 2 * v);
    const double low = unit_noise(ix, iy, seed) * (1 - su) + unit_noise(ix + 1, iy, seed) * su;
    const double high =
        unit_noise(ix, iy + 1, seed) * (1 - su) + unit_noise(ix + 1, iy + 1, seed) * su;
    return low * (1 - sv) + high * sv;
}

}  // namespace

Builder make_grid(Recipe& recipe) {
    std::uint64_t size[2] = {30, 20};
    recipe.sizes("size", size, 2, 5000);
    const bool triangles = recipe.has("triangles");
    const double jitter = recipe.number("jitter", 0, 0, 1);
    Random random{seed_of(recipe)};
    Builder builder(CellKind::polygon);
    for (std::uint64_t y = 0; y <= size[1]; ++y)
        for (std::uint64_t x = 0; x <= size[0]; ++x) {
            const double dx = jitter * random.symmetric() / 2, dy = jitter * random.symmetric() / 2;
            builder.add_point(static_cast<double>(x) + dx, static_cast<double>(y) + dy, 0);
        }
    const auto point = [&](std::uint64_t x, std::uint64_t y) { return y * (size[0] + 1) + x; };
    for (std::uint64_t y = 0; y < size[1]; ++y)
        for (std::uint64_t x = 0; x < size[0]; ++x) {
            const Index a = point(x, y), b = point(x + 1, y);
            const Index c = point(x + 1, y + 1), d = point(x, y + 1);
            if (triangles) {
                builder.add_cell({a, b, c});
                builder.add_cell({a, c, d});
            } else {
                builder.add_cell({a, b, c, d});
            }
        }
    return builder;
}

Builder make_torus(Recipe& recipe) {
    const std::uint64_t quads = recipe.integer("quads", 1152, 9, 20'000'000);
    std::uint64_t size[2];
    size[1] = std::max<std::uint64_t>(
        3, static_cast<std::uint64_t>(std::sqrt(static_cast<double>(quads) / 2) + 0.5));
    size[0] = std::max<std::uint64_t>(3, quads / size[1]);
    recipe.sizes("size", size, 2, 20000);
    const double bumps = recipe.number("bumps", 0.05, 0, 1);
    const std::uint64_t seed = seed_of(recipe);
    const double phase = unit_noise(1, 2, seed), lobes = static_cast<double>(3 + seed % 5);
    Builder builder(CellKind::polygon);
    for (std::uint64_t i = 0; i < size[0]; ++i) {
        const double around = static_cast<double>(i) / static_cast<double>(size[0]);
        const CirclePoint big = circle_point(around);
        const double radius = 0.35 * (1 + bumps * circle_point(around * lobes + phase).sine);
        for (std::uint64_t j = 0; j < size[1]; ++j) {
            const CirclePoint small =
                circle_point(static_cast<double>(j) / static_cast<double>(size[1]));
            const double reach = 1 + radius * small.cosine;
            builder.add_point(reach * big.cosine, reach * big.sine, radius * small.sine);
        }
    }
    const auto point = [&](std::uint64_t i, std::uint64_t j) {
        return (i % size[0]) * size[1] + j % size[1];
    };
    for (std::uint64_t i = 0; i < size[0]; ++i)
        for (std::uint64_t j = 0; j < size[1]; ++j)
            builder.add_cell({point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
    return builder;
}

Builder make_sphere(Recipe& recipe) {
    const std::uint64_t side = std::uint64_t{1} << recipe.integer("subdivide", 4, 0, 10);
    const double bumps = recipe.number("bumps", 0, 0, 1);
    const std::uint64_t seed = seed_of(recipe);
    Builder builder(CellKind::polygon);
    std::map<std::array<std::uint64_t, 3>, Index> known;
    const auto point = [&](std::array<std::uint64_t, 3> at) {
        const auto [where, is_new] = known.try_emplace(at, builder.point_count());
        if (is_new) {
            double p[3], length = 0;
            for (int k = 0; k < 3; ++k) {
                p[k] = 2 * static_cast<double>(at[static_cast<std::size_t>(k)]) /
                           static_cast<double>(side) -
                       1;
                length += p[k] * p[k];
            }
            const double noise = smooth_noise(4 * p[0] + p[2] + 9, 4 * p[1] - p[2] + 9, seed);
            const double scale = (1 + bumps * noise) / std::sqrt(length);
            builder.add_point(p[0] * scale, p[1] * scale, p[2] * scale);
        }
        return where->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool far : {false, true})
            for (std::uint64_t u = 0; u < side; ++u)
                for (std::uint64_t v = 0; v < side; ++v) {
                    const auto corner = [&](std::uint64_t du, std::uint64_t dv) {
                        std::array<std::uint64_t, 3> at{};
                        at[axis] = far ? side : 0;
                        at[(axis + 1) % 3] = u + du;
                        at[(axis + 2) % 3] = v + dv;
                        return point(at);
                    };
                    if (far)
                        builder.add_cell({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
                    else
                        builder.add_cell({corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)});
                }
    return builder;
}

Builder make_moebius(Recipe& recipe) {
    std::uint64_t size[2] = {40, 4};
    recipe.sizes("size", size, 2, 5000);
    size[0] = std::max<std::uint64_t>(size[0], 3);
    Builder builder(CellKind::polygon);
    for (std::uint64_t i = 0; i < size[0]; ++i) {
        const double around = static_cast<double>(i) / static_cast<double>(size[0]);
        const CirclePoint big = circle_point(around), twist = circle_point(around / 2);
        for (std::uint64_t j = 0; j <= size[1]; ++j) {
            const double across =
                0.8 * (static_cast<double>(j) / static_cast<double>(size[1]) - 0.5);
            const double reach = 1 + across * twist.cosine;
            builder.add_point(reach * big.cosine, reach * big.sine, across * twist.sine);
        }
    }
    const auto point = [&](std::uint64_t i, std::uint64_t j) {
        return i == size[0] ? size[1] - j : i * (size[1] + 1) + j;
    };
    for (std::uint64_t i = 0; i < size[0]; ++i)
        for (std::uint64_t j = 0; j < size[1]; ++j)
            builder.add_cell({point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
    return builder;
}

Builder make_terrain(Recipe& recipe) {
    std::uint64_t size[2] = {100, 100};
    recipe.sizes("size", size, 2, 5000);
    const double height = recipe.number("height", 20, 0, 1e6);
    const std::uint64_t holes = recipe.integer("holes", 0, 0, 1'000'000);
    const std::uint64_t seed = seed_of(recipe);
    Random random{seed};
    Builder builder(CellKind::polygon);
    for (std::uint64_t y = 0; y <= size[1]; ++y)
        for (std::uint64_t x = 0; x <= size[0]; ++x) {
            double z = 0, amplitude = height, frequency = 1.0 / 64;
            for (std::uint64_t octave = 0; octave < 7; ++octave) {
                z += amplitude * smooth_noise(static_cast<double>(x) * frequency,
                                              static_cast<double>(y) * frequency, seed + octave);
                amplitude /= 2, frequency *= 2;
            }
            builder.add_point(static_cast<double>(x), static_cast<double>(y), z);
        }
    const auto point = [&](std::uint64_t x, std::uint64_t y) { return y * (size[0] + 1) + x; };
    for (std::uint64_t y = 0; y < size[1]; ++y)
        for (std::uint64_t x = 0; x < size[0]; ++x) {
            if (holes > 0 && random.one_in(holes)) continue;
            builder.add_cell({point(x, y), point(x + 1, y), point(x + 1, y + 1), point(x, y + 1)});
        }
    return builder;
}

}  // namespace ravel::make
