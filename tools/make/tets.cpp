// Tet meshes from cubes: boxes and rods, straight or bent, balls and shells.
#include <algorithm>
#include <array>
#include <cmath>

#include "make/circle.h"
#include "make/families.h"
#include "make/random.h"

namespace ravel::make {
namespace {

using Sizes = std::array<std::uint64_t, 3>;
using Cube = std::array<Index, 8>;  // bit k of the number: the corner is at the far end of axis k

// Six tets around the diagonal 0-7; cubes side by side agree on their faces.       [Kuhn 1960]
void add_kuhn_cube(Builder& builder, const Cube& cube) {
    constexpr int kPaths[6][2] = {{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}};
    for (const auto& path : kPaths)
        builder.add_cell({cube[0], cube[static_cast<std::size_t>(path[0])],
                          cube[static_cast<std::size_t>(path[1])], cube[7]});
}

// One regular tet and four corners; the cut alternates from cube to cube so that faces agree.
void add_five_cube(Builder& builder, const Cube& cube, bool odd) {
    if (odd) {
        builder.add_cell({cube[0], cube[3], cube[5], cube[6]});
        builder.add_cell({cube[1], cube[0], cube[3], cube[5]});
        builder.add_cell({cube[2], cube[0], cube[6], cube[3]});
        builder.add_cell({cube[4], cube[0], cube[5], cube[6]});
        builder.add_cell({cube[7], cube[3], cube[6], cube[5]});
    } else {
        builder.add_cell({cube[1], cube[2], cube[4], cube[7]});
        builder.add_cell({cube[0], cube[1], cube[2], cube[4]});
        builder.add_cell({cube[3], cube[1], cube[7], cube[2]});
        builder.add_cell({cube[5], cube[1], cube[4], cube[7]});
        builder.add_cell({cube[6], cube[2], cube[7], cube[4]});
    }
}

// Puts every tet the same way round (positive volume), as mesh generators do.
void orient(Builder& builder) {
    const auto at = [&](Index point, int k) {
        return builder.coordinates[3 * point + static_cast<std::size_t>(k)];
    };
    for (std::size_t c = 0; c + 4 <= builder.corners.size(); c += 4) {
        double edge[3][3];
        for (std::size_t e = 0; e < 3; ++e)
            for (int k = 0; k < 3; ++k)
                edge[e][k] = at(builder.corners[c + 1 + e], k) - at(builder.corners[c], k);
        const double volume = edge[0][0] * (edge[1][1] * edge[2][2] - edge[1][2] * edge[2][1]) -
                              edge[0][1] * (edge[1][0] * edge[2][2] - edge[1][2] * edge[2][0]) +
                              edge[0][2] * (edge[1][0] * edge[2][1] - edge[1][1] * edge[2][0]);
        if (volume < 0) std::swap(builder.corners[c + 2], builder.corners[c + 3]);
    }
}

// Cubes of the box for which `inside` holds; points that no cube uses are left out.
template <class Inside>
Builder cubes(const Sizes& size, bool five, Inside inside) {
    Builder builder(CellKind::tet);
    const auto number = [&](std::uint64_t x, std::uint64_t y, std::uint64_t z) {
        return (z * (size[1] + 1) + y) * (size[0] + 1) + x;
    };
    std::vector<Index> point(number(size[0], size[1], size[2]) + 1, kNoIndex);
    for (std::uint64_t z = 0; z < size[2]; ++z)
        for (std::uint64_t y = 0; y < size[1]; ++y)
            for (std::uint64_t x = 0; x < size[0]; ++x) {
                if (!inside(x, y, z)) continue;
                Cube cube{};
                for (std::size_t k = 0; k < 8; ++k) {
                    const std::uint64_t cx = x + (k & 1), cy = y + (k >> 1 & 1), cz = z + (k >> 2);
                    Index& known = point[number(cx, cy, cz)];
                    if (known == kNoIndex)
                        known = builder.add_point(static_cast<double>(cx), static_cast<double>(cy),
                                                  static_cast<double>(cz));
                    cube[k] = known;
                }
                if (five)
                    add_five_cube(builder, cube, (x + y + z) % 2 == 1);
                else
                    add_kuhn_cube(builder, cube);
            }
    return builder;
}

// Moves the cube [0, side]^3 onto the ball of radius 1: the longest axis keeps its length.
void round_off(Builder& builder, double side) {
    for (std::size_t i = 0; i < builder.coordinates.size(); i += 3) {
        double p[3], longest = 0, length = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = 2 * builder.coordinates[i + k] / side - 1;
            longest = std::max(longest, std::fabs(p[k]));
            length += p[k] * p[k];
        }
        const double scale = length > 0 ? longest / std::sqrt(length) : 0;
        for (std::size_t k = 0; k < 3; ++k) builder.coordinates[i + k] = p[k] * scale;
    }
}

// Moves points by up to half of `most`; those of the box's own border stay on it.
void slide(Builder& builder, const Sizes& size, double most, Random& random) {
    if (most == 0) return;
    for (std::size_t i = 0; i < builder.coordinates.size(); ++i) {
        double& x = builder.coordinates[i];
        const double by = most * random.symmetric() / 2;
        if (x > 0 && x < static_cast<double>(size[i % 3])) x += by;
    }
}

// Makes a rod of a box: its sections along x become disks, or ellipses.
void round_sections(Builder& builder, const Sizes& size) {
    for (std::size_t i = 0; i < builder.coordinates.size(); i += 3) {
        double p[3]{}, longest = 0, length = 0;
        for (std::size_t k = 1; k < 3; ++k) {
            p[k] = 2 * builder.coordinates[i + k] / static_cast<double>(size[k]) - 1;
            longest = std::max(longest, std::fabs(p[k]));
            length += p[k] * p[k];
        }
        const double scale = length > 0 ? longest / std::sqrt(length) : 0;
        for (std::size_t k = 1; k < 3; ++k)
            builder.coordinates[i + k] = (p[k] * scale + 1) / 2 * static_cast<double>(size[k]);
    }
}

// What runs along x becomes an arc round an axis along z; where y is 0 it keeps its length. What
// reaches beyond the axis folds over.
void bend(Builder& builder, double length, double turns) {
    const double radius_at_0 = length / (turns * 6.283185307179586);
    for (std::size_t i = 0; i < builder.coordinates.size(); i += 3) {
        double* const p = &builder.coordinates[i];
        const CirclePoint at = circle_point(p[0] / length * turns);
        const double radius = radius_at_0 + p[1];
        p[0] = radius * at.sine;
        p[1] = radius * at.cosine;
    }
}

// Turns a box's sections along x, the farther the more.
void twist(Builder& builder, const Sizes& size, double turns) {
    for (std::size_t i = 0; i < builder.coordinates.size(); i += 3) {
        double* const p = &builder.coordinates[i];
        const CirclePoint at = circle_point(p[0] / static_cast<double>(size[0]) * turns);
        const double y = p[1] - static_cast<double>(size[1]) / 2,
                     z = p[2] - static_cast<double>(size[2]) / 2;
        p[1] = y * at.cosine - z * at.sine;
        p[2] = y * at.sine + z * at.cosine;
    }
}

}  // namespace

Builder make_tets(Recipe& recipe) {
    const bool five = recipe.has("five");
    const double jitter = recipe.number("jitter", 0, 0, 1);
    const double slid = recipe.number("slide", 0, 0, 1);
    Random random{recipe.integer("seed", 1, 0, ~std::uint64_t{0})};
    const auto everywhere = [](std::uint64_t, std::uint64_t, std::uint64_t) { return true; };
    Builder builder(CellKind::tet);
    Sizes size{8, 8, 8};
    double scale = 1;
    if (recipe.has("box")) {
        recipe.sizes("box", size.data(), 3, 400);
        const double bent = recipe.number("bend", 0, 0, 350) / 360,
                     twisted = recipe.number("twist", 0, 0, 360) / 360;
        builder = cubes(size, five, everywhere);
        slide(builder, size, slid, random);
        if (recipe.has("round")) round_sections(builder, size);
        if (twisted > 0) twist(builder, size, twisted);
        if (bent > 0) bend(builder, static_cast<double>(size[0]), bent);
    } else if (recipe.has("ball")) {
        recipe.sizes("ball", size.data(), 1, 400);
        size = {size[0], size[0], size[0]};
        builder = cubes(size, five, everywhere);
        slide(builder, size, slid, random);
        scale = 2 / static_cast<double>(size[0]);
        round_off(builder, static_cast<double>(size[0]));
    } else if (recipe.has("shell")) {
        recipe.sizes("shell", size.data(), 1, 400);
        size = {size[0], size[0], size[0]};
        const std::uint64_t wall = std::max<std::uint64_t>(1, size[0] / 4), far = size[0] - wall;
        builder = cubes(size, five, [&](std::uint64_t x, std::uint64_t y, std::uint64_t z) {
            return std::min({x, y, z}) < wall || std::max({x, y, z}) >= far;
        });
        slide(builder, size, slid, random);
        scale = 2 / static_cast<double>(size[0]);
        round_off(builder, static_cast<double>(size[0]));
    } else if (recipe.complaint.empty()) {
        recipe.complaint = "say which: box=, ball= or shell=";
    }
    orient(builder);
    for (double& x : builder.coordinates) x += jitter * scale * random.symmetric() / 2;
    return builder;
}

}  // namespace ravel::make
