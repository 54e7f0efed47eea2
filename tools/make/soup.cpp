// Random cells with every kind of dirt at once: repeated and flipped cells, fans of many cells on
// one facet, pinched points, cells that repeat a corner, points that no cell uses, NaN, infinities,
// -0.
#include <algorithm>
#include <limits>

#include "make/families.h"
#include "make/random.h"

namespace ravel::make {
namespace {

double dirty_number(Random& random) {
    switch (random.below(5)) {
        case 0:
            return std::numeric_limits<double>::quiet_NaN();
        case 1:
            return std::numeric_limits<double>::infinity();
        case 2:
            return -std::numeric_limits<double>::infinity();
        case 3:
            return -0.0;
        default:
            return 1e30 * random.symmetric();
    }
}

void add_points(Builder& builder, std::uint64_t count, bool dirty, Random& random) {
    for (std::uint64_t i = 0; i < count; ++i) {
        double p[3];
        for (double& x : p)
            x = dirty && random.one_in(40) ? dirty_number(random) : random.symmetric();
        builder.add_point(p[0], p[1], p[2]);
        if (random.one_in(12)) builder.add_point(p[0], p[1], p[2]);  // the same place twice
    }
}

std::vector<Index> earlier_cell(const Builder& builder, Random& random) {
    const bool tets = builder.kind == CellKind::tet;
    const std::uint64_t cells = tets ? builder.corners.size() / 4 : builder.corner_begin.size() - 1;
    const std::uint64_t c = random.below(cells);
    const std::uint64_t begin = tets ? 4 * c : builder.corner_begin[c];
    const std::uint64_t end = tets ? begin + 4 : builder.corner_begin[c + 1];
    return {builder.corners.begin() + static_cast<std::ptrdiff_t>(begin),
            builder.corners.begin() + static_cast<std::ptrdiff_t>(end)};
}

// A cell over a facet of an earlier one: the start of fans and of proper patches alike.
std::vector<Index> neighbour_cell(const Builder& builder, std::uint64_t degree, Random& random) {
    const std::vector<Index> old = earlier_cell(builder, random);
    std::vector<Index> cell;
    if (builder.kind == CellKind::tet) {
        const std::uint64_t skip = random.below(4);
        for (std::uint64_t i = 0; i < 4; ++i)
            if (i != skip) cell.push_back(old[i]);
        if (random.one_in(2)) std::swap(cell[0], cell[1]);
    } else if (old.size() >= 2) {
        const std::uint64_t side = random.below(old.size());
        cell = {old[(side + 1) % old.size()], old[side]};
        if (random.one_in(3)) std::swap(cell[0], cell[1]);
    }
    while (cell.size() < degree) cell.push_back(random.below(builder.point_count()));
    return cell;
}

void fill(Builder& builder, std::uint64_t count, bool dirty, Random& random) {
    const bool tets = builder.kind == CellKind::tet;
    for (std::uint64_t c = 0; c < count; ++c) {
        std::uint64_t degree = tets ? 4 : 3 + random.below(4);
        if (!tets && dirty && random.one_in(25)) degree = random.below(3);
        if (!tets && random.one_in(60)) degree = 7 + random.below(20);
        std::vector<Index> cell;
        const std::uint64_t choice = c == 0 ? 9 : random.below(10);
        if (choice == 0) {
            cell = earlier_cell(builder, random);  // a duplicate
        } else if (choice == 1) {
            cell = earlier_cell(builder, random);  // turned inside out
            std::reverse(cell.begin(), cell.end());
            if (tets) std::swap(cell[0], cell[1]);
        } else if (choice < 8) {
            cell = neighbour_cell(builder, degree, random);
        } else {
            while (cell.size() < degree) cell.push_back(random.below(builder.point_count()));
        }
        if (dirty && cell.size() > 1 && random.one_in(20)) cell.back() = cell.front();
        builder.add_cell(cell);
    }
}

}  // namespace

Builder make_soup(Recipe& recipe) {
    Random random{recipe.integer("seed", 1, 0, ~std::uint64_t{0}) * 0x2545f4914f6cdd1du + 3};
    const bool dirty = !recipe.has("finite");
    const bool tets = recipe.has("tets");
    if (!tets && !recipe.has("polygons") && recipe.complaint.empty())
        recipe.complaint = "say which: polygons=N or tets=N";
    const std::uint64_t count = recipe.integer(tets ? "tets" : "polygons", 100, 0, 10'000'000);
    Builder builder(tets ? CellKind::tet : CellKind::polygon);
    if (count == 0) return builder;
    // Few points make a knot, many make loose cells; the seed decides.
    add_points(builder, 4 + count / (1 + random.below(6)), dirty, random);
    fill(builder, count, dirty, random);
    return builder;
}

}  // namespace ravel::make
