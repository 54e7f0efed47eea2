// Surfaces whose cells are not all quads.
#include <algorithm>

#include "make/circle.h"
#include "make/families.h"
#include "make/random.h"

namespace ravel::make {
namespace {

// Brick pattern: every brick has two half-way corners, so its degree is six.
Builder honeycomb(std::uint64_t width, std::uint64_t height) {
    Builder builder(CellKind::polygon);
    const std::uint64_t columns = 2 * width + 2;
    for (std::uint64_t y = 0; y <= height; ++y)
        for (std::uint64_t x = 0; x < columns; ++x) {
            const double zigzag = (x + y) % 2 == 0 ? 0.0 : 0.28867513459481287;
            builder.add_point(static_cast<double>(x) * 0.5,
                              static_cast<double>(y) * 0.86602540378443865 + zigzag, 0);
        }
    for (std::uint64_t y = 0; y < height; ++y)
        for (std::uint64_t x = 0; x < width; ++x) {
            const Index low = y * columns + 2 * x + (y + 1) % 2, high = low + columns;
            if (2 * x + (y + 1) % 2 + 2 >= columns) continue;
            builder.add_cell({low, low + 1, low + 2, high + 2, high + 1, high});
        }
    return builder;
}

// A sheet where random neighbours in a row are merged (hexagons), quads are cut (triangles) or lose
// a corner to a triangle (pentagons).
Builder mixed(std::uint64_t width, std::uint64_t height, Random& random) {
    Builder builder(CellKind::polygon);
    for (std::uint64_t y = 0; y <= height; ++y)
        for (std::uint64_t x = 0; x <= width; ++x) {
            // One after the other: compilers differ in the order of arguments.
            const double up = 0.3 * random.symmetric(), back = 0.2 * random.symmetric(),
                         right = 0.2 * random.symmetric();
            builder.add_point(static_cast<double>(x) + right, static_cast<double>(y) + back, up);
        }
    const auto point = [&](std::uint64_t x, std::uint64_t y) { return y * (width + 1) + x; };
    for (std::uint64_t y = 0; y < height; ++y)
        for (std::uint64_t x = 0; x < width; ++x) {
            const Index a = point(x, y), b = point(x + 1, y), c = point(x + 1, y + 1),
                        d = point(x, y + 1);
            switch (random.below(8)) {
                case 0:
                    builder.add_cell({a, b, c});
                    builder.add_cell({a, c, d});
                    break;
                case 1:
                    if (x + 1 < width) {
                        builder.add_cell({a, b, point(x + 2, y), point(x + 2, y + 1), c, d});
                        ++x;
                        break;
                    }
                    [[fallthrough]];
                case 2:
                    if (x + 1 < width) {
                        builder.add_cell({a, b, point(x + 2, y + 1), c, d});
                        builder.add_cell({b, point(x + 2, y), point(x + 2, y + 1)});
                        ++x;
                        break;
                    }
                    [[fallthrough]];
                default:
                    builder.add_cell({a, b, c, d});
            }
        }
    return builder;
}

// Rings of quads between an open rim and one n-gon.
Builder cap(std::uint64_t degree) {
    Builder builder(CellKind::polygon);
    constexpr std::uint64_t kRings = 4;
    for (std::uint64_t ring = 0; ring <= kRings; ++ring) {
        const double fraction = static_cast<double>(ring) / (kRings + 1.0);
        const CirclePoint slope = circle_point(fraction / 4);
        for (std::uint64_t i = 0; i < degree; ++i) {
            const CirclePoint around =
                circle_point(static_cast<double>(i) / static_cast<double>(degree));
            builder.add_point(around.cosine * slope.cosine, around.sine * slope.cosine, slope.sine);
        }
    }
    for (std::uint64_t ring = 0; ring < kRings; ++ring)
        for (std::uint64_t i = 0; i < degree; ++i) {
            const Index a = ring * degree + i, b = ring * degree + (i + 1) % degree;
            builder.add_cell({a, b, b + degree, a + degree});
        }
    std::vector<Index> top(degree);
    for (std::uint64_t i = 0; i < degree; ++i) top[i] = kRings * degree + i;
    builder.add_cell(top);
    return builder;
}

}  // namespace

Builder make_polygons(Recipe& recipe) {
    Random random{recipe.integer("seed", 1, 0, ~std::uint64_t{0})};
    std::uint64_t size[2] = {40, 40};
    recipe.sizes("size", size, 2, 5000);
    if (recipe.has("hex")) return honeycomb(size[0], size[1]);
    if (recipe.has("mixed")) return mixed(size[0], size[1], random);
    if (recipe.has("cap")) return cap(std::max<std::uint64_t>(size[0], 3));
    if (recipe.complaint.empty()) recipe.complaint = "say which: hex, mixed or cap";
    return Builder(CellKind::polygon);
}

}  // namespace ravel::make
