// The smallest meshes of every kind that ever broke a codec, by name.
#include "make/families.h"

namespace ravel::make {
namespace {

struct Tiny {
    const char* name;
    CellKind kind;
    std::size_t points;
    std::vector<std::vector<Index>> cells;
};

std::vector<Tiny> tiny_meshes() {
    constexpr CellKind polygon = CellKind::polygon, tet = CellKind::tet;
    return {
        {"empty", polygon, 0, {}},
        {"empty-tets", tet, 0, {}},
        {"points", polygon, 5, {}},
        {"tet-points", tet, 5, {}},
        {"triangle", polygon, 3, {{0, 1, 2}}},
        {"quad", polygon, 4, {{0, 1, 2, 3}}},
        {"digon", polygon, 2, {{0, 1}}},
        {"degrees-0-1-2", polygon, 4, {{}, {0}, {1, 2}, {0, 1, 2, 3}}},
        {"two-quads", polygon, 6, {{0, 1, 2, 3}, {1, 4, 5, 2}}},
        {"two-apart", polygon, 8, {{0, 1, 2, 3}, {4, 5, 6, 7}}},
        {"twice", polygon, 4, {{0, 1, 2, 3}, {0, 1, 2, 3}}},
        {"both-sides", polygon, 4, {{0, 1, 2, 3}, {3, 2, 1, 0}}},
        {"flipped", polygon, 6, {{0, 1, 2, 3}, {2, 5, 4, 1}}},
        {"fan-of-three", polygon, 8, {{0, 1, 2, 3}, {1, 0, 4, 5}, {0, 1, 6, 7}}},
        {"pinch", polygon, 7, {{0, 1, 2, 3}, {0, 4, 5, 6}}},
        {"bow-tie", polygon, 4, {{0, 1, 0, 2}, {0, 3, 1}}},
        {"point-cell", polygon, 1, {{0, 0, 0, 0}}},
        {"cube",
         polygon,
         8,
         {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
        {"tet", tet, 4, {{0, 1, 2, 3}}},
        {"two-tets", tet, 5, {{0, 1, 2, 3}, {0, 2, 1, 4}}},
        {"tets-twice", tet, 4, {{0, 1, 2, 3}, {0, 1, 2, 3}}},
        {"tets-both-sides", tet, 4, {{0, 1, 2, 3}, {0, 1, 3, 2}}},
        {"tets-on-one-face", tet, 6, {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 5}}},
        {"tets-on-one-edge", tet, 6, {{0, 1, 2, 3}, {0, 1, 4, 5}}},
        {"tets-on-one-point", tet, 7, {{0, 1, 2, 3}, {0, 4, 5, 6}}},
        {"flat-tet", tet, 4, {{0, 1, 2, 2}, {3, 3, 3, 3}}},
    };
}

}  // namespace

std::vector<std::string> tiny_names() {
    std::vector<std::string> names;
    for (const Tiny& mesh : tiny_meshes()) names.emplace_back(mesh.name);
    return names;
}

Builder make_tiny(Recipe& recipe) {
    for (const Tiny& mesh : tiny_meshes()) {
        if (!recipe.has(mesh.name)) continue;
        Builder builder(mesh.kind);
        for (std::size_t i = 0; i < mesh.points; ++i) {
            const double k = static_cast<double>(i);
            builder.add_point(i % 4 == 1 || i % 4 == 2 ? 1 : 0, i % 4 >= 2 ? 1 : 0, 0.25 * k * k);
        }
        for (const auto& cell : mesh.cells) builder.add_cell(cell);
        return builder;
    }
    if (recipe.complaint.empty()) recipe.complaint = "say which; `ravel make --list` shows them";
    return Builder(CellKind::polygon);
}

}  // namespace ravel::make
