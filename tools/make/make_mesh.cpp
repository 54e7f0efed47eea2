#include "make/make_mesh.h"

#include <numeric>

#include "make/families.h"
#include "make/random.h"

namespace ravel::make {
namespace {

struct Family {
    const char* name;
    Builder (*make)(Recipe&);
};
constexpr Family kFamilies[] = {
    {"grid", make_grid},       {"torus", make_torus},     {"sphere", make_sphere},
    {"moebius", make_moebius}, {"terrain", make_terrain}, {"polygons", make_polygons},
    {"tets", make_tets},       {"soup", make_soup},       {"tiny", make_tiny},
};

std::vector<Index> shuffled(std::size_t count, Random& random) {
    std::vector<Index> order(count);
    std::iota(order.begin(), order.end(), Index{0});
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    return order;
}

// Points and cells in random order, polygons from a random corner.
void shuffle(Builder& builder, std::uint64_t seed) {
    Random random{seed ^ 0x5eed};
    const std::vector<Index> new_point = shuffled(builder.point_count(), random);
    std::vector<double> coordinates(builder.coordinates.size());
    for (std::size_t i = 0; i < coordinates.size(); ++i)
        coordinates[3 * new_point[i / 3] + i % 3] = builder.coordinates[i];
    const bool tets = builder.kind == CellKind::tet;
    const std::size_t cells = tets ? builder.corners.size() / 4 : builder.corner_begin.size() - 1;
    Builder result(builder.kind);
    result.coordinates = std::move(coordinates);
    std::vector<Index> cell;
    for (Index c : shuffled(cells, random)) {
        const Index begin = tets ? 4 * c : builder.corner_begin[c];
        const Index degree = tets ? 4 : builder.corner_begin[c + 1] - begin;
        const Index turn = tets || degree == 0 ? 0 : random.below(degree);
        cell.clear();
        for (Index i = 0; i < degree; ++i)
            cell.push_back(new_point[builder.corners[begin + (i + turn) % degree]]);
        result.add_cell(cell);
    }
    builder = std::move(result);
}

// The mesh several times over, side by side: several components.
void repeat(Builder& builder, std::uint64_t copies) {
    const Builder one = builder;
    const Index points = one.point_count();
    for (std::uint64_t k = 1; k < copies; ++k) {
        for (std::size_t i = 0; i < one.coordinates.size(); ++i)
            builder.coordinates.push_back(one.coordinates[i] +
                                          (i % 3 == 0 ? 3.0 * static_cast<double>(k) : 0.0));
        for (Index corner : one.corners) builder.corners.push_back(corner + k * points);
        for (std::size_t c = 1; c < one.corner_begin.size(); ++c)
            builder.corner_begin.push_back(one.corner_begin[c] + k * one.corners.size());
    }
}

// Something of every place and type, smooth and rough, with and without an index.
void add_attributes(Mesh& mesh) {
    const auto wave = [](std::size_t i) { return static_cast<double>(i % 97) * 0.25; };
    mesh.attributes.push_back(make_attribute<float>("temperature", Place::point, Scalar::f32, 1,
                                                    mesh.point_count(), wave));
    mesh.attributes.push_back(
        make_attribute<double>("velocity", Place::point, Scalar::f64, 3, mesh.point_count(), wave));
    mesh.attributes.push_back(make_attribute<std::int32_t>(
        "region", Place::cell, Scalar::i32, 1, mesh.cell_count(),
        [&](std::size_t i) { return i * 4 / (mesh.cell_count() + 1); }));
    const auto cells = static_cast<std::int64_t>(mesh.cell_count());
    Attribute neighbour = make_attribute<std::int64_t>(
        "neighbour", Place::cell, Scalar::i64, 1, mesh.cell_count(), [&](std::size_t i) {
            return i % 11 == 0 ? -1 : (static_cast<std::int64_t>(i) + 5) % cells;
        });
    neighbour.references.push_back({0, Place::cell, 0});
    mesh.attributes.push_back(std::move(neighbour));
    mesh.tag_names.push_back({"region", -1, 0, "first"});
    mesh.tag_names.push_back({"region", -1, 1, "second"});
    if (mesh.kind != CellKind::polygon) return;
    Attribute uv =
        make_attribute<float>("vt", Place::corner, Scalar::f32, 2, mesh.point_count(), wave);
    uv.index = mesh.corners;
    mesh.attributes.push_back(std::move(uv));
}

// The boundary triangles of a tet box as tagged companions would need adjacency; a sample of the
// cells' faces serves the codec as well.
void add_companions(Mesh& mesh) {
    if (mesh.kind != CellKind::tet) return;
    CompanionBlock triangles{5, 3, 0, {}, {}};
    CompanionBlock lines{3, 2, 0, {}, {}};
    for (Index c = 0; c < mesh.cell_count(); c += 7) {
        const auto cell = mesh.cell(c);
        triangles.nodes.insert(triangles.nodes.end(), {cell[0], cell[2], cell[1]});
        lines.nodes.insert(lines.nodes.end(), {cell[0], cell[3]});
        ++triangles.cell_count, ++lines.cell_count;
    }
    mesh.companions.push_back(std::move(triangles));
    mesh.companions.push_back(std::move(lines));
    mesh.attributes.push_back(make_attribute<std::int32_t>("tag", Place::companion, Scalar::i32, 1,
                                                           mesh.companion_count(),
                                                           [](std::size_t i) { return i % 5; }));
}

}  // namespace

Result<Mesh> make_mesh(std::string_view text) {
    Recipe recipe = parse_recipe(text);
    for (const Family& family : kFamilies) {
        if (recipe.family != family.name) continue;
        Builder builder = family.make(recipe);
        const std::uint64_t seed = recipe.integer("seed", 1, 0, ~std::uint64_t{0});
        const std::uint64_t copies = recipe.integer("copies", 1, 1, 1000);
        const bool wants_shuffle = recipe.has("shuffle");
        const Scalar scalar = recipe.has("double") ? Scalar::f64 : Scalar::f32;
        const bool attributes = recipe.has("attributes"), companions = recipe.has("companions");
        if (const std::string verdict = recipe.verdict(); !verdict.empty())
            return Error{Code::bad_option, 0, "recipe " + recipe.text + ": " + verdict};
        if (copies > 1) repeat(builder, copies);
        if (wants_shuffle) shuffle(builder, seed);
        Mesh mesh = builder.take(scalar);
        if (companions) add_companions(mesh);
        if (attributes) add_attributes(mesh);
        return mesh;
    }
    return Error{Code::bad_option, 0,
                 "no recipe family \"" + recipe.family + "\"; `ravel make --list` shows them"};
}

std::vector<RecipeHelp> recipe_help() {
    std::string tiny;
    for (const std::string& name : tiny_names()) tiny += (tiny.empty() ? "" : " ") + name;
    return {
        {"grid:size=30x20[,triangles][,jitter=J]", "a flat sheet of quads, or of triangles"},
        {"torus:quads=10000|size=100x50[,bumps=B]", "a closed torus of about that many quads"},
        {"sphere:subdivide=4[,bumps=B]", "a cube pushed onto a sphere, 6 * 4^N quads"},
        {"moebius:size=40x4", "a one-sided band of quads"},
        {"terrain:size=200x200[,height=H][,holes=N]", "fractal heights, every N-th quad missing"},
        {"polygons:hex[,size=40x40]", "a honeycomb"},
        {"polygons:mixed[,size=40x40]", "quads with triangles, pentagons and hexagons among them"},
        {"polygons:cap[,size=N]", "a dome of quads closed by one N-gon"},
        {"tets:box=20x20x20[,five][,jitter=0.2]", "cubes cut into 6 tets (Kuhn) or 5"},
        {"tets:box=40x8x8,bend=90[,twist=90]", "the same, bent and twisted; in degrees"},
        {"tets:box=40x8x8,round[,bend=90]", "a rod, straight or bent"},
        {"tets:ball=12", "the same cubes pushed onto a ball"},
        {"tets:shell=12", "a ball with a hollow inside"},
        {"tets:...,slide=0.5", "points move, those of the outer border along it"},
        {"soup:polygons=200[,seed=S]", "random polygons with every kind of dirt"},
        {"soup:tets=200[,seed=S]", "random tets with every kind of dirt"},
        {"tiny:NAME", tiny},
        {"...,seed=S", "another mesh of the same family"},
        {"...,copies=N", "N components side by side"},
        {"...,shuffle", "points and cells in random order"},
        {"...,double", "float64 positions (float32 otherwise)"},
        {"...,attributes", "point, cell and corner attributes and names"},
        {"...,companions", "tets: tagged triangles and lines that ride along"},
    };
}

}  // namespace ravel::make
